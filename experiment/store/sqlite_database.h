// A SQLite file: statements in, rows out.  SQLite ends here.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

struct sqlite3;

namespace experiment::store {

/// What a column holds: nothing, an integer or a text.  The store needs no real numbers.
using Value = std::variant<std::monostate, std::int64_t, std::string>;
using Row = std::vector<Value>;

/// One line for the person at the keyboard, with the file's name first.
struct DatabaseError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

enum class WhenMissing { Fail, Create };

/// An open database file.  Writing waits two seconds for other writers, and a committed transaction
/// is on the disk (synchronous EXTRA), in the file or in the log beside it.  Whoever began a log
/// brings it into the file in the end, if nobody else has it open.  Every function throws
/// DatabaseError.
class SqliteDatabase {
  public:
    SqliteDatabase(std::filesystem::path file, WhenMissing when_missing);

    /// From now on commits go to a log, FILE-wal: one sync of the disk where the file alone needs
    /// four.  Nothing happens where that cannot be: on a network's file system, whose machines do
    /// not see each other's logs, or while another program reads.
    void write_ahead();

    /// Brings everything from the log into the file.
    /// Errors: another program has the file open.
    void keep_in_one_file();

    /// Runs one statement, its `?` filled in order, and returns its rows.
    std::vector<Row> query(const std::string& sql, const Row& parameters = {}) const;

    /// Runs a text of any number of statements.
    void execute(const std::string& sql);

    /// Runs `work` between BEGIN IMMEDIATE and COMMIT; whatever it throws undoes all of it.
    void in_transaction(const std::function<void()>& work);

    /// A line about this file, to throw.
    [[nodiscard]] DatabaseError complaint(const std::string& message) const;

    bool is_read_only() const;

    const std::filesystem::path& file() const { return file_; }

  private:
    struct Close {
        bool ends_the_log; ///< false until one is begun
        void operator()(sqlite3* database) const;
    };

    void touch();

    [[nodiscard]] DatabaseError failure() const;
    std::string journal_mode() const;

    std::filesystem::path file_;
    std::unique_ptr<sqlite3, Close> database_;
};

/// The columns of a row whose types the schema promises.  They throw std::bad_variant_access where
/// a damaged file breaks the promise.
std::int64_t integer_of(const Value& value);
const std::string& text_of(const Value& value);

} // namespace experiment::store
