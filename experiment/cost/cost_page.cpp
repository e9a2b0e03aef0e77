// The order in which a reader asks: what should I take, what do I give up, what else is there.
#include "experiment/cost/cost_page.h"

#include "experiment/cost/choices.h"
#include "experiment/cost/cost_figures.h"
#include "experiment/cost/cost_files.h"
#include "experiment/report/html.h"
#include "experiment/report/numbers.h"
#include "experiment/report/page.css.h"
#include "experiment/report/page.html.h"
#include "experiment/text_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace experiment::cost {

namespace fs = std::filesystem;

using report::escaped;

namespace {

std::string opening(const CostReport& report) {
    return fmt::format(
        "Every setting was prepared alone and drawn in turns with all others, {} rounds under a "
        "moving light, by {}; times of frames are {}. The law of attenuation is \u201c{}\u201d. "
        "Errors are root mean "
        "square differences over the root mean square of the truth, over the object\u2019s pixels: "
        "of thickness, against thickness traced under {} lights that no setting was made for; of "
        "the picture, against the same law with traced thickness; and against the path-traced "
        "picture, at equal brightness or with the coefficients that suit each method best.",
        report.rounds, report.renderer,
        report.timed_by == "processor" ? "processor time of all threads" : "by the clock",
        report.law, report.held_out_lights);
}

std::string wish_in_words(const Wish& wish) {
    return wish.budget_ms ? fmt::format("frames of at most {:.3g} ms, then the least error of {}",
                                        *wish.budget_ms, name_of(wish.error))
                          : fmt::format("an error of {} of at most {}, then the cheapest",
                                        name_of(wish.error), as_percent(*wish.tolerance));
}

std::string measured_in_words(const Choice& choice) {
    if (!choice.measured)
        return "";
    return fmt::format(" Predicted by the sweep: {}; measured at the study\u2019s size: {}{}.",
                       as_percent(choice.predicted), as_percent(*choice.measured),
                       std::abs(choice.predicted - *choice.measured) <= 0.2 * *choice.measured
                           ? ", within 20 % of each other"
                           : ", more than 20 % apart");
}

std::string cheapest_cell(const SceneCost& scene, const Rung& rung) {
    if (!rung.row)
        return "none";
    const auto& row = scene.rows[*rung.row];
    return fmt::format("{} ({:.3g} ms, {} B)", full_name(row), row.frame_ms.median,
                       row.bytes_per_vertex);
}

/// Cells of the table of the cheapest settings: the head, then a row for each error.
std::vector<std::vector<std::string>> ladder_cells(const SceneCost& scene, std::size_t light) {
    std::vector<std::vector<std::string>> cells{{"error at most"}};
    for (const auto kind : all_errors) {
        if (!has_error(scene, light, kind))
            continue;
        cells.front().emplace_back(name_of(kind));
        const auto rungs = ladder(scene, light, kind);
        for (std::size_t i = 0; i < rungs.size(); ++i) {
            if (cells.size() == i + 1)
                cells.push_back({as_percent(rungs[i].error)});
            cells[i + 1].push_back(cheapest_cell(scene, rungs[i]));
        }
    }
    return cells;
}

std::string shown(double error) {
    return std::isnan(error) ? std::string(report::no_number) : as_percent(error);
}

/// Cells of the table of settings: the head, then a row for each of `rows`.
std::vector<std::vector<std::string>> setting_cells(const SceneCost& scene,
                                                    const std::vector<std::size_t>& rows) {
    std::vector<std::vector<std::string>> cells{{"setting", "beforehand, s", "bytes a vertex",
                                                 "vertices", "ms a frame (quartiles)", "to Phong",
                                                 "thickness"}};
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        for (const auto kind : {ErrorKind::Law, ErrorKind::Reference, ErrorKind::Fitted})
            if (has_error(scene, i, kind))
                cells.front().push_back(
                    fmt::format("{}, {}", scene.lights[i].label, name_of(kind)));
    for (const auto r : rows) {
        const auto& row = scene.rows[r];
        std::vector<std::string> line{
            full_name(row),
            row.precompute_seconds ? fmt::format("{:.2g}", *row.precompute_seconds)
                                   : std::string(report::no_number),
            std::to_string(row.bytes_per_vertex),
            std::to_string(row.vertices),
            fmt::format("{:.3g} ({:.3g}\u2013{:.3g})", row.frame_ms.median, row.frame_ms.lower,
                        row.frame_ms.upper),
            fmt::format("{:.3g}", row.to_bare.median),
            shown(error_of(row, 0, ErrorKind::Thickness))};
        for (std::size_t i = 0; i < scene.lights.size(); ++i)
            for (const auto kind : {ErrorKind::Law, ErrorKind::Reference, ErrorKind::Fitted})
                if (has_error(scene, i, kind))
                    line.push_back(shown(error_of(row, i, kind)));
        cells.push_back(std::move(line));
    }
    return cells;
}

std::vector<std::size_t> all_rows(const SceneCost& scene) {
    std::vector<std::size_t> rows(scene.rows.size());
    for (std::size_t r = 0; r < rows.size(); ++r)
        rows[r] = r;
    return rows;
}

std::vector<std::size_t> preset_rows(const SceneCost& scene) {
    std::vector<std::size_t> rows;
    for (std::size_t r = 0; r < scene.rows.size(); ++r)
        if (scene.rows[r].setting.empty())
            rows.push_back(r);
    return rows;
}

std::string as_html(const std::vector<std::vector<std::string>>& cells) {
    std::string head, rows;
    for (const auto& line : cells) {
        std::vector<std::string> safe;
        for (const auto& cell : line)
            safe.push_back(escaped(cell));
        (head.empty() ? head : rows) +=
            head.empty() ? report::html_head(safe) : report::html_row(safe);
    }
    return report::html_table("costs", head, rows);
}

std::string as_markdown(const std::vector<std::vector<std::string>>& cells) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (const auto& cell : cells[i])
            text += "| " + cell + " ";
        text += "|\n";
        if (i == 0) {
            for (std::size_t k = 0; k < cells[i].size(); ++k)
                text += "|---";
            text += "|\n";
        }
    }
    return text;
}

/// The method's own choices under a light, reckoned and measured.
std::vector<std::string> decisions(const SceneCost& scene, std::size_t light) {
    std::vector<std::string> all;
    for (const auto& row : scene.rows) {
        const auto& errors = row.lights[light];
        if (errors.predicted_change && errors.measured_change)
            all.push_back(fmt::format("{}: {} (reckoned {:.2g}, measured {:.2g})", full_name(row),
                                      errors.decision, *errors.predicted_change,
                                      *errors.measured_change));
    }
    return all;
}

void add_light(report::Body& body,
               const SceneCost& scene,
               std::size_t i,
               const std::vector<report::Figure>& figures) {
    const auto& light = scene.lights[i];
    body.subheading(scene.label + ", " + light.label);
    if (light.choice) {
        body.paragraph(fmt::format("Chosen: {}. Why: {}.{}",
                                   full_name(scene.rows[light.choice->row]), light.choice->why,
                                   measured_in_words(*light.choice)));
        body.paragraph("Left out: " + light.choice->left_out + ".");
    } else {
        body.paragraph("Nothing was chosen: the error that was asked for is not known here.");
    }
    for (const auto& decision : decisions(scene, i))
        body.paragraph("Chosen by the method itself: " + decision + ".", "note");
    if (const auto cells = ladder_cells(scene, i); cells.size() > 1)
        body.table("The cheapest setting below each error, " + light.label +
                       ". Of settings whose times cannot be told apart, the one with the fewest "
                       "bytes.",
                   as_html(cells));
    const auto figure =
        std::ranges::find(figures, figure_name(scene, light), &report::Figure::name);
    if (figure != figures.end())
        body.figure(*figure);
}

} // namespace

void add_cost(report::Body& body,
              const CostReport& report,
              const std::vector<report::Figure>& figures) {
    body.heading("Speed against error");
    body.paragraph(opening(report));
    body.paragraph("Asked for: " + wish_in_words(report.wish) + ".");
    for (const auto& scene : report.scenes) {
        for (std::size_t i = 0; i < scene.lights.size(); ++i)
            add_light(body, scene, i, figures);
        for (const auto& remark : scene.remarks)
            body.paragraph(remark, "note");
        body.add("<details><summary>All settings of " + escaped(scene.label) + "</summary>\n");
        body.table(fmt::format("{}: {} vertices, {} triangles.", scene.label, scene.vertices,
                               scene.triangles),
                   as_html(setting_cells(scene, all_rows(scene))));
        body.add("</details>\n");
    }
}

std::string cost_text(const CostReport& report) {
    auto text = fmt::format("{}\n\nAsked for: {}.\n", opening(report), wish_in_words(report.wish));
    for (const auto& scene : report.scenes) {
        text += fmt::format("\n## {}: {} vertices, {} triangles\n\n", scene.label, scene.vertices,
                            scene.triangles);
        text += as_markdown(setting_cells(scene, preset_rows(scene)));
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            const auto& light = scene.lights[i];
            text += fmt::format("\n### {}, {}\n\n", scene.label, light.label);
            if (light.choice)
                text += fmt::format("Chosen: **{}**. Why: {}.{}\n\nLeft out: {}.\n\n",
                                    full_name(scene.rows[light.choice->row]), light.choice->why,
                                    measured_in_words(*light.choice), light.choice->left_out);
            for (const auto& decision : decisions(scene, i))
                text += fmt::format("Chosen by the method itself: {}.\n\n", decision);
            if (light.noise_floor)
                text += fmt::format("Path-traced: {}; noise floor {}.\n\n", light.reference,
                                    as_percent(*light.noise_floor));
            if (const auto cells = ladder_cells(scene, i); cells.size() > 1)
                text += as_markdown(cells);
        }
        for (const auto& remark : scene.remarks)
            text += "\n" + remark + "\n";
    }
    return text;
}

tl::expected<fs::path, std::string> write_cost(const fs::path& folder, const CostReport& report) {
    // What was measured is safe before anything is drawn of it.
    for (const auto& [name, bytes] :
         {std::pair{"cost.json", cost_json(report)}, std::pair{"cost.csv", cost_csv(report)}})
        if (auto written = write_text_file(folder / name, bytes); !written)
            return tl::unexpected(written.error());
    const auto figures = draw_cost_figures(report);
    if (!figures)
        return tl::unexpected(fmt::format(
            "{}; the measurements are in {}: when that is mended, `pairlight cost` draws them "
            "again with --from",
            figures.error(), (folder / "cost.json").string()));
    const report::ReportContents nobody_voted;
    report::Body body(nobody_voted);
    body.add(fmt::format("<h1>{}</h1>\n<p class=\"facts\">{} \u00b7 {}</p>\n",
                         escaped(report.subject), escaped(report.written_on),
                         escaped(report.program)));
    add_cost(body, report, *figures);
    std::vector<std::pair<fs::path, std::string>> files{
        {"cost.html", report::filled(report::page_html, {{"style", std::string(report::page_css)},
                                                         {"program", escaped(report.program)},
                                                         {"window_title", escaped(report.subject)},
                                                         {"body", body.markup()}})}};
    for (const auto& figure : *figures) {
        files.emplace_back(fs::path("figures") / (figure.name + ".svg"), figure.svg);
        files.emplace_back(fs::path("figures") / (figure.name + ".pdf"), figure.pdf);
    }
    for (const auto& [name, bytes] : files)
        if (auto written = write_text_file(folder / name, bytes); !written)
            return tl::unexpected(written.error());
    return folder / "cost.html";
}

} // namespace experiment::cost
