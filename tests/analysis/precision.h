// What accuracy the analysis reaches against the golden values, measured: the figures of
// docs/precision.md.
#pragma once

#include <string>
#include <vector>

namespace precision {

struct Row {
    std::string what;      ///< the quantity
    std::string reference; ///< what it is compared with
    int values = 0;        ///< how many
    double digits = 0;     ///< -log10 of the worst relative error; 17 when every value is equal
};

std::vector<Row> measure();

/// The page, with this table.
std::string page(const std::vector<Row>& rows);

} // namespace precision
