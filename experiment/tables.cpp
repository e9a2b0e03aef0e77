// Rows end with a line feed; fields with commas, quotes or line ends are quoted.
#include "experiment/tables.h"

#include <fmt/core.h>

namespace experiment {

namespace {

std::string_view phase_name(protocols::Phase phase) {
    switch (phase) {
    case protocols::Phase::Training:
        return "training";
    case protocols::Phase::WarmUp:
        return "warmup";
    case protocols::Phase::Main:
        return "main";
    }
    return "";
}

} // namespace

std::string csv_field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos)
        return std::string(text);
    std::string quoted = "\"";
    for (const char character : text) {
        if (character == '"')
            quoted += '"';
        quoted += character;
    }
    return quoted + '"';
}

std::string csv_row(const std::vector<std::string>& fields) {
    std::string row;
    for (std::size_t i = 0; i < fields.size(); ++i)
        row += (i == 0 ? "" : ",") + csv_field(fields[i]);
    return row + '\n';
}

std::string schedule_csv(const protocols::Schedule& schedule) {
    std::string table = "trial,phase,scene,variant,left,right\n";
    for (const auto& planned : schedule.trials)
        table += csv_row({fmt::format("{}", planned.number), std::string(phase_name(planned.phase)),
                          planned.trial.scene.value, planned.trial.variant.value,
                          planned.trial.left.value, planned.trial.right.value});
    return table;
}

} // namespace experiment
