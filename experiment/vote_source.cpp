// A study's conditions keep the order of its file; a table's come in order of appearance.
#include "experiment/vote_source.h"

#include "experiment/store/sqlite_store.h"
#include "experiment/store/words.h"
#include "experiment/tables.h"
#include "experiment/text_files.h"
#include "protocols/digest.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace experiment {

namespace fs = std::filesystem;

namespace {

analysis::VoteRow for_analysis(const store::VoteRow& row, bool with_variants) {
    analysis::VoteRow vote{.observer = row.observer.value,
                           .session = fmt::format("{}", row.session),
                           .trial = row.trial,
                           .scene = {row.pair.scene.value},
                           .left = row.pair.left.value,
                           .right = row.pair.right.value,
                           .chosen = row.chosen,
                           .response_ms = static_cast<std::int32_t>(row.response_time.count())};
    if (with_variants)
        vote.scene.push_back(row.pair.variant.value);
    return vote;
}

/// A sentence when some sitting was held under another text of the study file; "" when none was.
std::string changed_study(const LoadedStudy& loaded) {
    const auto store = store::open_votes(loaded.folder.votes());
    const auto sittings = store ? (*store)->sittings() : tl::unexpected(store.error());
    const bool changed = sittings && std::ranges::any_of(*sittings, [&](const auto& sitting) {
                             return sitting.study_sha256 != loaded.sha256;
                         });
    return changed ? "The study file was changed since some of the sittings: their votes are "
                     "pooled with the others."
                   : "";
}

tl::expected<VoteSource, std::string> from_study(const fs::path& path) {
    auto loaded = read_study(path);
    if (!loaded)
        return tl::unexpected(loaded.error());
    const auto rows = stored_votes(*loaded);
    if (!rows)
        return tl::unexpected(rows.error());
    const bool with_variants = !loaded->study.variants.empty();
    auto table =
        analysis::empty_vote_table(with_variants ? std::vector<std::string>{"scene", "variant"}
                                                 : std::vector<std::string>{"scene"});
    table.study = loaded->study.id;
    for (const auto& condition : loaded->study.conditions)
        table.conditions.code(condition.id.value);
    for (const auto& row : *rows) {
        analysis::append_vote(table, for_analysis(row, with_variants));
        table.simulated = table.simulated || row.simulated;
    }
    if (const auto changed = changed_study(*loaded); !changed.empty())
        table.notes.push_back(changed);
    return VoteSource{std::move(table), loaded->study.title,
                      protocols::sha256_hexadecimal(long_csv(*rows)), std::move(*loaded)};
}

tl::expected<VoteSource, std::string>
from_table(const fs::path& path, analysis::formats::VoteFormat format, analysis::Repeats repeats) {
    const auto text = read_text_file(path);
    if (!text)
        return tl::unexpected(text.error());
    auto table = analysis::formats::read_vote_file(*text, path.string(), format, repeats);
    if (!table)
        return tl::unexpected(table.error());
    if (table->size() == 0)
        return tl::unexpected(fmt::format("{}: has no votes", path.string()));
    return VoteSource{std::move(*table), path.filename().string(),
                      protocols::sha256_hexadecimal(*text), std::nullopt};
}

} // namespace

tl::expected<VoteSource, std::string>
read_votes(const fs::path& path, analysis::formats::VoteFormat format, analysis::Repeats repeats) {
    const bool is_study = fs::is_directory(path) || path.filename() == "study.toml";
    return is_study ? from_study(path) : from_table(path, format, repeats);
}

tl::expected<std::unique_ptr<store::VoteStore>, std::string>
open_whole_votes(const StudyFolder& folder) {
    auto store = store::open_votes(folder.votes());
    if (!store)
        return store;
    const auto faults = (*store)->verify();
    if (!faults)
        return tl::unexpected(faults.error());
    if (!faults->empty())
        return tl::unexpected(
            fmt::format("{}: the record is not whole, {} faults; `pairlight verify {}` lists them",
                        folder.votes().string(), faults->size(), folder.root.string()));
    return store;
}

tl::expected<std::vector<store::VoteRow>, std::string> stored_votes(const LoadedStudy& loaded) {
    const auto file = loaded.folder.votes();
    const auto none = [&] {
        return tl::unexpected(
            fmt::format("{}: there are no votes yet; `pairlight session` or `pairlight "
                        "simulate` makes some",
                        file.string()));
    };
    if (!fs::exists(file))
        return none();
    const auto store = open_whole_votes(loaded.folder);
    if (!store)
        return tl::unexpected(store.error());
    auto rows = (*store)->votes();
    if (rows && rows->empty())
        return none();
    return rows;
}

std::string long_csv(const std::vector<store::VoteRow>& rows) {
    const bool simulated = std::ranges::any_of(rows, &store::VoteRow::simulated);
    std::string table =
        "study,observer,session,trial,scene,variant,left,right,chosen,rt_ms,onset_utc";
    table += simulated ? ",simulated\n" : "\n";
    for (const auto& row : rows) {
        std::vector<std::string> fields{row.study,
                                        row.observer.value,
                                        fmt::format("{}", row.session),
                                        fmt::format("{}", row.trial),
                                        row.pair.scene.value,
                                        row.pair.variant.value,
                                        row.pair.left.value,
                                        row.pair.right.value,
                                        std::string(store::word_of(row.chosen)),
                                        fmt::format("{}", row.response_time.count()),
                                        row.onset_utc};
        if (simulated)
            fields.emplace_back(row.simulated ? "1" : "0");
        table += csv_row(fields);
    }
    return table;
}

} // namespace experiment
