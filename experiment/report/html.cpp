// Escaping and base64.
#include "experiment/report/html.h"

#include "protocols/contract.h"

#include <fmt/format.h>

#include <cstdint>

namespace experiment::report {

std::string escaped(std::string_view text) {
    std::string safe;
    safe.reserve(text.size());
    for (const char character : text)
        switch (character) {
        case '&':
            safe += "&amp;";
            break;
        case '<':
            safe += "&lt;";
            break;
        case '>':
            safe += "&gt;";
            break;
        case '"':
            safe += "&quot;";
            break;
        case '\'':
            safe += "&#39;";
            break;
        default:
            safe += character;
        }
    return safe;
}

std::string data_address(std::string_view media_type, std::string_view bytes) {
    static constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string address = "data:" + std::string(media_type) + ";base64,";
    for (std::size_t first = 0; first < bytes.size(); first += 3) {
        const auto here = bytes.substr(first, 3);
        std::uint32_t group = 0;
        for (std::size_t i = 0; i < 3; ++i)
            group = group << 8U | (i < here.size() ? static_cast<unsigned char>(here[i]) : 0U);
        for (std::size_t i = 0; i < 4; ++i)
            address += i <= here.size() ? digits[group >> (18 - 6 * i) & 63U] : '=';
    }
    return address;
}

std::string filled(std::string_view page, const std::map<std::string, std::string>& values) {
    std::string whole;
    for (;;) {
        const auto open = page.find("{{");
        const auto close = page.find("}}", open);
        if (close == page.npos)
            return whole.append(page);
        const auto value = values.find(std::string(page.substr(open + 2, close - open - 2)));
        EXPECTS(value != values.end());
        whole.append(page.substr(0, open)).append(value->second);
        page.remove_prefix(close + 2);
    }
}

std::string html_row(const std::vector<std::string>& cells) {
    std::string html = "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i)
        html += i == 0 ? fmt::format("<th scope=\"row\">{}</th>", cells[i])
                       : fmt::format("<td>{}</td>", cells[i]);
    return html + "</tr>\n";
}

std::string html_head(const std::vector<std::string>& cells) {
    std::string html = "<thead><tr>";
    for (const auto& cell : cells)
        html += fmt::format("<th scope=\"col\">{}</th>", cell);
    return html + "</tr></thead>\n";
}

std::string html_table(std::string_view kind, std::string_view head, std::string_view rows) {
    return fmt::format("<table class=\"{}\">\n{}<tbody>\n{}</tbody></table>\n", kind, head, rows);
}

} // namespace experiment::report
