// The body of the page while it grows, with everything in it numbered.
#pragma once

#include "experiment/report/contents.h"
#include "experiment/report/figures.h"

#include <string>

namespace experiment::report {

/// Every caption passes through here, so none can forget to say that votes are simulated.
/// Errors: `contents` must outlive the body.
class Body {
  public:
    explicit Body(const ReportContents& contents) : contents_(contents) {}

    /// Markup as it is.
    void add(const std::string& markup) { markup_ += markup; }

    // Text, escaped here.
    void heading(const std::string& text);
    void subheading(const std::string& text);
    void paragraph(const std::string& text, const std::string& kind = "");

    /// The findings' notes on one subject.
    void notes(const std::string& about);

    void table(const std::string& text, const std::string& markup);
    void figure(const Figure& figure);

    const std::string& markup() const { return markup_; }

  private:
    void captioned(const std::string& number, const std::string& text, const std::string& content);

    const ReportContents& contents_;
    std::string markup_;
    int tables_ = 0;
    int figures_ = 0;
};

} // namespace experiment::report
