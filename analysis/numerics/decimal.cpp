// One pass over the characters; zeros in front cost no digits.
#include "analysis/numerics/decimal.h"

#include <fmt/format.h>

#include <cstdlib>

namespace analysis::numerics {
namespace {

constexpr int most_digits = 38; // 10^38 < 2^127
constexpr int most_exponent = 4000;

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

class Reader {
  public:
    explicit Reader(std::string_view text) : text_(text) {}

    protocols::Expected<Decimal> read() {
        const bool negative = sign();
        integer_and_fraction();
        if (digits_seen_ == 0)
            return wrong("a digit");
        if (significant_ > most_digits)
            return tl::make_unexpected(fmt::format("'{}' has {} digits, expected at most {}", text_,
                                                   significant_, most_digits));
        if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
            ++at_;
            if (!exponent())
                return wrong("a digit of the exponent");
        }
        if (at_ < text_.size())
            return wrong("the end of a number");
        if (std::abs(value_.exponent) > most_exponent)
            return tl::make_unexpected(
                fmt::format("'{}' has exponent {}, expected between -{} and {}", text_,
                            value_.exponent, most_exponent, most_exponent));
        if (negative)
            value_.mantissa = -value_.mantissa;
        return value_;
    }

  private:
    tl::unexpected<std::string> wrong(const char* expected) const {
        const auto found = at_ < text_.size() ? fmt::format("'{}'", text_[at_]) : "nothing";
        return tl::make_unexpected(
            fmt::format("'{}', column {}: found {}, expected {}", text_, at_ + 1, found, expected));
    }

    bool sign() {
        if (at_ == text_.size() || (text_[at_] != '-' && text_[at_] != '+'))
            return false;
        return text_[at_++] == '-';
    }

    void integer_and_fraction() {
        bool after_point = false;
        for (; at_ < text_.size(); ++at_) {
            if (text_[at_] == '.' && !after_point) {
                after_point = true;
                continue;
            }
            if (!is_digit(text_[at_]))
                return;
            ++digits_seen_;
            if (significant_ > 0 || text_[at_] != '0')
                ++significant_;
            if (significant_ <= most_digits)
                value_.mantissa = value_.mantissa * 10 + (text_[at_] - '0');
            if (after_point)
                --value_.exponent;
        }
    }

    bool exponent() {
        const bool negative = sign();
        int read = 0;
        const std::size_t first = at_;
        for (; at_ < text_.size() && is_digit(text_[at_]); ++at_)
            read = read > 100000 ? read : read * 10 + (text_[at_] - '0');
        value_.exponent += negative ? -read : read;
        return at_ > first;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int digits_seen_ = 0;
    int significant_ = 0;
    Decimal value_;
};

} // namespace

protocols::Expected<Decimal> parse_decimal(std::string_view text) {
    return Reader(text).read();
}

} // namespace analysis::numerics
