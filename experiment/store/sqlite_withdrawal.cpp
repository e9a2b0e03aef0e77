// The chain of rows stays provable: a removed row leaves its number and its digest, which the row
// after it confirms, and the tombstone, itself on the chain, says how many there were and which.
#include "experiment/store/sqlite_withdrawal.h"

#include "experiment/store/sqlite_reading.h"
#include "experiment/store/sqlite_schema.h"
#include "protocols/digest.h"

#include <fmt/format.h>

namespace experiment::store {

namespace {

/// A table with an observer's rows, and how to tell them.  Those that others refer to come last.
struct Belongings {
    std::string table;
    std::string which; ///< a condition with one parameter, the observer
};

const std::vector<Belongings>& belongings() {
    static const auto list = [] {
        std::vector<Belongings> all;
        for (const auto* table :
             {"grades", "frames", "votes", "shown", "events", "finished", "planned"})
            all.push_back({table, "sitting IN (SELECT seq FROM sittings WHERE observer = ?)"});
        for (const auto* table : {"sittings", "answers", "observers"})
            all.push_back({table, "observer = ?"});
        return all;
    }();
    return list;
}

std::string pseudonym_digest(const SqliteDatabase& database,
                             const protocols::ObserverId& observer) {
    return protocols::sha256_hexadecimal(
        fmt::format("{}|{}", read_study(database).id, observer.value));
}

std::string digest_of(const std::vector<Row>& numbers_and_digests) {
    std::string text;
    for (const auto& row : numbers_and_digests)
        text += fmt::format("{}:{}\n", integer_of(row[0]), text_of(row[1]));
    return protocols::sha256_hexadecimal(text);
}

} // namespace

Removal remove_observer(SqliteDatabase& database, const protocols::ObserverId& observer) {
    Removal removal;
    removal.observer_sha256 = pseudonym_digest(database, observer);
    database.execute("CREATE TEMP TABLE leaving (seq INTEGER PRIMARY KEY, digest TEXT)");
    for (const auto& [table, which] : belongings())
        database.query(
            fmt::format("INSERT INTO leaving SELECT seq, digest FROM {} WHERE {}", table, which),
            {observer.value});
    const auto leaving = database.query("SELECT seq, digest FROM leaving ORDER BY seq");
    removal.rows = static_cast<int>(leaving.size());
    removal.removed_sha256 = digest_of(leaving);
    removal.votes = static_cast<int>(integer_of(
        database.query("SELECT count(*) FROM votes WHERE seq IN (SELECT seq FROM leaving)")[0][0]));
    for (const auto& [table, which] : belongings()) {
        const auto guard = guards(table).back(); // against deletion
        database.execute("DROP TRIGGER " + guard.name);
        database.query(fmt::format("DELETE FROM {} WHERE {}", table, which), {observer.value});
        database.execute(guard.sql);
    }
    return removal;
}

bool was_withdrawn(const SqliteDatabase& database, const protocols::ObserverId& observer) {
    return !database
                .query("SELECT 1 FROM tombstones WHERE observer_sha256 = ?",
                       {pseudonym_digest(database, observer)})
                .empty();
}

std::vector<std::string> tombstone_findings(const SqliteDatabase& database) {
    std::vector<std::string> findings;
    for (const auto& tombstone :
         database.query("SELECT seq, row_count, removed_sha256 FROM tombstones ORDER BY seq")) {
        const auto rows = database.query(
            "SELECT seq, digest FROM removed WHERE tombstone = ? ORDER BY seq", {tombstone[0]});
        if (static_cast<std::int64_t>(rows.size()) != integer_of(tombstone[1]) ||
            digest_of(rows) != text_of(tombstone[2]))
            findings.push_back(fmt::format("row {} (tombstones): stands for {} removed rows, but "
                                           "{} are named, or others than those",
                                           integer_of(tombstone[0]), integer_of(tombstone[1]),
                                           rows.size()));
    }
    const auto orphans = integer_of(database.query(
        "SELECT count(*) FROM removed WHERE tombstone NOT IN (SELECT seq FROM tombstones)")[0][0]);
    if (orphans > 0)
        findings.push_back(fmt::format("{} row(s) were removed without a tombstone", orphans));
    return findings;
}

} // namespace experiment::store
