// Numbers as a reader wants them: few digits, a real minus sign, a dash for what is not defined,
// and no line break inside.
// All digits are in findings.json.
#pragma once

#include <string>

namespace experiment::report {

/// What stands where a number is not defined.
inline constexpr const char* no_number = "\u2013";

/// With so many decimals: "2.17", "\u22120.50".
std::string decimal(double value, int decimals);

/// With so many significant digits, powers of ten only where they are needed: "59.34", "0.0041",
/// "6.6 \u00d7 10\u207b\u00b9\u00b2".
std::string significant(double value, int digits);

/// Degrees of freedom: whole where they are, else two decimals.
std::string degrees(double df);

/// A p-value: three decimals down to 0.001, two significant digits below; `log10_p` speaks where
/// p is too small for a double.
std::string p_value(double p, double log10_p);
std::string p_value(double p);

/// The same with its relation, for sentences: "p = 0.033", "p = 5.2 \u00d7 10\u207b\u00b9\u00b2".
std::string p_equals(double p, double log10_p);
std::string p_equals(double p);

/// A share of 0..1 in whole percent: "72 %".
std::string percent(double share);

/// Halves of votes as votes: "585", "12.5".
std::string votes(double count);

/// A whole number with thin spaces between thousands: "1 620".
std::string grouped(long long count);

} // namespace experiment::report
