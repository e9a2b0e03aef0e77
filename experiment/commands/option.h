// An option of a command, and what its values have to be.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class Option;
}

namespace experiment::commands {

/// A handle of the option, which lives as long as the command line does.  What is asked of its
/// values is said in a row, and holds for each of them where it takes several.
class Option {
  public:
    explicit Option(CLI::Option* option) : option_(option) {}

    /// What each value of a kind has to be; an option that holds such values asks for it itself.
    /// Whole numbers are decimal, with leading zeros or without.
    Option holds_int();
    Option holds_unsigned();
    Option holds_number();
    /// Empty text is refused, for it would be as good as no option.
    Option holds_text();

    /// Empty text has a meaning of its own.
    Option may_be_empty();

    Option required();
    Option excludes(Option other);

    /// The help says what holds without it.
    Option shows_default();

    /// The help names the kind of value in this way.
    Option shown_as(const std::string& kind);

    /// One word may hold several values.
    Option separated_by(char mark);

    /// A number of the range; both ends belong to it and NaN does not.
    Option within(double least, double most);

    /// One of `words`; to whoever misspells one, the nearest is offered.
    Option one_of(const std::vector<std::string>& words);

    /// Something other than blanks: "expected <wanted>", which says more than "a text".
    Option not_blank(const std::string& wanted);

    /// A folder, or what the names of several files begin with: "-" is standard output, which is
    /// neither.
    Option not_standard_output();

    Option existing_folder();

  private:
    void drop_text_check();

    CLI::Option* option_;
};

} // namespace experiment::commands
