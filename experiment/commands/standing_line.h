// The experimenter's view of a sitting: one line on the terminal.
#pragma once

#include "experiment/session/sitting.h"

#include <string>

namespace experiment::commands {

/// "P7K2: main trials, 12 of 54 answered, about 6 min left"
std::string standing_text(const std::string& observer, const session::Standing& standing);

/// Writes it to standard error: over itself on a terminal, elsewhere a line whenever the sitting
/// comes to something else.
class StandingLine {
  public:
    StandingLine(std::string observer, bool silent);
    ~StandingLine();
    StandingLine(const StandingLine&) = delete;
    StandingLine& operator=(const StandingLine&) = delete;

    void update(const session::Standing& standing);

  private:
    std::string observer_;
    bool silent_;
    bool terminal_;
    std::string doing_;
    std::size_t width_ = 0;
};

} // namespace experiment::commands
