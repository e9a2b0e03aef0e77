// Reads by descent, keeps the line of every value, and runs nothing.
#include "analysis/formats/literals.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace analysis::formats {

namespace {

constexpr int most_nested = 100; // brackets in one another: the reader calls itself for each

bool is_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

void append_utf8(std::string& text, unsigned code) {
    const auto tail = [&](unsigned shift) {
        text += static_cast<char>(0x80U | (code >> shift & 0x3FU));
    };
    if (code < 0x80) {
        text += static_cast<char>(code);
    } else if (code < 0x800) {
        text += static_cast<char>(0xC0U | code >> 6U);
        tail(0);
    } else if (code < 0x10000) {
        text += static_cast<char>(0xE0U | code >> 12U);
        tail(6);
        tail(0);
    } else {
        text += static_cast<char>(0xF0U | code >> 18U);
        tail(12);
        tail(6);
        tail(0);
    }
}

class Reader {
  public:
    Reader(std::string_view text, std::int64_t line) : text_(text), line_(line) {
        if (text_.starts_with("\xEF\xBB\xBF"))
            at_ = 3;
    }

    std::optional<Literal> whole() {
        auto value = literal(0);
        if (!value)
            return std::nullopt;
        skip_space();
        if (at_ < text_.size())
            return fail(fmt::format("{} after the end", seen()));
        return value;
    }

    std::optional<Literal> assignments() {
        Literal file;
        file.kind = Literal::Kind::Map;
        file.line = line_;
        for (skip_space(); at_ < text_.size(); skip_space()) {
            Literal name;
            name.kind = Literal::Kind::Text;
            name.line = line_;
            name.text = word();
            if (name.text.empty())
                return fail(fmt::format("{}, expected a name and =", seen()));
            skip_space();
            if (!take('='))
                return fail(fmt::format("{} after '{}', expected =", seen(), name.text));
            auto value = literal(0);
            if (!value)
                return std::nullopt;
            file.entries.emplace_back(std::move(name), std::move(*value));
        }
        return file;
    }

    bool begins_with_map() {
        skip_space();
        return at_ < text_.size() && text_[at_] == '{';
    }

    std::string fault(const std::string& name) const {
        return fmt::format("{}:{}: {}", name, line_, fault_);
    }

  private:
    std::nullopt_t fail(std::string what) {
        fault_ = std::move(what);
        return std::nullopt;
    }

    std::string seen() const {
        if (at_ >= text_.size())
            return "the file ends";
        const auto c = static_cast<unsigned char>(text_[at_]);
        return c < 0x20 || c >= 0x7F ? fmt::format("byte {}", c) : fmt::format("'{}'", text_[at_]);
    }

    bool take(char c) {
        if (at_ >= text_.size() || text_[at_] != c)
            return false;
        ++at_;
        return true;
    }

    // Blanks, line breaks and comments.
    void skip_space() {
        for (; at_ < text_.size(); ++at_) {
            if (text_[at_] == '#')
                at_ = std::min(text_.find('\n', at_), text_.size());
            if (at_ == text_.size())
                return;
            if (text_[at_] == '\n')
                ++line_;
            else if (text_[at_] != ' ' && text_[at_] != '\t' && text_[at_] != '\r')
                return;
        }
    }

    std::string word() {
        const auto begin = at_;
        while (at_ < text_.size() && is_name(text_[at_]))
            ++at_;
        return std::string(text_.substr(begin, at_ - begin));
    }

    std::optional<Literal> literal(int nested) {
        skip_space();
        if (nested > most_nested)
            return fail(fmt::format("more than {} brackets in one another", most_nested));
        if (at_ >= text_.size())
            return fail("the file ends, expected a value");
        Literal value;
        value.line = line_;
        const char c = text_[at_];
        if (c == '{')
            return map(std::move(value), nested);
        if (c == '[' || c == '(')
            return list(std::move(value), nested);
        if (c == '"' || c == '\'')
            return quoted(std::move(value));
        if ((c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.')
            return number(std::move(value));
        return named(std::move(value));
    }

    std::optional<Literal> named(Literal value) {
        const auto begin = at_;
        const auto name = word();
        if (name == "True" || name == "true" || name == "False" || name == "false") {
            value.kind = Literal::Kind::Truth;
            value.number = name[0] == 'T' || name[0] == 't' ? 1 : 0;
            return value;
        }
        if (name == "None" || name == "null")
            return value;
        at_ = begin;
        return fail(name.empty() ? fmt::format("{}, expected a value", seen())
                                 : fmt::format("'{}', expected a value: a number, a text in "
                                               "quotes, a list or a map",
                                               name));
    }

    std::optional<Literal> number(Literal value) {
        value.kind = Literal::Kind::Number;
        at_ += text_[at_] == '+' ? 1 : 0;
        const char* begin = text_.data() + at_;
        const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value.number);
        const bool followed = end != text_.data() + text_.size() && (is_name(*end) || *end == '.');
        if (error != std::errc{} || followed || !std::isfinite(value.number))
            return fail("a number that cannot be read");
        at_ += static_cast<std::size_t>(end - begin);
        return value;
    }

    std::optional<unsigned> hexadecimal(std::size_t digits) {
        unsigned code = 0;
        if (at_ + digits > text_.size())
            return std::nullopt;
        const char* begin = text_.data() + at_;
        const auto [end, error] = std::from_chars(begin, begin + digits, code, 16);
        if (error != std::errc{} || end != begin + digits)
            return std::nullopt;
        at_ += digits;
        return code;
    }

    // \uD83D\uDE00 are two halves of one sign, as JSON writes it.
    std::optional<unsigned> sign(std::size_t digits) {
        const auto high = hexadecimal(digits);
        if (!high || *high < 0xD800 || *high > 0xDFFF)
            return high && *high <= 0x10FFFF ? high : std::nullopt;
        if (*high > 0xDBFF || !take('\\') || !take('u'))
            return std::nullopt;
        const auto low = hexadecimal(4);
        if (!low || *low < 0xDC00 || *low > 0xDFFF)
            return std::nullopt;
        return 0x10000 + ((*high - 0xD800) << 10U) + (*low - 0xDC00);
    }

    bool escaped(std::string& text) {
        constexpr std::string_view letters = "ntrbf\\'\"/", meant = "\n\t\r\b\f\\'\"/";
        const char c = text_[at_++];
        if (const auto found = letters.find(c); found != letters.npos) {
            text += meant[found];
            return true;
        }
        if (c != 'u' && c != 'U' && c != 'x')
            return false;
        const auto code = sign(c == 'u' ? 4 : c == 'U' ? 8 : 2);
        if (code)
            append_utf8(text, *code);
        return code.has_value();
    }

    std::optional<Literal> quoted(Literal value) {
        value.kind = Literal::Kind::Text;
        const char quote = text_[at_++];
        while (at_ < text_.size() && text_[at_] != quote && text_[at_] != '\n') {
            const char c = text_[at_++];
            if (c != '\\') {
                value.text += c;
            } else if (at_ >= text_.size() || !escaped(value.text)) {
                return fail("a backslash before what is no sign");
            }
        }
        if (!take(quote))
            return fail("a text that does not close its quotes on its line");
        return value;
    }

    std::optional<Literal> list(Literal value, int nested) {
        value.kind = Literal::Kind::List;
        const char close = text_[at_++] == '[' ? ']' : ')';
        for (skip_space(); !take(close); skip_space()) {
            auto item = literal(nested + 1);
            if (!item)
                return std::nullopt;
            value.items.push_back(std::move(*item));
            skip_space();
            if (!take(',') && (at_ >= text_.size() || text_[at_] != close))
                return fail(fmt::format("{}, expected a comma or {}", seen(), close));
        }
        return value;
    }

    std::optional<Literal> map(Literal value, int nested) {
        value.kind = Literal::Kind::Map;
        ++at_;
        for (skip_space(); !take('}'); skip_space()) {
            auto key = literal(nested + 1);
            if (!key)
                return std::nullopt;
            skip_space();
            if (!take(':'))
                return fail(fmt::format("{}, expected a colon after a key", seen()));
            auto item = literal(nested + 1);
            if (!item)
                return std::nullopt;
            value.entries.emplace_back(std::move(*key), std::move(*item));
            skip_space();
            if (!take(',') && (at_ >= text_.size() || text_[at_] != '}'))
                return fail(fmt::format("{}, expected a comma or }}", seen()));
        }
        return value;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::int64_t line_;
    std::string fault_;
};

} // namespace

const Literal* Literal::find(std::string_view key) const {
    for (const auto& [name, value] : entries)
        if (name.kind == Kind::Text && name.text == key)
            return &value;
    return nullptr;
}

protocols::Expected<Literal>
read_literal(std::string_view text, const std::string& name, std::int64_t first_line) {
    Reader reader(text, first_line);
    auto value = reader.whole();
    if (!value)
        return tl::unexpected(reader.fault(name));
    return std::move(*value);
}

protocols::Expected<Literal> read_literal_file(std::string_view text, const std::string& name) {
    Reader reader(text, 1);
    auto value = reader.begins_with_map() ? reader.whole() : reader.assignments();
    if (!value)
        return tl::unexpected(reader.fault(name));
    return std::move(*value);
}

} // namespace analysis::formats
