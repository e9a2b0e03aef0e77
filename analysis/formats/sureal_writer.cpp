#include "analysis/formats/sureal_writer.h"

#include "analysis/vote_matrix.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <vector>

namespace analysis::formats {

namespace {

// As Python writes it, and as JSON might.
std::string in_quotes(std::string_view text) {
    std::string literal = "'";
    for (const char c : text) {
        if (c == '\\' || c == '\'')
            literal += {'\\', c};
        else if (const auto code = static_cast<unsigned char>(c); code < 0x20 || code == 0x7F)
            literal += fmt::format("\\x{:02x}", code);
        else
            literal += c;
    }
    return literal + "'";
}

using Scene = std::vector<std::string>;

// "bunny/back": of a folder and of a content; levels may be empty.
std::string joined(const Scene& scene) {
    std::string name;
    for (const auto& level : scene)
        if (!level.empty())
            name += (name.empty() ? "" : "/") + level;
    return name.empty() ? "all" : name;
}

struct Asset {
    std::size_t content = 0, condition = 0;
    std::string votes; ///< entries of `os`
};

// Numbers of contents and assets are their places.
struct DataSet {
    std::vector<Scene> contents;
    std::vector<Asset> assets;
    std::map<Scene, std::map<std::size_t, std::size_t>> places; ///< of assets, by condition
};

DataSet without_votes(const VoteTable& table) {
    DataSet set;
    for (const auto& [scope, observer, session, scene, matrix] :
         count_votes(table, {false, false, std::vector<bool>(table.factors.size(), true)})) {
        for (std::size_t c = 0; c < matrix.conditions(); ++c)
            if (matrix.comparisons(c) > 0) {
                set.places[scene][c] = set.assets.size();
                set.assets.push_back({set.contents.size(), c, ""});
            }
        set.contents.push_back(scene);
    }
    return set;
}

Expected<DataSet> with_votes(const VoteTable& table) {
    auto set = without_votes(table);
    for (const auto& [scope, observer, session, scene, matrix] :
         count_votes(table, {true, false, std::vector<bool>(table.factors.size(), true)}))
        for (const auto& [i, asset] : set.places.at(scene))
            for (const auto& [j, other] : set.places.at(scene)) {
                if (i == j || matrix.comparisons(i, j) == 0)
                    continue;
                if (matrix.comparisons(i, j) > 1)
                    return tl::unexpected(fmt::format(
                        "{} compared {} and {} of {} {} times: this form holds one answer of an "
                        "observer; export pairs instead",
                        observer, table.conditions.name(i), table.conditions.name(j), joined(scene),
                        matrix.comparisons(i, j)));
                if (matrix.wins(i, j) > 0 || matrix.ties(i, j) > 0)
                    set.assets[asset].votes += fmt::format(
                        "{}({}, {}): {}", set.assets[asset].votes.empty() ? "" : ", ",
                        in_quotes(observer), other, matrix.wins(i, j) > 0 ? "1" : "0.5");
            }
    return set;
}

std::string scene_literal(const VoteTable& table, const Scene& scene) {
    std::vector<std::string> entries;
    for (std::size_t f = 0; f < scene.size(); ++f)
        entries.push_back(in_quotes(table.factor_names[f]) + ": " + in_quotes(scene[f]));
    return fmt::format("{{{}}}", fmt::join(entries, ", "));
}

} // namespace

Expected<std::string> sureal_script(const VoteTable& table) {
    if (table.size() == 0)
        return tl::unexpected(std::string("no votes: sureal needs at least one reference"));
    const auto set = with_votes(table);
    if (!set)
        return tl::unexpected(set.error());
    auto script = fmt::format("dataset_name = {}\n", in_quotes(table.study));
    script += table.simulated ? "simulated = True\n" : "";
    script += "\nref_videos = [\n";
    for (std::size_t content = 0; content < set->contents.size(); ++content) {
        const auto& scene = set->contents[content];
        script += fmt::format(
            " {{'content_id': {}, 'content_name': {}, 'path': {}, 'scene': {}}},\n", content,
            in_quotes(joined(scene)), in_quotes(joined(scene)), scene_literal(table, scene));
    }
    script += "]\n\ndis_videos = [\n";
    for (std::size_t number = 0; number < set->assets.size(); ++number) {
        const auto& [content, condition, votes] = set->assets[number];
        const auto& name = table.conditions.name(condition);
        script +=
            fmt::format(" {{'asset_id': {}, 'content_id': {}, 'condition': {}, 'path': {},\n"
                        "  'os': {{{}}}}},\n",
                        number, content, in_quotes(name),
                        in_quotes(joined(set->contents[content]) + "/" + name + ".png"), votes);
    }
    return script + "]\n";
}

} // namespace analysis::formats
