// A range for options that numbers have to lie in: unlike CLI11's own, NaN does not.
#pragma once

namespace CLI {
class Validator;
}

namespace experiment::commands {

/// Both ends belong to it.
CLI::Validator within(double least, double most);

} // namespace experiment::commands
