#include "analysis/anova/table_design.h"

#include <algorithm>
#include <map>

namespace analysis::anova {

namespace {

std::vector<std::size_t> levels_of_row(const Measurements& table, std::size_t row) {
    std::vector<std::size_t> levels;
    for (const auto& codes : table.factor)
        levels.push_back(codes[row]);
    return levels;
}

bool varies_within_subjects(const Measurements& table, std::size_t factor) {
    std::vector<std::int64_t> seen(table.subjects.size(), -1);
    for (std::size_t row = 0; row < table.size(); ++row) {
        auto& level = seen[table.subject[row]];
        if (level >= 0 && level != table.factor[factor][row])
            return true;
        level = table.factor[factor][row];
    }
    return false;
}

struct Sum {
    long double sum = 0;
    int count = 0;
};

// Codes of between levels that only dropped subjects had would leave gaps.
std::vector<std::vector<std::size_t>> close_gaps(RepeatedDesign& design) {
    std::vector<std::vector<std::size_t>> kept;
    for (std::size_t f = 0; f < design.between.size(); ++f) {
        std::map<std::size_t, std::size_t> codes;
        for (const auto& group : design.groups)
            codes.emplace(group[f], 0);
        auto& levels = kept.emplace_back();
        for (auto& [old, code] : codes) {
            code = levels.size();
            levels.push_back(old);
        }
        for (auto& group : design.groups)
            group[f] = codes[group[f]];
        design.between[f].levels = codes.size();
    }
    return kept;
}

} // namespace

long double CellValues::mean() const {
    long double sum = 0;
    for (const auto value : values)
        sum += value;
    return sum / static_cast<long double>(values.size());
}

std::vector<CellValues> cells_of(const Measurements& table, const numerics::Shifted& shifted) {
    std::map<std::vector<std::size_t>, std::vector<long double>> cells;
    for (std::size_t row = 0; row < table.size(); ++row)
        cells[levels_of_row(table, row)].push_back(shifted.residues[row]);
    std::vector<CellValues> result;
    for (auto& [levels, values] : cells)
        result.push_back({{levels, values.size()}, std::move(values)});
    return result;
}

std::string cell_name(const Measurements& table,
                      const std::vector<std::size_t>& factors,
                      const std::vector<std::size_t>& levels) {
    std::string name;
    for (std::size_t k = 0; k < factors.size(); ++k)
        name += (name.empty() ? "" : " x ") + table.levels[factors[k]].name(levels[k]);
    return name;
}

std::vector<std::string>
empty_cells(const Measurements& table, const std::vector<CellValues>& cells, std::size_t limit) {
    std::vector<std::size_t> factors, levels(table.levels.size(), 0);
    for (std::size_t f = 0; f < table.levels.size(); ++f)
        factors.push_back(f);
    std::vector<std::string> names;
    auto next = cells.begin(); // cells are sorted, and so are the combinations below
    while (names.size() < limit) {
        if (next != cells.end() && next->cell.levels == levels)
            ++next;
        else
            names.push_back(cell_name(table, factors, levels));
        std::size_t f = factors.size();
        while (f > 0 && ++levels[f - 1] == table.levels[f - 1].size())
            levels[--f] = 0;
        if (f == 0)
            break;
    }
    return names;
}

SubjectCells subject_cells(const Measurements& table, const numerics::Shifted& shifted) {
    SubjectCells result;
    std::size_t cells = 1;
    for (std::size_t f = 0; f < table.levels.size(); ++f) {
        const Factor factor{table.names.factors[f], table.levels[f].size()};
        const bool within = varies_within_subjects(table, f);
        (within ? result.within : result.between).push_back(f);
        (within ? result.design.within : result.design.between).push_back(factor);
        cells *= within ? factor.levels : 1;
    }
    if (cells > table.size()) { // fewer values than cells: every subject has holes
        result.left_out = table.subjects.names();
        return result;
    }
    std::map<std::uint32_t, std::vector<Sum>> sums;
    std::map<std::uint32_t, std::vector<std::size_t>> group;
    for (std::size_t row = 0; row < table.size(); ++row) {
        std::size_t cell = 0;
        for (const auto f : result.within)
            cell = cell * table.levels[f].size() + table.factor[f][row];
        auto& own = sums[table.subject[row]];
        own.resize(cells);
        own[cell].sum += shifted.residues[row];
        result.replicated = ++own[cell].count > 1 || result.replicated;
        auto& levels = group[table.subject[row]];
        levels.clear();
        for (const auto f : result.between)
            levels.push_back(table.factor[f][row]);
    }
    for (const auto& [subject, own] : sums) {
        if (std::any_of(own.begin(), own.end(), [](const Sum& sum) { return sum.count == 0; })) {
            result.left_out.push_back(table.subjects.name(subject));
            continue;
        }
        result.subjects.push_back(subject);
        result.design.groups.push_back(group[subject]);
        for (const auto& sum : own)
            result.values.push_back(sum.sum / static_cast<long double>(sum.count));
    }
    result.between_levels = close_gaps(result.design);
    return result;
}

} // namespace analysis::anova
