// Both entries of a pair may tell of it; they have to agree.
#include "analysis/formats/sureal_file.h"

#include "analysis/formats/literals.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace analysis::formats {

namespace {

using Kind = Literal::Kind;

struct Asset {
    std::int64_t id = 0, content = 0, line = 0;
    std::string stem; ///< of its file, "" without one
    const Literal* votes = nullptr;
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

// "caps/Caps1.png": Caps1
std::string stem_of(const std::string& path) {
    const auto slash = path.find_last_of("/\\");
    const auto file = slash == path.npos ? path : path.substr(slash + 1);
    const auto dot = file.rfind('.');
    return dot == path.npos || dot == 0 ? file : file.substr(0, dot);
}

class DataSet {
  public:
    explicit DataSet(const std::string& name) : name_(name) {}

    Expected<VoteTable> read(const Literal& file) {
        const auto* videos = file.find("dis_videos");
        if (file.kind != Kind::Map || videos == nullptr || videos->kind != Kind::List)
            return fail(file.line, "no list 'dis_videos', expected a data set of sureal");
        if (auto wrong = doubled_key(file); !wrong.empty())
            return tl::unexpected(wrong);
        if (auto wrong = read_contents(file.find("ref_videos")); !wrong.empty())
            return tl::unexpected(wrong);
        for (const auto& video : videos->items)
            if (auto wrong = read_asset(video); !wrong.empty())
                return tl::unexpected(wrong);
        for (const auto& asset : assets_)
            for (const auto& [key, value] : asset.votes->entries)
                if (auto wrong = read_vote(asset, key, value); !wrong.empty())
                    return tl::unexpected(wrong);
        if (answers_.empty())
            return fail(videos->line, "no votes in any 'os'");
        return table();
    }

  private:
    tl::unexpected<std::string> fail(std::int64_t line, const std::string& what) const {
        return tl::unexpected(at(line, what));
    }

    std::string at(std::int64_t line, const std::string& what) const {
        return fmt::format("{}:{}: {}", name_, line, what);
    }

    std::string read_contents(const Literal* videos) {
        if (videos == nullptr || videos->kind != Kind::List)
            return {};
        for (const auto& video : videos->items) {
            const auto id = whole(video.find("content_id"));
            const auto* name = video.find("content_name");
            if (!id)
                return at(video.line, "a reference without a number as 'content_id'");
            if (name != nullptr && name->kind == Kind::Text && !name->text.empty())
                contents_[*id] = name->text;
        }
        return {};
    }

    // Which of two values counts, Python and JSON readers answer differently.
    std::string doubled_key(const Literal& map) const {
        std::set<std::string_view> seen;
        for (const auto& [key, value] : map.entries)
            if (key.kind == Kind::Text && !seen.insert(key.text).second)
                return at(key.line, fmt::format("'{}' stands twice, expected once", key.text));
        return {};
    }

    std::string read_asset(const Literal& video) {
        if (auto wrong = doubled_key(video); !wrong.empty())
            return wrong;
        Asset asset;
        const auto id = whole(video.find("asset_id")), content = whole(video.find("content_id"));
        if (!id || !content)
            return at(video.line, "expected whole numbers as 'asset_id' and 'content_id'");
        asset.id = *id;
        asset.content = *content;
        asset.line = video.line;
        asset.votes = video.find("os");
        if (asset.votes == nullptr || asset.votes->kind != Kind::Map)
            return at(asset.votes == nullptr ? video.line : asset.votes->line,
                      fmt::format("asset {} has no map 'os' of (subject, asset): 1; ratings are no "
                                  "votes on pairs",
                                  *id));
        if (const auto* path = video.find("path"); path != nullptr && path->kind == Kind::Text)
            asset.stem = stem_of(path->text);
        if (!places_.emplace(*id, assets_.size()).second)
            return at(video.line, fmt::format("asset {} stands twice", *id));
        contents_.emplace(*content, fmt::format("{}", *content));
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

    std::string read_vote(const Asset& asset, const Literal& literal, const Literal& value) {
        const auto key = key_of(literal);
        if (!key)
            return at(literal.line, "a key of 'os' is no pair of a subject's name and an asset's "
                                    "number, such as ('Ann', 2)");
        const auto place = places_.find(key->asset);
        if (place == places_.end())
            return at(literal.line, fmt::format("asset {} is not among 'dis_videos'", key->asset));
        if (key->asset == asset.id)
            return at(literal.line, fmt::format("asset {} against itself", asset.id));
        if (const auto other = assets_[place->second].content; other != asset.content)
            return at(
                literal.line,
                fmt::format("asset {} is of content {}, asset {} of {}: pairs across contents "
                            "have no common scene",
                            asset.id, asset.content, key->asset, other));
        const bool number = value.kind == Kind::Number;
        if (!number || (value.number != 0 && value.number != 0.5 && value.number != 1))
            return at(value.line, fmt::format("the vote of {} on assets {} and {}: expected 1, 0, "
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
            return at(
                literal.line,
                fmt::format("{} was asked about assets {} and {} before, on line {}: the form "
                            "holds one answer",
                            key->subject, asset.id, key->asset, before.line));
        ++told_twice_;
        return {};
    }

    // The stem, without the content's name where all have it in front.
    bool content_in_front() const {
        return std::all_of(assets_.begin(), assets_.end(), [&](const Asset& asset) {
            const auto& content = contents_.at(asset.content);
            return asset.stem.size() > content.size() && asset.stem.starts_with(content);
        });
    }

    std::vector<std::string> condition_names() {
        const bool shorten = content_in_front();
        std::vector<std::string> names;
        std::set<std::pair<std::int64_t, std::string>> seen;
        bool unique = true;
        for (const auto& asset : assets_) {
            auto stem = asset.stem;
            if (shorten)
                stem.erase(
                    0, std::min(stem.find_first_not_of(" _-", contents_.at(asset.content).size()),
                                stem.size() - 1));
            unique = unique && !stem.empty() && seen.emplace(asset.content, stem).second;
            names.push_back(std::move(stem));
        }
        by_number_ = !unique;
        for (std::size_t a = 0; !unique && a < names.size(); ++a)
            names[a] = fmt::format("{}", assets_[a].id);
        return names;
    }

    VoteTable table() {
        auto table = empty_vote_table({"content"});
        const auto names = condition_names();
        for (const auto& name : names)
            table.conditions.code(name);
        const auto name_of = [&](std::int64_t asset) { return names[places_.at(asset)]; };
        for (const auto& key : order_) {
            const auto& [subject, first, second] = key;
            const double chosen = answers_.at(key).first_chosen;
            const auto& content = contents_.at(assets_[places_.at(first)].content);
            append_vote(table, {.observer = subject,
                                .session = "1",
                                .scene = {content},
                                .left = name_of(first),
                                .right = name_of(second),
                                .chosen = chosen == 1   ? protocols::Choice::Left
                                          : chosen == 0 ? protocols::Choice::Right
                                                        : protocols::Choice::Tie});
        }
        table.notes.emplace_back(by_number_ ? "conditions are called by their assets' numbers"
                                            : "conditions are called by their files' names");
        table.notes.emplace_back("the file does not say which condition was on the left: what is "
                                 "said of the left side is of the one named first");
        if (told_twice_ > 0)
            table.notes.push_back(fmt::format(
                "{} votes stand in the file from both sides: they count once", told_twice_));
        return table;
    }

    const std::string& name_;
    std::map<std::int64_t, std::string> contents_;
    std::vector<Asset> assets_;
    std::map<std::int64_t, std::size_t> places_; ///< of asset numbers in `assets_`
    using Question = std::tuple<std::string, std::int64_t, std::int64_t>;
    std::map<Question, Answer> answers_;
    std::vector<Question> order_; ///< of the file
    std::int64_t told_twice_ = 0;
    bool by_number_ = false;
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
