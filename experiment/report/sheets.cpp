// Contact sheet, brightness, sittings and facts.
#include "experiment/report/sheets.h"

#include "experiment/report/html.h"
#include "experiment/report/numbers.h"

#include <fmt/format.h>

#include <algorithm>

namespace experiment::report {

namespace {

using protocols::ConditionId;
using protocols::Picture;

std::string shown_name(const ReportContents& contents, const Picture& picture) {
    const auto scene = labelled(contents.labels.scenes, picture.scene.value);
    if (picture.variant.value.empty())
        return scene;
    return scene + ", " + labelled(contents.labels.variants, picture.variant.value);
}

std::string shown_condition(const ReportContents& contents, const ConditionId& condition) {
    return labelled(contents.labels.conditions, condition.value);
}

bool shown_alike(const Picture& a, const Picture& b) {
    return a.scene == b.scene && a.variant == b.variant;
}

// Conditions in the order in which they first come; scenes with variants likewise.
template <class Row>
std::vector<ConditionId> conditions_of(const std::vector<Row>& rows) {
    std::vector<ConditionId> conditions;
    for (const auto& row : rows)
        if (std::ranges::find(conditions, row.picture.condition) == conditions.end())
            conditions.push_back(row.picture.condition);
    return conditions;
}

template <class Row>
std::vector<Picture> scenes_of(const std::vector<Row>& rows) {
    std::vector<Picture> scenes;
    for (const auto& row : rows)
        if (std::ranges::none_of(scenes,
                                 [&](const auto& seen) { return shown_alike(seen, row.picture); }))
            scenes.push_back(row.picture);
    return scenes;
}

template <class Row>
const Row*
find_row(const std::vector<Row>& rows, const Picture& scene, const ConditionId& condition) {
    const auto found = std::ranges::find_if(rows, [&](const Row& row) {
        return shown_alike(row.picture, scene) && row.picture.condition == condition;
    });
    return found == rows.end() ? nullptr : &*found;
}

// `before` are the heads left of the conditions'.
std::string condition_heads(const ReportContents& contents,
                            std::vector<std::string> before,
                            const std::vector<ConditionId>& conditions) {
    for (const auto& condition : conditions)
        before.push_back(escaped(shown_condition(contents, condition)));
    return html_head(before);
}

std::string picture_cell(const ReportContents& contents, const Thumbnail& thumbnail) {
    const auto& picture = thumbnail.picture;
    return fmt::format("<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\">",
                       data_address("image/png", thumbnail.png), thumbnail.width, thumbnail.height,
                       escaped(shown_name(contents, picture) + ", drawn by " +
                               shown_condition(contents, picture.condition)));
}

std::string gain_cell(const BrightnessRow& row) {
    std::string cell = "\u00d7 " + significant(row.gain, 3);
    if (row.clipped_share > 0)
        cell += fmt::format("<small>{} % clipped</small>", significant(100 * row.clipped_share, 1));
    return cell;
}

} // namespace

std::string contact_sheet(const ReportContents& contents) {
    const auto conditions = conditions_of(contents.thumbnails);
    std::string rows;
    for (const auto& scene : scenes_of(contents.thumbnails)) {
        std::vector<std::string> cells{escaped(shown_name(contents, scene))};
        for (const auto& condition : conditions) {
            const auto* thumbnail = find_row(contents.thumbnails, scene, condition);
            cells.push_back(thumbnail == nullptr ? "missing" : picture_cell(contents, *thumbnail));
        }
        rows += html_row(cells);
    }
    return html_table("sheet", condition_heads(contents, {"Scene"}, conditions), rows);
}

std::string brightness_table(const ReportContents& contents) {
    const auto conditions = conditions_of(contents.brightness);
    std::string rows;
    for (const auto& scene : scenes_of(contents.brightness)) {
        std::vector<std::string> cells{escaped(shown_name(contents, scene)), ""};
        for (const auto& condition : conditions) {
            const auto* row = find_row(contents.brightness, scene, condition);
            cells.push_back(row == nullptr ? no_number : gain_cell(*row));
            if (row != nullptr)
                cells[1] = significant(row->target, 4); // the same for all that were matched
        }
        rows += html_row(cells);
    }
    return html_table("numbers", condition_heads(contents, {"Scene", "Target"}, conditions), rows);
}

std::string sitting_table(const std::vector<SittingRow>& sittings) {
    std::string rows;
    for (const auto& sitting : sittings)
        rows += html_row(
            {escaped(sitting.observer), std::to_string(sitting.session),
             "<span class=\"date\">" + escaped(sitting.date) + "</span>",
             sitting.duration.empty() ? "not finished" : escaped(sitting.duration),
             std::to_string(sitting.votes),
             escaped(sitting.timing_grade) +
                 (sitting.late_frames.empty() ? "" : "<br>late: " + escaped(sitting.late_frames)),
             "<code>" + escaped(sitting.order_seed) + "<br>" + escaped(sitting.sides_seed) +
                 "</code>",
             sitting.simulated ? "simulated" : "a person"});
    return html_table("sittings",
                      html_head({"Observer", "Session", "Date", "Duration", "Votes", "Timing",
                                 "Seeds: order, sides", "Given by"}),
                      rows);
}

std::string fact_list(const std::vector<Fact>& facts) {
    std::string html = "<dl>\n";
    for (const auto& fact : facts)
        html += fmt::format("<dt>{}</dt>{}\n", escaped(fact.name),
                            fact.value ? "<dd>" + escaped(*fact.value) + "</dd>"
                                       : "<dd class=\"absent\">not recorded</dd>");
    return html + "</dl>\n";
}

} // namespace experiment::report
