// Both entries of a pair may tell of it; they have to agree.
#include "analysis/formats/sureal_file.h"

#include "analysis/formats/literals.h"
#include "analysis/formats/sureal_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace analysis::formats {

namespace {

using Kind = Literal::Kind;
using Checked = Expected<void>; ///< nothing, or what is wrong

struct Asset {
    std::int64_t id = 0, content = 0;
    std::string condition, path; ///< "" without one
    const Literal* votes = nullptr;
};

struct Content {
    std::string name;
    const Literal* scene = nullptr; ///< a level for every scene factor, where it is said
};

struct Key {
    std::string subject;
    std::int64_t asset = 0;
};

// What one subject said of one pair of assets, the smaller number first.
struct Answer {
    double first_chosen = 0;
    std::int64_t line = 0;
    std::int64_t told_by = 0; ///< in the entry of this asset
};

std::optional<std::int64_t> whole(const Literal* value) {
    if (value == nullptr || value->kind != Kind::Number || value->number < 0 ||
        value->number > 1e9 ||
        value->number != static_cast<double>(static_cast<std::int64_t>(value->number)))
        return std::nullopt;
    return static_cast<std::int64_t>(value->number);
}

// "" for what is no text.
std::string text_of(const Literal* value) {
    return value != nullptr && value->kind == Kind::Text ? value->text : "";
}

bool is_scene(const Literal* value) {
    return value != nullptr && value->kind == Kind::Map &&
           std::all_of(value->entries.begin(), value->entries.end(), [](const LiteralEntry& entry) {
               return entry.first.kind == Kind::Text && entry.second.kind == Kind::Text;
           });
}

class DataSet {
  public:
    explicit DataSet(const std::string& name) : name_(name) {}

    Expected<VoteTable> read(const Literal& file) {
        const auto* videos = file.find("dis_videos");
        if (file.kind != Kind::Map || videos == nullptr || videos->kind != Kind::List)
            return fail(file.line, "no list 'dis_videos', expected a data set of sureal");
        if (auto read = read_videos(file, *videos); !read)
            return tl::unexpected(std::move(read.error()));
        if (answers_.empty())
            return fail(videos->line, "no votes in any 'os'");
        return table();
    }

  private:
    tl::unexpected<std::string> fail(std::int64_t line, const std::string& what) const {
        return tl::unexpected(fmt::format("{}:{}: {}", name_, line, what));
    }

    Checked read_videos(const Literal& file, const Literal& videos) {
        if (auto once = expect_keys_once(file); !once)
            return once;
        if (auto read = read_contents(file.find("ref_videos")); !read)
            return read;
        const auto* simulated = file.find("simulated");
        simulated_ = simulated != nullptr && simulated->number == 1;
        for (const auto& video : videos.items)
            if (auto read = read_asset(video); !read)
                return read;
        for (const auto& asset : assets_)
            for (const auto& [key, value] : asset.votes->entries)
                if (auto read = read_vote(asset, key, value); !read)
                    return read;
        return {};
    }

    Checked read_contents(const Literal* videos) {
        if (videos == nullptr || videos->kind != Kind::List)
            return {};
        for (const auto& video : videos->items) {
            const auto id = whole(video.find("content_id"));
            if (!id)
                return fail(video.line, "a reference without a number as 'content_id'");
            const auto name = text_of(video.find("content_name"));
            const auto* scene = video.find("scene");
            contents_[*id] = {name.empty() ? fmt::format("{}", *id) : name,
                              is_scene(scene) ? scene : nullptr};
        }
        return {};
    }

    // Which of two values counts, Python and JSON readers answer differently.
    Checked expect_keys_once(const Literal& map) const {
        std::set<std::string_view> seen;
        for (const auto& [key, value] : map.entries)
            if (key.kind == Kind::Text && !seen.insert(key.text).second)
                return fail(key.line, fmt::format("'{}' stands twice, expected once", key.text));
        return {};
    }

    Checked read_asset(const Literal& video) {
        if (auto once = expect_keys_once(video); !once)
            return once;
        Asset asset;
        const auto id = whole(video.find("asset_id")), content = whole(video.find("content_id"));
        if (!id || !content)
            return fail(video.line, "expected whole numbers as 'asset_id' and 'content_id'");
        asset.id = *id;
        asset.content = *content;
        asset.votes = video.find("os");
        if (asset.votes == nullptr || asset.votes->kind != Kind::Map)
            return fail(
                asset.votes == nullptr ? video.line : asset.votes->line,
                fmt::format("asset {} has no map 'os' of (subject, asset): 1; ratings are no "
                            "votes on pairs",
                            *id));
        asset.condition = text_of(video.find("condition"));
        asset.path = text_of(video.find("path"));
        if (!places_.emplace(*id, assets_.size()).second)
            return fail(video.line, fmt::format("asset {} stands twice", *id));
        contents_.emplace(*content, Content{fmt::format("{}", *content)});
        assets_.push_back(std::move(asset));
        return {};
    }

    // A pair as it is, or as a text that holds one.
    std::optional<Key> key_of(const Literal& literal) const {
        if (literal.kind == Kind::Text) {
            const auto inside = read_literal(literal.text, name_, literal.line);
            return inside && inside->kind == Kind::List ? key_of(*inside) : std::nullopt;
        }
        if (literal.kind != Kind::List || literal.items.size() != 2 ||
            literal.items[0].kind != Kind::Text || literal.items[0].text.empty())
            return std::nullopt;
        const auto asset = whole(&literal.items[1]);
        return asset ? std::optional(Key{literal.items[0].text, *asset}) : std::nullopt;
    }

    Checked read_vote(const Asset& asset, const Literal& literal, const Literal& value) {
        const auto key = key_of(literal);
        if (!key)
            return fail(literal.line, "a key of 'os' is no pair of a subject's name and an asset's "
                                      "number, such as ('Ann', 2)");
        const auto place = places_.find(key->asset);
        if (place == places_.end())
            return fail(literal.line,
                        fmt::format("asset {} is not among 'dis_videos'", key->asset));
        if (key->asset == asset.id)
            return fail(literal.line, fmt::format("asset {} against itself", asset.id));
        if (const auto other = assets_[place->second].content; other != asset.content)
            return fail(
                literal.line,
                fmt::format("asset {} is of content {}, asset {} of {}: pairs across contents "
                            "have no common scene",
                            asset.id, asset.content, key->asset, other));
        const bool number = value.kind == Kind::Number;
        if (!number || (value.number != 0 && value.number != 0.5 && value.number != 1))
            return fail(value.line,
                        fmt::format("the vote of {} on assets {} and {}: expected 1, 0, "
                                    "or 0.5 for a tie",
                                    key->subject, asset.id, key->asset));
        const bool first = asset.id < key->asset;
        const Answer answer{first ? value.number : 1 - value.number, literal.line, asset.id};
        const auto pair = std::minmax(asset.id, key->asset);
        const auto [known, added] =
            answers_.emplace(std::tuple(key->subject, pair.first, pair.second), answer);
        if (added) {
            order_.push_back(known->first);
            return {};
        }
        const auto& before = known->second;
        const bool again = before.told_by == asset.id;
        if (again || before.first_chosen != answer.first_chosen)
            return fail(
                literal.line,
                fmt::format("{} was asked about assets {} and {} before, on line {}: the form "
                            "holds one answer",
                            key->subject, asset.id, key->asset, before.line));
        ++told_twice_;
        return {};
    }

    ConditionNames named_assets() const {
        std::vector<NamedAsset> named;
        for (const auto& asset : assets_)
            named.push_back({asset.id, asset.content, contents_.at(asset.content).name,
                             asset.condition, asset.path});
        return condition_names(named);
    }

    // Factors in the order of the first content, where all contents have them; none where one has
    // others.
    std::optional<std::vector<std::string>> scene_factors() const {
        const auto* first = contents_.begin()->second.scene;
        if (first == nullptr)
            return std::nullopt;
        std::vector<std::string> factors;
        for (const auto& [factor, level] : first->entries)
            factors.push_back(factor.text);
        for (const auto& [id, content] : contents_)
            if (content.scene == nullptr || content.scene->entries.size() != factors.size() ||
                std::any_of(factors.begin(), factors.end(), [&](const auto& factor) {
                    return content.scene->find(factor) == nullptr;
                }))
                return std::nullopt;
        return factors;
    }

    VoteTable table() {
        const auto factors = scene_factors();
        auto table = empty_vote_table(factors.value_or(std::vector<std::string>{"content"}));
        table.simulated = simulated_;
        const auto [names, note] = named_assets();
        for (const auto& name : names)
            table.conditions.code(name);
        const auto name_of = [&](std::int64_t asset) { return names[places_.at(asset)]; };
        const auto scene_of = [&](const Content& content) {
            if (!factors)
                return std::vector<std::string>{content.name};
            std::vector<std::string> levels;
            for (const auto& factor : *factors)
                levels.push_back(content.scene->find(factor)->text);
            return levels;
        };
        for (const auto& key : order_) {
            const auto& [subject, first, second] = key;
            const double chosen = answers_.at(key).first_chosen;
            const auto& content = contents_.at(assets_[places_.at(first)].content);
            append_vote(table, {.observer = subject,
                                .session = "1",
                                .scene = scene_of(content),
                                .left = name_of(first),
                                .right = name_of(second),
                                .chosen = chosen == 1   ? protocols::Choice::Left
                                          : chosen == 0 ? protocols::Choice::Right
                                                        : protocols::Choice::Tie});
        }
        table.notes.push_back(note);
        table.notes.emplace_back("the file does not say which condition was on the left: what is "
                                 "said of the left side is of the one named first");
        if (told_twice_ > 0)
            table.notes.push_back(fmt::format(
                "{} votes stand in the file from both sides: they count once", told_twice_));
        return table;
    }

    const std::string& name_;
    std::map<std::int64_t, Content> contents_;
    std::vector<Asset> assets_;
    std::map<std::int64_t, std::size_t> places_; ///< of asset numbers in `assets_`
    using Question = std::tuple<std::string, std::int64_t, std::int64_t>;
    std::map<Question, Answer> answers_;
    std::vector<Question> order_; ///< of the file
    std::int64_t told_twice_ = 0;
    bool simulated_ = false;
};

} // namespace

Expected<VoteTable> read_sureal_data_set(std::string_view text, const std::string& name) {
    const auto file = read_literal_file(text, name);
    if (!file)
        return tl::unexpected(file.error());
    return DataSet(name).read(*file);
}

// A table may begin with such a sign too, but its header does not name `dis_videos`.
bool looks_like_sureal(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    const auto first = text.find_first_not_of(" \t\r\n");
    if (first == text.npos)
        return false;
    const bool json = text[first] == '{';
    const auto line = text.substr(first, text.find('\n', first) - first);
    const bool script = text[first] == '#' || line.find(" = ") != line.npos;
    return (json || script) && text.find("dis_videos") != text.npos;
}

} // namespace analysis::formats
