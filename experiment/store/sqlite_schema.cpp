// The schema.  Every row is written once, and goes only with its observer's wish; triggers refuse
// anything else.
#include "experiment/store/sqlite_schema.h"

#include <fmt/format.h>

namespace experiment::store {

namespace {

// Times on the monotonic clock end in _ns, wall-clock times in _utc (ISO 8601, milliseconds, Z).
constexpr auto tables = R"sql(
CREATE TABLE study (
    seq INTEGER PRIMARY KEY, id TEXT NOT NULL, file_sha256 TEXT NOT NULL, digest TEXT NOT NULL
) STRICT;

CREATE TABLE observers (
    seq INTEGER PRIMARY KEY, observer TEXT NOT NULL UNIQUE, added_utc TEXT NOT NULL,
    digest TEXT NOT NULL
) STRICT;

CREATE TABLE sittings (
    seq INTEGER PRIMARY KEY,
    observer TEXT NOT NULL REFERENCES observers (observer),
    session INTEGER NOT NULL CHECK (session >= 1),
    study_sha256 TEXT NOT NULL, local_date TEXT NOT NULL, started_utc TEXT NOT NULL,
    generator TEXT NOT NULL, order_seed TEXT NOT NULL, sides_seed TEXT NOT NULL,
    scene_rule TEXT NOT NULL, plan_sha256 TEXT NOT NULL,
    renderer TEXT NOT NULL, display TEXT NOT NULL, timing_grade TEXT NOT NULL,
    simulation TEXT, override_reason TEXT,
    digest TEXT NOT NULL,
    UNIQUE (observer, session)
) STRICT;

CREATE TABLE planned (
    seq INTEGER PRIMARY KEY,
    sitting INTEGER NOT NULL REFERENCES sittings (seq),
    trial INTEGER NOT NULL CHECK (trial >= 1),
    phase TEXT NOT NULL CHECK (phase IN ('training', 'warmup', 'main')),
    scene TEXT NOT NULL, variant TEXT NOT NULL,
    left_condition TEXT NOT NULL, right_condition TEXT NOT NULL,
    digest TEXT NOT NULL,
    UNIQUE (sitting, trial)
) STRICT;

CREATE TABLE shown (
    seq INTEGER PRIMARY KEY,
    sitting INTEGER NOT NULL, trial INTEGER NOT NULL,
    presentation INTEGER NOT NULL CHECK (presentation >= 1),
    onset_ns INTEGER NOT NULL, onset_source TEXT NOT NULL, onset_utc TEXT NOT NULL,
    grey_ns INTEGER NOT NULL, extra_ns INTEGER NOT NULL,
    digest TEXT NOT NULL,
    UNIQUE (sitting, trial, presentation),
    FOREIGN KEY (sitting, trial) REFERENCES planned (sitting, trial)
) STRICT;

CREATE TABLE votes (
    seq INTEGER PRIMARY KEY,
    sitting INTEGER NOT NULL, trial INTEGER NOT NULL,
    chosen TEXT NOT NULL CHECK (chosen IN ('left', 'right', 'tie')),
    rt_ms INTEGER NOT NULL CHECK (rt_ms >= 0),
    onset_ns INTEGER NOT NULL, key_ns INTEGER NOT NULL, onset_utc TEXT NOT NULL,
    device TEXT NOT NULL, key_name TEXT NOT NULL,
    early_keys INTEGER NOT NULL, held_key INTEGER NOT NULL CHECK (held_key IN (0, 1)),
    digest TEXT NOT NULL,
    UNIQUE (sitting, trial),
    FOREIGN KEY (sitting, trial) REFERENCES planned (sitting, trial)
) STRICT;

CREATE TABLE events (
    seq INTEGER PRIMARY KEY,
    sitting INTEGER NOT NULL REFERENCES sittings (seq),
    kind TEXT NOT NULL, detail TEXT NOT NULL, at_ns INTEGER NOT NULL, utc TEXT NOT NULL,
    digest TEXT NOT NULL
) STRICT;

CREATE TABLE finished (
    seq INTEGER PRIMARY KEY,
    sitting INTEGER NOT NULL UNIQUE REFERENCES sittings (seq),
    utc TEXT NOT NULL, digest TEXT NOT NULL
) STRICT;

-- The last link of the chain: without it, rows cut off at the end would leave no trace.
CREATE TABLE head (
    one INTEGER PRIMARY KEY CHECK (one = 1), seq INTEGER NOT NULL, digest TEXT NOT NULL
) STRICT;
INSERT INTO head VALUES (1, 0, '');

CREATE VIEW long_votes AS
    SELECT study.id AS study, sittings.observer, sittings.session, votes.trial,
           planned.scene, planned.variant,
           planned.left_condition AS "left", planned.right_condition AS "right",
           votes.chosen, votes.rt_ms, votes.onset_utc,
           sittings.simulation IS NOT NULL AS simulated
    FROM votes
    JOIN planned USING (sitting, trial)
    JOIN sittings ON sittings.seq = votes.sitting
    JOIN observers ON observers.observer = sittings.observer
    JOIN study
    ORDER BY observers.seq, sittings.session, votes.trial;
)sql";

// What version 2 has and version 1 has not.
constexpr auto additions = R"sql(
CREATE TABLE answers (
    seq INTEGER PRIMARY KEY,
    observer TEXT NOT NULL REFERENCES observers (observer),
    question TEXT NOT NULL, answer TEXT NOT NULL, utc TEXT NOT NULL,
    digest TEXT NOT NULL
) STRICT;

-- A vote's grade, where the study asks for grades: of the right picture, -3 to 3.
CREATE TABLE grades (
    seq INTEGER PRIMARY KEY,
    sitting INTEGER NOT NULL, trial INTEGER NOT NULL,
    grade INTEGER NOT NULL CHECK (grade BETWEEN -3 AND 3),
    digest TEXT NOT NULL,
    UNIQUE (sitting, trial)
) STRICT;

CREATE TABLE frames (
    seq INTEGER PRIMARY KEY,
    sitting INTEGER NOT NULL, trial INTEGER NOT NULL, presentation INTEGER NOT NULL,
    what TEXT NOT NULL, due_ns INTEGER NOT NULL, done_ns INTEGER NOT NULL,
    late INTEGER NOT NULL CHECK (late >= 0),
    digest TEXT NOT NULL
) STRICT;

-- Who left, without saying who: the digest is over the study's id and the pseudonym.
CREATE TABLE tombstones (
    seq INTEGER PRIMARY KEY,
    utc TEXT NOT NULL, reason TEXT NOT NULL, observer_sha256 TEXT NOT NULL,
    row_count INTEGER NOT NULL, vote_count INTEGER NOT NULL, removed_sha256 TEXT NOT NULL,
    digest TEXT NOT NULL
) STRICT;

-- The places in the chain of rows that a tombstone stands for; without them it would be broken.
CREATE TABLE removed (
    seq INTEGER PRIMARY KEY, tombstone INTEGER NOT NULL, digest TEXT NOT NULL
) STRICT;
)sql";

const std::vector<std::string>& tables_of_version_1() {
    static const std::vector<std::string> names{"study", "observers", "sittings", "planned",
                                                "shown", "votes",     "events",   "finished"};
    return names;
}

const std::vector<std::string>& tables_of_version_2() {
    static const std::vector<std::string> names{"answers", "grades", "frames", "tombstones"};
    return names;
}

std::string guards_sql(const std::vector<std::string>& guarded) {
    std::string sql;
    for (const auto& table : guarded)
        for (const auto& guard : guards(table))
            sql += guard.sql;
    return sql;
}

std::string stamp_sql() {
    return fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {};", application_id,
                       schema_version);
}

} // namespace

const std::vector<std::string>& chained_tables() {
    static const auto names = [] {
        auto all = tables_of_version_1();
        all.insert(all.end(), tables_of_version_2().begin(), tables_of_version_2().end());
        return all;
    }();
    return names;
}

std::vector<Guard> guards(const std::string& table) {
    std::vector<Guard> both;
    for (const auto* change : {"UPDATE", "DELETE"}) {
        auto name = fmt::format("{}_keeps_from_{}", table, change);
        auto sql = fmt::format("CREATE TRIGGER {} BEFORE {} ON {} BEGIN SELECT RAISE(ABORT, 'the "
                               "vote store is append-only'); END;\n",
                               name, change, table);
        both.push_back({std::move(name), std::move(sql)});
    }
    return both;
}

std::string upgrade_sql() {
    return additions + guards_sql(tables_of_version_2()) + guards_sql({"removed"}) + stamp_sql();
}

std::string stand_ins_sql() {
    std::string sql = additions;
    constexpr std::string_view made = "CREATE TABLE";
    for (auto at = sql.find(made); at != std::string::npos; at = sql.find(made, at + made.size()))
        sql.replace(at, made.size(), "CREATE TEMP TABLE");
    return sql;
}

std::string schema_sql() {
    return tables + guards_sql(tables_of_version_1()) + upgrade_sql();
}

} // namespace experiment::store
