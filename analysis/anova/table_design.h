// How the values of a table fall into cells: of independent values, or of subjects measured again
// and again.
#pragma once

#include "analysis/anova/measurements.h"
#include "analysis/anova/repeated.h"
#include "analysis/numerics/shifted.h"

#include <string>
#include <vector>

namespace analysis::anova {

/// Values of one combination of levels, about a common origin.
struct CellValues {
    Cell cell;
    std::vector<long double> values;

    long double mean() const;
};

/// Cells that have values, in the order of their levels.
std::vector<CellValues> cells_of(const Measurements& table, const numerics::Shifted& shifted);

/// "SHSS, Dragon": what a combination of levels is called.
std::string cell_name(const Measurements& table,
                      const std::vector<std::size_t>& factors,
                      const std::vector<std::size_t>& levels);

/// Combinations of levels without values, by name; at most `limit` of them.
std::vector<std::string>
empty_cells(const Measurements& table, const std::vector<CellValues>& cells, std::size_t limit);

/// Subjects with a value in every within cell, each averaged over its replicates.
struct SubjectCells {
    RepeatedDesign design;
    std::vector<std::size_t> between, within; ///< factors of the table, by index
    /// The table's level of each of the design's: some go with the subjects that are left out.
    std::vector<std::vector<std::size_t>> between_levels;
    std::vector<std::uint32_t> subjects; ///< codes of those kept
    std::vector<long double> values;     ///< subjects x within cells
    std::vector<std::string> left_out;   ///< subjects with an empty cell
    bool replicated = false;             ///< some cell had more than one value
};

SubjectCells subject_cells(const Measurements& table, const numerics::Shifted& shifted);

} // namespace analysis::anova
