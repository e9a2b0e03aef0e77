// A table of measurements: one number a row, and the levels it was taken at.
#pragma once

#include "analysis/numerics/decimal.h"
#include "analysis/vote_table.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace analysis::anova {

struct MeasurementColumns {
    std::string response;
    std::vector<std::string> factors;
    std::string subject; ///< whom values are repeated on; "" for independent values
};

/// Columns have one element per row that has a response.
struct Measurements {
    MeasurementColumns names;
    std::vector<numerics::Decimal> response;
    std::vector<Dictionary> levels; ///< one per factor, in order of first appearance
    std::vector<std::vector<std::uint32_t>> factor;
    Dictionary subjects;
    std::vector<std::uint32_t> subject; ///< empty without a subject column
    std::int64_t without_response = 0;  ///< rows with "", NA or n/a there, which were passed over

    std::size_t size() const { return response.size(); }
};

/// Reads a CSV table with a header row; other columns are ignored.
/// Errors: `name:line: ...` for a column that is missing or asked for twice, a row of another
/// length, a response that is no decimal number, an empty level, a table without values, and
/// levels that differ only in blanks around them.
Expected<Measurements> read_measurements(std::string_view text,
                                         const std::string& name,
                                         const MeasurementColumns& columns);

} // namespace analysis::anova
