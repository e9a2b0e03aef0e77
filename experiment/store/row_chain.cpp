// Digests of rows, each over its predecessor's.
#include "experiment/store/row_chain.h"

#include "protocols/digest.h"

#include <fmt/format.h>

namespace experiment::store {

namespace {

// Lengths come first, so that no two rows have the same text.
std::string canonical(const Value& value) {
    if (const auto* number = std::get_if<std::int64_t>(&value))
        return fmt::format("i{};", *number);
    if (const auto* text = std::get_if<std::string>(&value))
        return fmt::format("t{}:{};", text->size(), *text);
    return "n;";
}

std::string described(const ChainedRow& row) {
    std::string text = fmt::format("row {} ({}", row.seq, row.table);
    for (const auto& value : row.values) {
        if (const auto* number = std::get_if<std::int64_t>(&value))
            text += fmt::format(" {}", *number);
        else if (const auto* words = std::get_if<std::string>(&value))
            text += ' ' + (words->size() > 24 ? words->substr(0, 24) + "..." : *words);
        if (text.size() > 80)
            break;
    }
    return text + ')';
}

} // namespace

std::string row_digest(const std::string& predecessor, const ChainedRow& row) {
    std::string text = canonical(predecessor) + canonical(row.table) + canonical(row.seq);
    for (const auto& value : row.values)
        text += canonical(value);
    return protocols::sha256_hexadecimal(text);
}

std::vector<std::string> chain_findings(const std::vector<ChainedRow>& rows,
                                        std::int64_t head_seq,
                                        const std::string& head_digest) {
    std::vector<std::string> findings;
    std::int64_t previous = 0;
    std::string predecessor;
    for (const auto& row : rows) {
        if (row.seq == previous + 2)
            findings.push_back(fmt::format("row {} is missing", previous + 1));
        else if (row.seq > previous + 2)
            findings.push_back(fmt::format("rows {} to {} are missing", previous + 1, row.seq - 1));
        else if (row.seq != previous + 1)
            findings.push_back(
                fmt::format("{} has a number that was given out before", described(row)));
        else if (!row.removed && row.digest != row_digest(predecessor, row))
            findings.push_back(fmt::format("{} was changed after it was written, or is not the row "
                                           "that was written here",
                                           described(row)));
        previous = row.seq;
        predecessor = row.digest;
    }
    if (previous < head_seq)
        findings.push_back(fmt::format("{} row(s) are missing at the end", head_seq - previous));
    else if (previous != head_seq || predecessor != head_digest)
        findings.push_back("the end of the chain was changed after it was written");
    return findings;
}

} // namespace experiment::store
