#include "analysis/consistency/screening_json.h"

#include <nlohmann/json.hpp>

namespace analysis::consistency {

std::string screening_json(std::span<const ObserverScreening> observers) {
    using Json = nlohmann::ordered_json;
    Json rows = Json::array();
    for (const auto& o : observers) { // NaN becomes null in the text
        Json bt500{{"P", o.above},
                   {"Q", o.below},
                   {"presentations", o.presentations},
                   {"rejects", o.rejected_by_bt500}};
        if (o.presentations == 0)
            bt500["reason"] = "the observer did not answer every scene completely";
        Json row{{"observer", o.observer},
                 {"flags", o.flags},
                 {"bt500", bt500},
                 {"pearson_with_the_others", o.pearson},
                 {"spearman_with_the_others", o.spearman},
                 {"log10_likelihood_per_vote", o.log10_likelihood_per_vote},
                 {"likelihood_distance", o.likelihood_distance},
                 {"left_out_z", o.left_out_z},
                 {"largest_shift_jod_when_left_out", o.largest_shift},
                 {"circular_triads", o.triads},
                 {"rounds", o.rounds},
                 {"p_so_few_triads_by_guessing", o.triads_p},
                 {"left_choices", o.left},
                 {"left_answers", o.answers},
                 {"left_z", o.side_z},
                 {"left_p_exact_two_sided", o.side_p},
                 {"longest_run_of_one_side", o.longest_run},
                 {"p_longest_run", o.longest_run_p}};
        if (o.timed > 0) {
            row["median_ms"] = o.median_ms;
            row["answers_faster_than_300_ms"] = o.fast;
            row["answers_slower_than_60_s"] = o.slow;
        }
        rows.push_back(row);
    }
    return rows.dump();
}

} // namespace analysis::consistency
