#include "experiment/report/body.h"

#include "experiment/report/html.h"
#include "experiment/report/simulated.h"

#include <fmt/format.h>

namespace experiment::report {

void Body::heading(const std::string& text) {
    markup_ += fmt::format("<h2>{}</h2>\n", escaped(text));
}

void Body::subheading(const std::string& text) {
    markup_ += fmt::format("<h3>{}</h3>\n", escaped(text));
}

void Body::paragraph(const std::string& text, const std::string& kind) {
    markup_ += kind.empty() ? fmt::format("<p>{}</p>\n", escaped(text))
                            : fmt::format("<p class=\"{}\">{}</p>\n", kind, escaped(text));
}

void Body::notes(const std::string& about) {
    for (const auto& note : contents_.findings.notes)
        if (note.about == about)
            paragraph(note.text, "note");
}

void Body::table(const std::string& text, const std::string& markup) {
    captioned(fmt::format("Table {}", ++tables_), text, "<div class=\"wide\">" + markup + "</div>");
}

void Body::figure(const Figure& figure) {
    captioned(fmt::format("Figure {}", ++figures_), figure.caption,
              fmt::format("<div class=\"wide\"><img src=\"{}\" alt=\"{}\"></div>",
                          data_address("image/svg+xml", figure.svg),
                          escaped(marked_if_simulated(contents_, figure.description))));
}

void Body::captioned(const std::string& number,
                     const std::string& text,
                     const std::string& content) {
    markup_ += fmt::format("<figure><figcaption><b>{}.</b> {}</figcaption>\n{}</figure>\n", number,
                           escaped(marked_if_simulated(contents_, text)), content);
}

} // namespace experiment::report
