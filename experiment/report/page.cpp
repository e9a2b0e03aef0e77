// Sections of the page, in the order in which a reader asks: what came out, how sure is it, what
// was shown, under which circumstances.
#include "experiment/report/page.h"

#include "experiment/cost/cost_figures.h"
#include "experiment/cost/cost_page.h"
#include "experiment/report/body.h"
#include "experiment/report/html.h"
#include "experiment/report/numbers.h"
#include "experiment/report/page.css.h"
#include "experiment/report/page.html.h"
#include "experiment/report/plain_words.h"
#include "experiment/report/scale_sections.h"
#include "experiment/report/shares.h"
#include "experiment/report/sheets.h"
#include "experiment/report/simulated.h"
#include "experiment/report/tables.h"
#include "experiment/store/screened.h"
#include "experiment/text_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace experiment::report {

namespace {

std::string counted(std::int64_t count, const std::string& one) {
    return fmt::format("{} {}{}", grouped(count), one, count == 1 ? "" : "s");
}

// "9 scenes", or what a scene is made of: "9 scenes (model \u00d7 light)".
std::string scenes_in_words(const analysis::DesignFacts& design) {
    const auto scenes = counted(design.scenes, "scene");
    if (design.factor_names.size() < 2)
        return scenes;
    return fmt::format("{} ({})", scenes,
                       escaped(fmt::format("{}", fmt::join(design.factor_names, " \u00d7 "))));
}

void add_opening(Body& body, const ReportContents& contents) {
    const auto& design = contents.findings.design;
    body.add(fmt::format("<h1>{}</h1>\n", escaped(contents.title)));
    if (!contents.question.empty())
        body.paragraph(contents.question, "question");
    const auto observers = design.observers.size();
    body.add(fmt::format(
        "<p class=\"facts\">{} \u00b7 {} \u00b7 {} \u00b7 {} \u00b7 {}{}</p>\n",
        counted(static_cast<std::int64_t>(design.conditions.size()), "condition"),
        scenes_in_words(design), counted(static_cast<std::int64_t>(observers), "observer"),
        counted(design.votes, "vote"), escaped(contents.written_on),
        contents.screened < store::formal_observers
            ? fmt::format("<br><span class=\"tag\">informal study (fewer than {} observers{})"
                          "</span>",
                          store::formal_observers,
                          observers < store::formal_observers ? "" : " passed a screening")
            : ""));
    if (design.simulated)
        body.add(fmt::format(
            "<p class=\"banner\" role=\"note\"><strong>{}</strong><br>Some or all of these votes "
            "were given by simulated observers. Nothing on this page says anything about what "
            "people see.</p>\n",
            simulated_mark));
}

void add_result(Body& body, const ReportContents& contents, const std::vector<Figure>& figures) {
    body.heading("The result");
    body.add("<div class=\"result\">\n");
    for (const auto& text : result_in_words(contents))
        body.paragraph(text);
    body.add("</div>\n");
    const auto bars = std::ranges::find(figures, "mean-votes", &Figure::name);
    if (bars != figures.end())
        body.figure(*bars);
    body.table("The ranking. A share is the mean over observers of the comparisons each let the "
               "condition win." +
                   letters_in_words(contents),
               ranking_table(contents));
    body.notes("scores");
}

// One factor's matrices, side by side where there is room.
void add_factor_matrices(Body& body, const ReportContents& contents, std::size_t factor) {
    const auto& findings = contents.findings;
    const auto& name = findings.design.factor_names[factor];
    if (findings.design.factors.at(factor).size() < 2)
        return;
    body.subheading("By " + name);
    body.add("<div class=\"side-by-side\">\n");
    for (const auto& scoped : findings.matrices)
        if (scoped.scope == name)
            body.table(level_label(contents, factor, scoped.scene.at(factor)) + ".",
                       vote_matrix_table(contents, scoped.matrix, MatrixHeads::Places));
    body.add("</div>\n");
}

void add_matrices(Body& body, const ReportContents& contents) {
    body.heading("Who was chosen over whom");
    body.table("Votes for the row over the column, all scenes and observers together. Blue: the "
               "row was chosen more often than not.",
               vote_matrix_table(contents, pooled_matrix(contents.findings), MatrixHeads::Names));
    for (std::size_t factor = 0; factor < contents.findings.design.factor_names.size(); ++factor)
        add_factor_matrices(body, contents, factor);
}

void add_default_tests(Body& body, const ReportContents& contents) {
    const auto& findings = contents.findings;
    body.heading("How sure it is");
    body.notes("design");
    if (findings.within.empty()) {
        body.paragraph("There is no analysis of variance: " + findings.why_no_anova + ".");
        return;
    }
    body.table("Analysis of variance within observers, on each observer's mean votes per round: "
               "the default. The error of an effect is its interaction with observers. GG and "
               "HF: p corrected by Greenhouse and Geisser, and by Huynh and Feldt; \u03b7\u00b2: "
               "partial and generalised.",
               within_table(findings.within.front().analysis));
    body.notes("within");
    if (!findings.within_tukey.pairs.empty())
        body.table(fmt::format("Pairs of conditions, differences in mean votes per round: Tukey's "
                               "intervals hold together at {}; beside them the paired t tests, "
                               "adjusted by Holm.",
                               percent(1 - findings.within_tukey.level)),
                   pair_table(contents));
    body.notes("pairs");
    for (std::size_t i = 1; i < findings.within.size(); ++i) {
        std::vector<std::string> factors;
        for (const auto& factor : findings.within[i].analysis.factors)
            factors.push_back(factor.name == "method" ? "condition" : factor.name);
        body.table("Analysis of variance within observers with the factors " + listed(factors) +
                       ".",
                   within_table(findings.within[i].analysis));
    }
}

constexpr const char* one_way_caveat =
    "Read with care. A one-way analysis takes the judgements of one observer for those of "
    "strangers, and its p is too small. It is shown for comparison with what is published in this "
    "form; conclusions rest on the analysis within observers above.";

void add_paper_tests(Body& body, const ReportContents& contents) {
    const auto& findings = contents.findings;
    if (!findings.one_way_observers && !findings.one_way_rounds)
        return;
    body.heading("As in the paper");
    body.paragraph(one_way_caveat, "caveat");
    body.notes("one_way");
    for (const auto* one_way : {&findings.one_way_observers, &findings.one_way_rounds})
        if (*one_way)
            body.table(
                fmt::format("One-way analysis of variance; one value is one {}.", (*one_way)->unit),
                one_way_table((*one_way)->anova));
    if (findings.two_way) {
        body.table(fmt::format("Analysis of variance of condition and {} with one pooled error.",
                               findings.two_way->factor),
                   two_way_table(*findings.two_way));
        body.notes("two_way");
    }
}

void add_stimuli(Body& body, const ReportContents& contents) {
    if (contents.thumbnails.empty() && contents.brightness.empty())
        return;
    body.heading("What was shown");
    if (!contents.thumbnails.empty())
        body.table("The stimuli, reduced.", contact_sheet(contents));
    if (!contents.brightness.empty())
        body.table("Brightness: the factor each picture's light was multiplied by, to bring its "
                   "mean luminance over the object to the target (linear, 1 is white), which all "
                   "pictures of a row share.",
                   brightness_table(contents));
}

void add_circumstances(Body& body, const ReportContents& contents) {
    if (!contents.sittings.empty()) {
        body.heading("Sessions");
        body.table("The sessions.", sitting_table(contents.sittings));
    }
    if (!contents.facts.empty())
        body.heading("Circumstances");
    for (const auto& list : contents.facts) {
        body.subheading(list.heading);
        body.add(fact_list(list.facts));
    }
}

void add_methods(Body& body, const ReportContents& contents) {
    body.heading("How it was analysed");
    for (const auto& text : methods_in_words(contents))
        body.paragraph(text);
    body.notes("units");
    const auto& options = contents.findings.options;
    std::string source = options.program;
    if (!options.source.empty())
        source += fmt::format("; votes from {}", options.source);
    if (!options.source_digest.empty())
        source += fmt::format(", SHA-256 {}", options.source_digest);
    body.add(fmt::format("<footer>Made by {}. All numbers with all their digits are in "
                         "<code>findings.json</code>, the figures as files in "
                         "<code>figures/</code>, both beside this page.</footer>\n",
                         escaped(source)));
}

} // namespace

std::string report_page(const ReportContents& contents, const std::vector<Figure>& figures) {
    Body body(contents);
    add_opening(body, contents);
    add_result(body, contents, figures);
    add_matrices(body, contents);
    add_default_tests(body, contents);
    add_scales(body, contents, figures);
    add_observers(body, contents, figures);
    add_paper_tests(body, contents);
    add_stimuli(body, contents);
    if (contents.cost)
        cost::add_cost(body, *contents.cost, figures);
    add_circumstances(body, contents);
    add_methods(body, contents);
    return filled(page_html,
                  {{"style", std::string(page_css)},
                   {"program", escaped(contents.findings.options.program)},
                   {"window_title", escaped(marked_if_simulated(contents, contents.title))},
                   {"body", body.markup()}});
}

tl::expected<std::filesystem::path, std::string> write_report(const std::filesystem::path& folder,
                                                              const ReportContents& contents) {
    auto figures = draw_figures(contents);
    if (!figures)
        return tl::unexpected(figures.error());
    if (contents.cost) {
        const auto more = cost::draw_cost_figures(*contents.cost);
        if (!more)
            return tl::unexpected(more.error());
        figures->insert(figures->end(), more->begin(), more->end());
    }
    for (const auto& figure : *figures)
        for (const auto& [ending, bytes] :
             {std::pair{".svg", &figure.svg}, std::pair{".pdf", &figure.pdf}})
            if (auto written = write_text_file(folder / "figures" / (figure.name + ending), *bytes);
                !written)
                return tl::unexpected(written.error());
    const auto page = folder / "report.html";
    if (auto written = write_text_file(page, report_page(contents, *figures)); !written)
        return tl::unexpected(written.error());
    return page;
}

} // namespace experiment::report
