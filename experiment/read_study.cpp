// The one place where a study file meets the renderer's names.
#include "experiment/read_study.h"

#include "analysis/utf8.h"
#include "experiment/reference_dials.h"
#include "experiment/text_files.h"
#include "protocols/calibration.h"
#include "protocols/digest.h"
#include "renderer/materials.h"
#include "renderer/methods/catalogue.h"

#include <fmt/core.h>

#include <cstdlib>
#include <sstream>

namespace experiment {

namespace fs = std::filesystem;

namespace {

fs::path model_cache() {
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache != '\0')
        return fs::path(cache) / "pairlight" / "models";
    const char* home = std::getenv("HOME");
    return fs::path(home != nullptr ? home : "/") / ".cache" / "pairlight" / "models";
}

// A measured curve, and the surround by it.
tl::expected<void, std::string> read_calibration(const StudyFolder& folder,
                                                 protocols::Study& study) {
    auto& eotf = study.display.eotf;
    if (eotf.kind != protocols::Eotf::Kind::Measured)
        return {};
    const auto file = folder.root / eotf.file;
    const auto text = read_text_file(file);
    if (!text)
        return tl::unexpected(text.error() + "; `pairlight photometer` makes it");
    auto steps = protocols::parse_photometer(*text, file.string());
    if (!steps)
        return tl::unexpected(steps.error());
    eotf.steps = std::move(*steps);
    study.surround = protocols::surround_of(study.surround.definition, eotf).value();
    return {};
}

} // namespace

protocols::KnownNames known_names() {
    protocols::KnownNames known{.materials = renderer::measured_names()};
    for (const auto& method : renderer::methods::catalogue()) {
        known.methods.push_back(method.name);
        if (!method.caveat.empty())
            known.caveats[method.name] = method.caveat;
    }
    known.methods.emplace_back(reference_method);
    known.complete = [](const std::string& method, const protocols::Dials& given) {
        const auto completed = method == reference_method
                                   ? renderer::methods::complete(reference_dials(), given)
                                   : renderer::methods::complete_for(method, given);
        return completed.map_error([](const renderer::methods::DialProblem& problem) {
            return protocols::DialProblem{problem.dial, problem.what};
        });
    };
    return known;
}

tl::expected<LoadedStudy, std::string> read_study(const fs::path& path) {
    const auto folder = study_folder(path);
    if (!fs::exists(folder.study_file()))
        return tl::unexpected(fmt::format("{}: there is no study; `pairlight init {}` makes one",
                                          folder.study_file().string(), folder.root.string()));
    const auto text = read_text_file(folder.study_file());
    if (!text)
        return tl::unexpected(text.error());
    auto study = protocols::parse_study(*text, folder.study_file().string(), known_names());
    if (!study)
        return tl::unexpected(study.error());
    if (auto measured = read_calibration(folder, *study); !measured)
        return tl::unexpected(measured.error());
    return LoadedStudy{folder, std::move(*study), protocols::sha256_hexadecimal(*text)};
}

std::vector<fs::path> files_of(const LoadedStudy& loaded) {
    const auto& [folder, study, digest] = loaded;
    std::vector<fs::path> files{folder.study_file(), folder.root / study.instructions.file,
                                folder.manifest(), folder.votes()};
    if (study.display.eotf.kind == protocols::Eotf::Kind::Measured)
        files.push_back(folder.root / study.display.eotf.file);
    return files;
}

tl::expected<std::string, std::string> read_instructions(const LoadedStudy& loaded) {
    const auto file = loaded.folder.root / loaded.study.instructions.file;
    auto text = read_text_file(file);
    if (const auto fault = analysis::utf8_fault(text.value_or(""), file.string()); !fault.empty())
        return tl::unexpected(fault);
    if (text && text->find_first_not_of(" \t\r\n") == std::string::npos)
        return tl::unexpected(
            fmt::format("{}: is empty; observers need written instructions", file.string()));
    return text;
}

std::vector<fs::path> model_folders(const StudyFolder& folder) {
    std::vector<fs::path> folders{folder.root / "models"};
    const char* given = std::getenv("PAIRLIGHT_MODELS");
    if (given == nullptr || *given == '\0') {
        folders.push_back(model_cache());
        return folders;
    }
    std::istringstream list(given);
    for (std::string one; std::getline(list, one, ':');)
        if (!one.empty())
            folders.emplace_back(one);
    return folders;
}

} // namespace experiment
