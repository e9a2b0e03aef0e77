// pairlight display, timing-check, photometer and pages: what shows the pictures, looked at and
// measured.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/commands/sittings.h"
#include "experiment/commands/stimulus_files.h"
#include "experiment/stimuli/freshness.h"
#include "experiment/stimuli/scene_renderer.h"
#include "experiment/text_files.h"
#include "protocols/calibration.h"
#include "protocols/schedule.h"
#include "renderer/imaging/image_files.h"

#include <fmt/format.h>

#include <memory>

namespace experiment::commands {

namespace {

namespace fs = std::filesystem;
using session::Key;
using session::View;

struct Options {
    std::string study;
    std::string window;
    int monitor = 1;
    int swaps = 600;
    std::string csv;
    std::string folder;
    Voice voice;
};

void add_seat(Command& command, Options& options) {
    command.add_option("STUDY", options.study, "Study folder or its study.toml").required();
    command.add_option("--window", options.window,
                       "A window of this size, such as 1280x720, not the full screen");
    command.add_option("--monitor", options.monitor, "Which monitor; 1 is the primary one")
        .within(1, 1000);
    add_voice(command, options.voice);
}

/// A window that shows no pictures.
std::unique_ptr<session::WindowScreen> bare_window(const LoadedStudy& loaded,
                                                   const Options& options,
                                                   const session::Clock& clock,
                                                   int test_swaps) {
    auto window =
        window_options(loaded, {.size = window_size(options.window), .monitor = options.monitor});
    window.test_swaps = test_swaps;
    window.setting_up = true;
    return value_or_stop(session::open_window(
        window,
        [](const protocols::Picture&) -> tl::expected<renderer::gpu::Picture8, std::string> {
            return tl::unexpected(std::string("no pictures are shown here"));
        },
        clock));
}

/// Shows a page until its key is pressed.  False: Escape was.
bool shown_until_left(session::Screen& screen, const session::PageView& page) {
    value_or_stop(screen.show(page));
    while (true) {
        const auto input = screen.wait({});
        if (std::holds_alternative<session::CloseAsked>(input->what))
            return false;
        const auto* press = std::get_if<session::Pressed>(&input->what);
        if (press == nullptr || press->repeated)
            continue;
        if (press->key == page.advance || press->key == Key::Escape)
            return press->key != Key::Escape;
    }
}

void run_display(const Options& options) {
    const auto loaded = value_or_stop(read_study(options.study));
    const session::SystemClock clock;
    const auto screen = bare_window(loaded, options, clock, options.swaps);
    const auto facts = screen->facts();
    for (const auto& page : facts.setting_up)
        if (!shown_until_left(*screen, page))
            break;
    fmt::print("{}\n", facts.description);
}

void run_timing_check(const Options& options) {
    const auto loaded = value_or_stop(read_study(options.study));
    const session::SystemClock clock;
    const auto screen = bare_window(loaded, options, clock, 0);
    const auto intervals = screen->time_swaps(options.swaps);
    const auto test = session::judge_swaps(intervals, screen->nominal_hz());
    auto timing = screen->facts().timing;
    timing.verdict = test.verdict;
    fmt::print("swaps: {}\n", session::text_of(test));
    fmt::print("grade: {} at best{}\n", session::timing_grade(timing, 1000, 0),
               timing.kind == session::DisplayKind::Virtual
                   ? "; pictures are drawn in memory, and no monitor is known to show them"
                   : "");
}

/// Greys, then the full primaries and white: what a photometer is held against.
std::vector<std::array<std::uint8_t, 3>> patches() {
    std::vector<std::array<std::uint8_t, 3>> all;
    for (const int code : protocols::photometer_codes()) {
        const auto grey = static_cast<std::uint8_t>(code);
        all.push_back({grey, grey, grey});
    }
    all.insert(all.end(), {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}});
    return all;
}

void show_patches(const LoadedStudy& loaded, const Options& options) {
    const session::SystemClock clock;
    const auto screen = bare_window(loaded, options, clock, 0);
    const auto style = session::page_style(loaded.study);
    fmt::print("code_r,code_g,code_b,X,Y,Z\n");
    for (const auto& [red, green, blue] : patches()) {
        if (!shown_until_left(*screen, session::photometer_page(style, red, green, blue)))
            throw CommandError("the patches were broken off");
        fmt::print("{},{},{},,,\n", red, green, blue);
    }
    options.voice.remark("Fill in X, Y and Z (Y in cd/m2), then `pairlight photometer STUDY --csv "
                         "FILE`.");
}

void import_measurements(const LoadedStudy& loaded, const std::string& csv) {
    const auto text = value_or_stop(read_text_file(csv));
    const auto steps = value_or_stop(protocols::parse_photometer(text, csv));
    const auto fit = protocols::fit_gamma(steps);
    protocols::Eotf table;
    table.kind = protocols::Eotf::Kind::Measured;
    table.steps = steps;
    const auto grey = protocols::surround_of(loaded.study.surround.definition, table).value();
    const auto file = loaded.folder.root / "calibration.csv";
    if (!fs::exists(file) || !fs::equivalent(file, csv))
        value_or_stop(write_text_file(file, text));
    fmt::print("{}: {} greys; white {:.2f} cd/m2, black {:.3f}, contrast {:.0f}:1, gamma {:.3f}\n",
               file.string(), steps.size(), fit.white_cd_m2, fit.black_cd_m2,
               fit.white_cd_m2 / fit.black_cd_m2, fit.gamma);
    fmt::print("worst residual of the gamma curve: {:.2f} % of white{}\n", 100 * fit.worst_residual,
               fit.worst_residual > 0.05 ? " - WARNING: above 5 %, the curve is no gamma" : "");
    fmt::print("surround {}: code {}, {:.2f} cd/m2, {:.1f} % of white\n", grey.definition,
               grey.code, fit.white_cd_m2 * protocols::relative_luminance(table, grey.code),
               100 * protocols::relative_luminance(table, grey.code));
    if (loaded.study.display.eotf.kind != protocols::Eotf::Kind::Measured)
        fmt::print("To use it: eotf = \"table:calibration.csv\" in [display].\n");
}

/// Every view a sitting of this study can have, by name.
std::vector<std::pair<std::string, View>> all_views(const LoadedStudy& loaded,
                                                    const session::DisplayFacts& facts) {
    const auto style = session::page_style(loaded.study);
    std::vector<std::pair<std::string, View>> views;
    views.emplace_back("display", facts.setting_up.at(0));
    views.emplace_back("contrast", facts.setting_up.at(1));
    int number = 0;
    for (const auto& page : session::split_pages(value_or_stop(read_instructions(loaded))))
        views.emplace_back(fmt::format("instructions-{}", ++number),
                           session::instruction_page(style, page));
    views.emplace_back("questions", session::question_page(style, loaded.study.question,
                                                           loaded.study.plan.training > 0));
    views.emplace_back("grey", session::GreyView{});
    const auto schedule = value_or_stop(protocols::make_schedule(loaded.study, {"pages"}, 1));
    const auto& trial = schedule.trials.back();
    if (loaded.study.plan.presentation == protocols::Presentation::SideBySide) {
        views.emplace_back("pair", session::PairView{trial.number, trial.trial});
    } else {
        views.emplace_back("first",
                           session::PairView{trial.number, trial.trial, session::Part::First});
        views.emplace_back("second",
                           session::PairView{trial.number, trial.trial, session::Part::Second});
    }
    views.emplace_back("break", session::break_page(style));
    views.emplace_back("paused", session::paused_page(style, session::PauseReason::WindowLeft));
    views.emplace_back("changed", session::paused_page(style, session::PauseReason::ScreenChanged));
    views.emplace_back("stop", session::stop_page(style));
    views.emplace_back("limit", session::limit_page(style));
    views.emplace_back("thanks", session::thanks_page(style));
    views.emplace_back("photometer", session::photometer_page(style, 64, 64, 64));
    return views;
}

void write_photograph(const fs::path& file, const renderer::gpu::Picture8& picture) {
    renderer::imaging::EncodedImage image;
    image.width = picture.width;
    image.height = picture.height;
    image.bits = 8;
    image.codes.assign(picture.rgb.begin(), picture.rgb.end());
    value_or_stop(renderer::imaging::write_png(file, image));
}

void run_pages(const Options& options) {
    const auto loaded = value_or_stop(read_study(options.study));
    value_or_stop(stimuli::check_stimuli(loaded));
    const session::SystemClock clock;
    auto window =
        window_options(loaded, {.size = window_size(options.window), .monitor = options.monitor});
    window.setting_up = true;
    const auto digests = value_or_stop(stimulus_digests(loaded));
    const auto screen =
        value_or_stop(session::open_window(window, load_unchanged(loaded, digests), clock));
    const auto views = all_views(loaded, screen->facts());
    std::error_code failed;
    fs::create_directories(options.folder, failed);
    if (failed)
        throw CommandError(fmt::format("{}: cannot be made: {}", options.folder, failed.message()));
    Inputs shown;
    for (const auto& [picture, digest] : digests)
        shown.push_back(stimuli::png_file(loaded.folder, picture));
    const auto page_file = [&](const std::string& name) {
        return fs::path(options.folder) / (name + ".png");
    };
    for (const auto& [name, view] : views)
        expect_not_lost(page_file(name), shown);
    for (const auto& [name, view] : views) {
        value_or_stop(screen->show(view));
        write_photograph(page_file(name), screen->photograph());
        fmt::print("{}\n", page_file(name).string());
    }
}

} // namespace

void add_display(Command& program) {
    const auto options = std::make_shared<Options>();
    options->swaps = 120;
    auto command = program.add_command(
        "display", "What is known of the screen; brightness and contrast to set by eye");
    add_seat(command, *options);
    command.runs([options] { run_display(*options); });
}

void add_timing_check(Command& program) {
    const auto options = std::make_shared<Options>();
    auto command =
        program.add_command("timing-check", "Whether the screen keeps time: swaps, measured");
    add_seat(command, *options);
    command.add_option("--swaps", options->swaps, "How many").within(10, 100000).shows_default();
    command.runs([options] { run_timing_check(*options); });
}

void add_photometer(Command& program) {
    const auto options = std::make_shared<Options>();
    auto command = program.add_command(
        "photometer", "Patches to measure on the screen, one after the other; or the measurements");
    add_seat(command, *options);
    command.add_option("--csv", options->csv,
                       "Take these measurements: code,cd_m2 or code_r,code_g,code_b,X,Y,Z");
    command.runs([options] {
        const auto loaded = value_or_stop(read_study(options->study));
        if (options->csv.empty())
            show_patches(loaded, *options);
        else
            import_measurements(loaded, options->csv);
    });
}

void add_pages(Command& program) {
    const auto options = std::make_shared<Options>();
    auto command = program.add_command(
        "pages", "Every page of a sitting as a picture, to read before anyone sits");
    add_seat(command, *options);
    command.add_option("--png", options->folder, "The folder to write them to")
        .required()
        .not_standard_output();
    command.runs([options] { run_pages(*options); });
}

} // namespace experiment::commands
