// The table of docs/precision-hard-cases.md.
#include "tests/hard_cases/hard_cases.h"

#include <fmt/format.h>

namespace hard_cases {

std::vector<Case> measure() {
    std::vector<Case> cases;
    add_harmonics(cases);
    add_fits(cases);
    add_rays(cases);
    add_transport(cases);
    add_statistics(cases);
    return cases;
}

std::string page(const std::vector<Case>& cases) {
    std::string text = R"(# Hard cases

Where arithmetic is in danger: what must come out, what does, and how many digits agree. Of the values that were compared
in a case, the worst is shown. Digits are -log10 of its error, relative unless the case says "of" what, rounded down; 17
means that all values are equal. A double has 15.95 digits, a float 7.2: rays are traced in float, in coordinates of the
model's own size. "64 bits" and "50 digits" are precisions that the program itself never uses.

This page is written by a program: `cmake --build --preset release --target hard_cases_report`, then run
`build/release/tests/hard_cases/hard_cases_report docs/precision-hard-cases.md`. A test measures all of it again, and fails
where fewer digits come out than the last column holds, or than the page claims: but for a last bit, which processors of
other makers may round otherwise.

| area | case | against | values | expected | got | digits | held |
|---|---|---|---|---|---|---|---|
)";
    for (const auto& c : cases)
        text += fmt::format("| {} | {} | {} | {} | {:.17g} | {:.17g} | {:.1f} | {:.1f} |\n", c.area,
                            c.what, c.against, c.values, c.expected, c.got,
                            std::floor(10 * c.digits) / 10, std::floor(10 * c.floor) / 10);
    return text;
}

} // namespace hard_cases
