// A SQLite file, through its C interface.
#include "experiment/store/sqlite_database.h"

#include "protocols/contract.h"

#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/vfs.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <thread>
#include <utility>

namespace experiment::store {

namespace {

constexpr int busy_timeout_ms = 2000;

constexpr int looks_at_a_log = 25; // half a second

struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};

using Statement = std::unique_ptr<sqlite3_stmt, Finalize>;

int bind(sqlite3_stmt* statement, int position, const Value& value) {
    if (const auto* number = std::get_if<std::int64_t>(&value))
        return sqlite3_bind_int64(statement, position, *number);
    if (const auto* text = std::get_if<std::string>(&value))
        return sqlite3_bind_text64(statement, position, text->data(), text->size(),
                                   SQLITE_TRANSIENT, SQLITE_UTF8);
    return sqlite3_bind_null(statement, position);
}

Value column(sqlite3_stmt* statement, int index) {
    switch (sqlite3_column_type(statement, index)) {
    case SQLITE_NULL:
        return std::monostate{};
    case SQLITE_INTEGER:
        return std::int64_t{sqlite3_column_int64(statement, index)};
    default: {
        const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement, index));
        const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement, index));
        return text ? std::string(text, size) : std::string();
    }
    }
}

// A log is shared through memory, which the machines of a network do not share.
bool is_on_a_network(const std::filesystem::path& file) {
    // NFS, SMB, CIFS, SMB2, AFS, Ceph, 9P, and what FUSE may bring from anywhere: statfs(2).
    constexpr std::array<std::uint32_t, 8> kinds{0x6969,     0x517B,     0xFF534D42, 0xFE534D42,
                                                 0x5346414F, 0x00C36400, 0x01021997, 0x65735546};

    struct statfs about {};

    return statfs(file.c_str(), &about) != 0 ||
           std::ranges::count(kinds, static_cast<std::uint32_t>(about.f_type)) > 0;
}

// What the person can do about it, by SQLite's result code.
std::string remedy(int code, const char* message) {
    switch (code) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        return "another program is writing to it; end that program or wait for it, then try again";
    case SQLITE_READONLY:
        return "cannot be written: the file or its folder is read-only";
    case SQLITE_CANTOPEN:
        return "cannot be opened or written; expected a folder that exists and may be written in";
    case SQLITE_NOTADB:
    case SQLITE_CORRUPT:
        return fmt::format("is damaged or not a vote store ({}); expected the file as it was "
                           "written, restore it from a copy",
                           message);
    case SQLITE_FULL:
        return "the disk is full; make room and try again";
    case SQLITE_IOERR:
        return fmt::format("the disk failed ({}); check it before going on", message);
    default:
        return message;
    }
}

} // namespace

SqliteDatabase::SqliteDatabase(std::filesystem::path file, WhenMissing when_missing)
    : file_(std::move(file)) {
    sqlite3* opened = nullptr;
    const int flags = SQLITE_OPEN_READWRITE |
                      (when_missing == WhenMissing::Create ? SQLITE_OPEN_CREATE : 0) |
                      SQLITE_OPEN_EXRESCODE;
    const int code = sqlite3_open_v2(file_.c_str(), &opened, flags, nullptr);
    database_.reset(opened);
    if (code != SQLITE_OK)
        throw failure();
    sqlite3_busy_timeout(opened, busy_timeout_ms);
    execute("PRAGMA foreign_keys = ON; PRAGMA synchronous = EXTRA; PRAGMA trusted_schema = OFF");
    touch();
}

// The first look at the file opens its log.  Another program that is just bringing the log into the
// file may take it away in between: SQLite then says that it cannot be opened, and the next look
// finds it gone or new.
void SqliteDatabase::touch() {
    for (int look = 0; look < looks_at_a_log; ++look) {
        const int code =
            sqlite3_exec(database_.get(), "PRAGMA schema_version", nullptr, nullptr, nullptr);
        if ((code & 0xff) != SQLITE_CANTOPEN)
            return; // whatever else is wrong, the first statement will say
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

// Where another program still has the file open, the log is left to it.
void SqliteDatabase::Close::operator()(sqlite3* database) const {
    if (ends_the_log) {
        sqlite3_busy_timeout(database, 0);
        sqlite3_exec(database, "PRAGMA journal_mode = DELETE", nullptr, nullptr, nullptr);
    }
    sqlite3_close_v2(database);
}

std::string SqliteDatabase::journal_mode() const {
    return text_of(query("PRAGMA journal_mode")[0][0]);
}

// The log is brought into the file at the end, not in the middle of a sitting, where it would make
// one vote in fifty wait.
void SqliteDatabase::write_ahead() {
    if (is_on_a_network(file_))
        return;
    sqlite3_exec(database_.get(), "PRAGMA wal_autocheckpoint = 0; PRAGMA journal_mode = WAL",
                 nullptr, nullptr, nullptr);
    database_.get_deleter().ends_the_log = true;
}

void SqliteDatabase::keep_in_one_file() {
    execute("PRAGMA journal_mode = DELETE");
    if (journal_mode() == "wal")
        throw complaint(remedy(SQLITE_BUSY, ""));
}

DatabaseError SqliteDatabase::complaint(const std::string& message) const {
    return DatabaseError(fmt::format("{}: {}", file_.string(), message));
}

DatabaseError SqliteDatabase::failure() const {
    return complaint(remedy(sqlite3_errcode(database_.get()) & 0xff, // the primary code
                            sqlite3_errmsg(database_.get())));
}

std::vector<Row> SqliteDatabase::query(const std::string& sql, const Row& parameters) const {
    sqlite3_stmt* prepared = nullptr;
    if (sqlite3_prepare_v2(database_.get(), sql.c_str(), -1, &prepared, nullptr) != SQLITE_OK)
        throw failure();
    const Statement statement(prepared);
    EXPECTS(sqlite3_bind_parameter_count(prepared) == static_cast<int>(parameters.size()));
    for (std::size_t i = 0; i < parameters.size(); ++i)
        if (bind(prepared, static_cast<int>(i) + 1, parameters[i]) != SQLITE_OK)
            throw failure();
    std::vector<Row> rows;
    int code = sqlite3_step(prepared);
    for (; code == SQLITE_ROW; code = sqlite3_step(prepared)) {
        Row& row = rows.emplace_back();
        for (int i = 0; i < sqlite3_column_count(prepared); ++i)
            row.push_back(column(prepared, i));
    }
    if (code != SQLITE_DONE)
        throw failure();
    return rows;
}

void SqliteDatabase::execute(const std::string& sql) {
    if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
        throw failure();
}

void SqliteDatabase::in_transaction(const std::function<void()>& work) {
    execute("BEGIN IMMEDIATE");
    try {
        work();
        execute("COMMIT");
    } catch (...) {
        // Some failures (a full disk) have rolled back already; a second ROLLBACK would only say
        // so.
        sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
        throw;
    }
}

bool SqliteDatabase::is_read_only() const {
    return sqlite3_db_readonly(database_.get(), "main") == 1;
}

std::int64_t integer_of(const Value& value) {
    return std::get<std::int64_t>(value);
}

const std::string& text_of(const Value& value) {
    return std::get<std::string>(value);
}

} // namespace experiment::store
