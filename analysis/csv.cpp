#include "analysis/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <vector>

namespace analysis {

namespace {

// One record at a time; quoted fields with doubled quotes are unfolded into `unfolded_`.
class Records {
  public:
    explicit Records(std::string_view text) : text_(text) {
        if (text_.starts_with("\xEF\xBB\xBF"))
            at_ = 3;
        const auto first = text_.substr(0, text_.find_first_of("\r\n"));
        if (first.find('\t') != first.npos)
            separator_ = '\t';
        else if (first.find(',') == first.npos && first.find(';') != first.npos)
            separator_ = ';';
    }

    std::int64_t line() const { return first_line_; }

    std::span<const std::string_view> fields() const { return fields_; }

    /// False at the end of the text; `wrong` is set when the record is malformed.
    bool next(std::string& wrong) {
        fields_.clear();
        unfolded_.clear();
        first_line_ = line_;
        if (at_ >= text_.size())
            return false;
        do
            fields_.push_back(at_ < text_.size() && text_[at_] == '"' ? quoted(wrong) : plain());
        while (wrong.empty() && separator(wrong));
        return true;
    }

  private:
    // A plain loop: searching for a set of characters costs three times as much on short fields.
    std::string_view plain() {
        const auto first = at_;
        while (at_ < text_.size() && text_[at_] != separator_ && text_[at_] != '\n' &&
               text_[at_] != '\r')
            ++at_;
        return text_.substr(first, at_ - first);
    }

    std::string_view quoted(std::string& wrong) {
        auto& value = unfolded_.emplace_back();
        for (++at_; at_ < text_.size(); ++at_) {
            if (text_[at_] == '\n')
                ++line_;
            if (text_[at_] != '"') {
                value += text_[at_];
            } else if (at_ + 1 < text_.size() && text_[at_ + 1] == '"') {
                value += '"';
                ++at_;
            } else {
                ++at_;
                return value;
            }
        }
        wrong = "a quoted field does not end, expected a closing \"";
        return value;
    }

    /// Steps over a separator (true) or a line end (false).
    bool separator(std::string& wrong) {
        if (at_ >= text_.size())
            return false;
        if (text_[at_] == separator_) {
            ++at_;
            return true;
        }
        if (text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n')
            ++at_;
        else if (text_[at_] != '\n' && text_[at_] != '\r')
            wrong = fmt::format(
                "'{}' after a closing quote, expected a comma or the end of the line", text_[at_]);
        ++at_;
        ++line_;
        return false;
    }

    std::string_view text_;
    char separator_ = ',';
    std::size_t at_ = 0;
    std::int64_t line_ = 1;
    std::int64_t first_line_ = 1;
    std::vector<std::string_view> fields_;
    std::deque<std::string> unfolded_; // views into it must survive growth
};

} // namespace

protocols::Expected<std::int64_t>
read_csv(std::string_view text, const std::string& name, const RecordReader& record) {
    Records records(text);
    std::int64_t count = 0;
    std::string wrong;
    while (records.next(wrong)) {
        const auto fields = records.fields();
        const bool blank = fields.size() == 1 && fields[0].empty();
        if (wrong.empty() && !blank)
            wrong = record(records.line(), fields);
        if (!wrong.empty())
            return tl::unexpected(fmt::format("{}:{}: {}", name, records.line(), wrong));
        count += blank ? 0 : 1;
    }
    return count;
}

std::string csv_field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos)
        return std::string(text);
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

} // namespace analysis
