// Rows end with a line feed; fields with commas, quotes or line ends are quoted.
#include "experiment/tables.h"

#include "analysis/csv.h"
#include "experiment/store/words.h"

#include <fmt/core.h>

namespace experiment {

std::string csv_row(const std::vector<std::string>& fields) {
    std::string row;
    for (std::size_t i = 0; i < fields.size(); ++i)
        row += (i == 0 ? "" : ",") + analysis::csv_field(fields[i]);
    return row + '\n';
}

std::string schedule_csv(const protocols::Schedule& schedule) {
    std::string table = "trial,phase,scene,variant,left,right\n";
    for (const auto& planned : schedule.trials)
        table +=
            csv_row({fmt::format("{}", planned.number), std::string(store::word_of(planned.phase)),
                     planned.trial.scene.value, planned.trial.variant.value,
                     planned.trial.left.value, planned.trial.right.value});
    return table;
}

} // namespace experiment
