#include "analysis/anova/measurements.h"

#include "analysis/csv.h"
#include "analysis/twin_names.h"
#include "analysis/utf8.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace analysis::anova {

namespace {

class Reader {
  public:
    explicit Reader(Measurements& table) : table_(table) {
        table_.levels.resize(table_.names.factors.size());
        table_.factor.resize(table_.names.factors.size());
    }

    std::string operator()(std::int64_t, std::span<const std::string_view> fields) {
        if (width_ == 0)
            return header(fields);
        if (fields.size() != width_)
            return fmt::format("{} fields, expected {} as in the header", fields.size(), width_);
        return row(fields);
    }

    bool has_header() const { return width_ > 0; }

  private:
    std::string header(std::span<const std::string_view> fields) {
        width_ = fields.size();
        auto wrong = find(fields, table_.names.response, response_);
        for (const auto& factor : table_.names.factors)
            if (wrong.empty())
                wrong = find(fields, factor, factors_.emplace_back());
        if (wrong.empty() && !table_.names.subject.empty())
            wrong = find(fields, table_.names.subject, subject_);
        return wrong;
    }

    std::string
    find(std::span<const std::string_view> fields, const std::string& column, std::size_t& place) {
        const auto found = std::find(fields.begin(), fields.end(), column);
        if (found == fields.end())
            return fmt::format("no column '{}', the header has {}", column,
                               fmt::join(fields, ", "));
        if (std::find(found + 1, fields.end(), column) != fields.end())
            return fmt::format("column '{}' stands twice, expected each name once", column);
        place = static_cast<std::size_t>(found - fields.begin());
        return {};
    }

    std::string row(std::span<const std::string_view> fields) {
        const auto text = fields[response_];
        if (text.empty() || text == "NA" || text == "n/a") {
            ++table_.without_response;
            return {};
        }
        const auto value = numerics::parse_decimal(text);
        if (!value)
            return fmt::format("{}: {}", table_.names.response, value.error());
        table_.response.push_back(*value);
        for (std::size_t f = 0; f < factors_.size(); ++f) {
            if (fields[factors_[f]].empty())
                return fmt::format("{} is empty, expected a level", table_.names.factors[f]);
            table_.factor[f].push_back(table_.levels[f].code(fields[factors_[f]]));
        }
        if (table_.names.subject.empty())
            return {};
        if (fields[subject_].empty())
            return fmt::format("{} is empty, expected a name", table_.names.subject);
        table_.subject.push_back(table_.subjects.code(fields[subject_]));
        return {};
    }

    Measurements& table_;
    std::size_t width_ = 0, response_ = 0, subject_ = 0;
    std::vector<std::size_t> factors_;
};

std::string asked_twice(const MeasurementColumns& columns) {
    auto all = columns.factors;
    all.push_back(columns.response);
    if (!columns.subject.empty())
        all.push_back(columns.subject);
    std::sort(all.begin(), all.end());
    const auto twice = std::adjacent_find(all.begin(), all.end());
    return twice == all.end() ? "" : *twice;
}

std::string twin_levels(const Measurements& table) {
    for (std::size_t f = 0; f < table.levels.size(); ++f)
        if (auto twins = twins_but_for_blanks(table.levels[f], table.names.factors[f]);
            !twins.empty())
            return twins;
    return twins_but_for_blanks(table.subjects, table.names.subject);
}

} // namespace

Expected<Measurements> read_measurements(std::string_view text,
                                         const std::string& name,
                                         const MeasurementColumns& columns) {
    if (const auto twice = asked_twice(columns); !twice.empty())
        return tl::unexpected(fmt::format("column '{}' is asked for twice, expected different "
                                          "columns as response, factors and within",
                                          twice));
    if (auto fault = utf8_fault(text, name); !fault.empty())
        return tl::unexpected(std::move(fault));
    Measurements table;
    table.names = columns;
    Reader reader(table);
    const auto records = read_csv(text, name, std::ref(reader));
    if (!records)
        return tl::unexpected(records.error());
    if (!reader.has_header())
        return tl::unexpected(fmt::format("{}:1: the file is empty, expected a header row", name));
    if (table.size() == 0)
        return tl::unexpected(
            fmt::format("{}:1: no values of '{}' below the header", name, columns.response));
    if (auto twins = twin_levels(table); !twins.empty())
        return tl::unexpected(fmt::format("{}: {}", name, twins));
    return table;
}

} // namespace analysis::anova
