// What a report says of the study, its sessions and its circumstances, from what is on record.
#pragma once

#include "experiment/report/contents.h"
#include "experiment/stimuli/manifest.h"
#include "experiment/store/records.h"
#include "protocols/study.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace experiment::report {

/// What is on record about a study.
struct Records {
    protocols::Study study;
    std::string study_sha256; ///< of the study file
    std::string instructions; ///< the text observers read; "" when it could not be read
    std::optional<stimuli::Manifest> manifest;
    std::vector<store::Sitting> sittings;
    /// What was answered about each observer, in the order it was given.
    std::map<protocols::ObserverId, std::vector<store::Answer>> answers;
    std::set<protocols::ObserverId> screened; ///< who passed and has finished a sitting
};

/// A report without thumbnails.  `written_on` is a date, YYYY-MM-DD.  The facts are those that
/// Recommendation ITU-R BT.500 and good practice want told; what is not on record has no value.
ReportContents
report_contents(const Records& records, analysis::Findings findings, std::string written_on);

} // namespace experiment::report
