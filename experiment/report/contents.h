// Everything a report shows, as one value: the page is a function of it.
#pragma once

#include "analysis/findings.h"
#include "experiment/cost/cost_report.h"
#include "protocols/vocabulary.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace experiment::report {

/// One line of a list of facts.  No value: it is printed as "not recorded".
struct Fact {
    std::string name;
    std::optional<std::string> value;
    bool operator==(const Fact&) const = default;
};

struct FactList {
    std::string heading;
    std::vector<Fact> facts;
};

/// One sitting, as a row of text.
struct SittingRow {
    std::string observer; ///< pseudonym
    int session = 1;
    std::string date;
    std::string duration; ///< as people read it; "" for one that was not finished
    int votes = 0;
    std::string
        timing_grade;        ///< at the end; of an unfinished sitting, as promised at its beginning
    std::string late_frames; ///< "3 of 1200"; "" where the display keeps no time to be late by
    std::string order_seed;
    std::string sides_seed;
    bool simulated = false;
};

/// A stimulus, small enough to be carried in the page.
struct Thumbnail {
    protocols::Picture picture;
    std::string png; ///< the bytes of a PNG file
    int width = 0, height = 0;
};

/// What equalising the brightness did to a picture.  Linear luminances, 1 = reference white.
struct BrightnessRow {
    protocols::Picture picture;
    double mean_before = 0;
    double target = 0;
    double gain = 1;
    double clipped_share = 0; ///< 0..1 of the object's pixels
};

/// Names as people read them, by the names the data has.  What has no label is shown by its name.
struct Labels {
    std::map<std::string, std::string> conditions;
    std::map<std::string, std::string> scenes;
    std::map<std::string, std::string> variants;
};

struct ReportContents {
    std::string title;
    std::string question;     ///< what observers were asked; "" when unknown
    std::string written_on;   ///< date, YYYY-MM-DD
    std::size_t screened = 0; ///< observers on record as having passed the screening
    analysis::Findings findings;
    Labels labels;
    std::vector<FactList> facts; ///< design, sessions, and what BT.500 wants a report to contain
    std::vector<SittingRow> sittings;
    std::vector<Thumbnail> thumbnails; ///< in the order of scenes and variants
    std::vector<BrightnessRow> brightness;
    std::optional<cost::CostReport> cost; ///< of `pairlight cost`, if it was run
};

/// The label of `name`, or the name where there is none.
std::string labelled(const std::map<std::string, std::string>& labels, const std::string& name);

/// The label of a condition, by its place in `findings.design.conditions`.
std::string condition_label(const ReportContents& contents, std::size_t condition);

/// The label of a level of a scene factor: scenes and variants have labels, other factors do not.
std::string
level_label(const ReportContents& contents, std::size_t factor, const std::string& level);

} // namespace experiment::report
