// What values of options have to be.
#pragma once

namespace CLI {
class Validator;
}

namespace experiment::commands {

/// A number of the range; both ends belong to it and, unlike in CLI11's own, NaN does not.
CLI::Validator within(double least, double most);

/// Something other than blanks: "expected <wanted>".
CLI::Validator not_blank(const char* wanted);

} // namespace experiment::commands
