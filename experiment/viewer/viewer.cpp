// The thin shell round the state: whatever it decides is in viewer_state.cpp.
#include "experiment/viewer/viewer.h"

#include "experiment/staging.h"
#include "experiment/viewer/false_colours.h"
#include "experiment/viewer/frame_times.h"
#include "experiment/viewer/gui.h"
#include "experiment/viewer/keys.h"
#include "experiment/viewer/panel.h"
#include "experiment/viewer/picture_pass.h"
#include "experiment/viewer/snapshot.h"
#include "experiment/viewer/stage.h"
#include "experiment/viewer/viewer_state.h"
#include "experiment/viewer/viewpoint.h"
#include "renderer/contract.h"
#include "renderer/expected.h"
#include "renderer/gpu/context.h"
#include "renderer/gpu/pixel_canvas.h"
#include "renderer/methods/catalogue.h"
#include "renderer/pictures/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

namespace experiment::viewer {

namespace gpu = renderer::gpu;
namespace fs = std::filesystem;

using renderer::Expected;

namespace {

using Clock = std::chrono::steady_clock;

constexpr double busy_seconds = 1;     // drawing goes on so long after the last input
constexpr double idle_patience = 0.25; // then so often, for what a method does by itself
constexpr double note_after = 0.3;     // work that is over sooner needs no word
constexpr double note_every = 0.1;
constexpr double degrees_per_pixel = 0.4;
constexpr double zoom_per_notch = 1.15;
constexpr int snapshot_samples = 16;
constexpr double settled = std::numeric_limits<double>::infinity();

double seconds_now() {
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

/// A person quit while something was being made.
struct Stopped {};

/// The side as its thickness can be read: under the physical law, where it has a choice of laws.
Side physical(Side side) {
    if (has_physical_law(side.method))
        side.dials.insert_or_assign("law", "physical");
    return side;
}

class Viewer {
  public:
    Viewer(const Exhibit& exhibit, Display& display, const ViewerOptions& options, PicturePass pass)
        : exhibit_(exhibit), display_(display), options_(options),
          strokes_(options.strokes.begin(), options.strokes.end()), state_(initial_state(exhibit)),
          pass_(std::move(pass)), last_input_(seconds_now()), last_drawn_(last_input_) {
        facts_.renderer = gpu::description();
    }

    Expected<void> run() {
        try {
            while (!state_.done)
                if (const auto shown = turn(); !shown)
                    return shown;
        } catch (const Stopped&) {
            return {};
        }
        return {};
    }

  private:
    bool is_scripted() const { return options_.frames.has_value(); }

    Expected<void> turn() {
        take_events();
        if (state_.done)
            return {};
        lay_out();
        return open_scene()
            .and_then([&] { return make_targets(); })
            .and_then([&] {
                make_methods();
                draw_sides();
                return show();
            })
            .and_then([&] { return count_frame(); });
    }

    // Inputs, from whoever gives them

    void apply(const Input& input) { state_ = reduce(std::move(state_), input, exhibit_); }

    void take_events() {
        if (!strokes_.empty()) {
            apply(*input_of(strokes_.front()));
            strokes_.pop_front();
        }
        const bool busy = is_scripted() || !from_panel_.empty() || !pending_.empty() ||
                          seconds_now() - last_input_ < busy_seconds;
        auto events = std::exchange(pending_, {});
        for (auto& event : display_.events(busy ? 0 : idle_patience))
            events.push_back(std::move(event));
        if (!events.empty() || !from_panel_.empty())
            last_input_ = seconds_now();
        for (const auto& input : std::exchange(from_panel_, {}))
            apply(input);
        for (const auto& event : events)
            std::visit([&](const auto& one) { on(one); }, event);
    }

    void on(const Stroke& stroke) {
        if (const auto input = input_of(stroke.key))
            apply(*input);
    }

    // Dragging takes hold of the model, so the eye walks the other way.
    void on(const Drag& drag) {
        const double right = degrees_per_pixel * drag.right, up = degrees_per_pixel * drag.up;
        if (drag.light)
            apply(TurnLight{right, up});
        else
            apply(WalkEye{-right, -up});
    }

    void on(const Scroll& scroll) { apply(Zoom{std::pow(zoom_per_notch, scroll.notches)}); }

    void on(const Closed&) { apply(Command::Quit); }

    // What has to be there before anything can be drawn

    void lay_out() {
        const int left = state_.panel && display_.width() > 2 * panel_width ? panel_width : 0;
        facts_.picture = {left, 0, display_.width() - left, display_.height()};
        facts_.window_height = display_.height();
    }

    Expected<void> open_scene() {
        if (opened_ == state_.scene)
            return {};
        stage_.reset();
        opened_ = state_.scene;
        facts_.remarks = exhibit_.remarks;
        facts_.vertices = facts_.triangles = 0;
        begin_work("reading the model");
        auto stage = Stage::open(exhibit_, exhibit_.pieces[state_.scene],
                                 [this](double fraction) { work_goes_on(fraction); });
        if (!stage && (exhibit_.pieces.size() == 1 || options_.screenshot))
            return tl::unexpected(stage.error());
        if (!stage) {
            facts_.remarks.push_back(stage.error());
            return {};
        }
        stage_ = std::move(*stage);
        facts_.vertices = stage_->model().mesh.positions.size();
        facts_.triangles = stage_->model().mesh.triangles.size();
        facts_.diameter_mm = reach().value;
        for (const auto& remark : stage_->model().remarks)
            facts_.remarks.push_back(remark);
        return {};
    }

    Expected<void> make_targets() {
        const auto& place = facts_.picture;
        for (auto& target : targets_) {
            if (target && target->width() == place.width && target->height() == place.height)
                continue;
            auto made = gpu::Target::create(place.width, place.height);
            if (!made)
                return tl::unexpected(made.error());
            target.emplace(std::move(*made));
        }
        return {};
    }

    /// Both sides' methods, or why there is none.
    void make_methods() {
        for (std::size_t i = 0; i < targets_.size(); ++i) {
            methods_[i] = nullptr;
            facts_.sides[i].problem.clear();
            if (!is_seen(state_, i))
                continue;
            if (const auto method = method_of(state_.sides[i]))
                methods_[i] = *method;
            else
                facts_.sides[i].problem = method.error();
        }
    }

    Expected<renderer::methods::Method*> method_of(const Side& side) {
        if (stage_ == nullptr)
            return tl::unexpected(std::string("the scene has no model"));
        begin_work(fmt::format("preparing {}", title(side, exhibit_)));
        return stage_->method(state_.look == Look::Thickness ? physical(side) : side);
    }

    static const std::string& label_of(const Side& side) {
        return renderer::methods::find_method(side.method)->label;
    }

    // Work that takes long

    void begin_work(std::string what) {
        work_ = std::move(what);
        work_began_ = seconds_now();
        noted_ = work_began_ + note_after - note_every;
    }

    // Comes from whichever thread has finished a part; only the one that owns the window may draw.
    void work_goes_on(double fraction) {
        if (options_.progress)
            options_.progress(fraction);
        const double now = seconds_now();
        if (std::this_thread::get_id() != thread_ || now - noted_ < note_every)
            return;
        noted_ = now;
        for (auto& event : display_.events(0)) {
            const auto* stroke = std::get_if<Stroke>(&event);
            if (std::holds_alternative<Closed>(event) || (stroke && stroke->key == "Esc"))
                throw Stopped{};
            pending_.push_back(std::move(event));
        }
        const double share = std::clamp(fraction, 1e-3, 1.0);
        {
            const auto drawing = display_.draw_into();
            gpu::PixelCanvas(display_.width(), display_.height()).clear(grey());
            display_.begin_controls();
            draw_panel(state_, exhibit_, facts_);
            draw_progress(work_, share, (now - work_began_) * (1 - share) / share);
            draw_controls();
        }
        display_.present();
    }

    std::uint8_t grey() const { return static_cast<std::uint8_t>(exhibit_.surround); }

    // Pictures

    renderer::Scene scene_now() const {
        const auto& place = facts_.picture;
        return seen(state_, exhibit_, stage_->sphere(),
                    static_cast<double>(place.width) / place.height);
    }

    /// Twice as long as the way through the middle: exponents stay small, differences large.
    renderer::Millimetres reach() const {
        return diameter_of(exhibit_.pieces[state_.scene].scene,
                           stage_ ? stage_->sphere() : renderer::geometry::BoundingSphere{{}, 1});
    }

    /// The scene with one light of 1 and nothing but the light that has come through.
    renderer::Scene probed(renderer::Scene scene) const {
        scene.material = thickness_probe(reach());
        scene.ambient = {0, 0, 0};
        scene.lights.resize(1);
        scene.lights.front().intensity = {1, 1, 1};
        return scene;
    }

    void draw_sides() {
        picture_began_ = seconds_now();
        const double since = is_scripted() ? settled : picture_began_ - last_drawn_;
        last_drawn_ = picture_began_;
        for (std::size_t i = 0; i < targets_.size(); ++i) {
            targets_[i]->clear();
            if (methods_[i] == nullptr)
                continue;
            const auto scene = state_.look == Look::Thickness ? probed(scene_now()) : scene_now();
            if (const auto drawn = draw(i, scene, since); !drawn)
                facts_.sides[i].problem = drawn.error();
        }
    }

    Expected<void> draw(std::size_t i, const renderer::Scene& scene, double seconds) {
        auto& method = *methods_[i];
        auto& facts = facts_.sides[i];
        if (std::exchange(timed_[i], &method) != &method)
            times_[i] = {};
        const double start = seconds_now();
        if (const auto ready = method.update(scene, seconds); !ready)
            return ready;
        {
            const auto drawing = targets_[i]->draw_into();
            method.draw(scene);
            gpu::finish();
        }
        times_[i].add(seconds_now(), 1000 * (seconds_now() - start));
        facts.milliseconds = times_[i].median();
        facts.bytes_per_vertex = method.cost().bytes_per_vertex;
        facts.decision = method.decision();
        return {};
    }

    // False colours

    bool both_seen() const { return is_seen(state_, 0) && is_seen(state_, 1); }

    std::vector<float> pixels(std::size_t side) const {
        std::vector<float> rgba;
        targets_[side]->read(rgba);
        return rgba;
    }

    /// Measures what the false colours show, and lets the scale grow with it.
    void measure() {
        facts_.legend.reset();
        if (scaled_for_ != std::pair(state_.look, state_.scene))
            whole_ = 0;
        scaled_for_ = {state_.look, state_.scene};
        if (state_.look == Look::Thickness)
            measure_thickness();
        else if (state_.look == Look::Error && methods_[0] != nullptr && methods_[1] != nullptr)
            measure_error();
    }

    void grow_scale(double most) { whole_ = std::max(whole_, round_scale(most)); }

    void measure_thickness() {
        std::string reading;
        double most = 0;
        for (std::size_t i = 0; i < targets_.size(); ++i) {
            if (methods_[i] == nullptr || !facts_.sides[i].problem.empty())
                continue;
            const auto seen = thickness_seen(pixels(i), reach());
            most = std::max(most, seen.most);
            if (!has_thickness(seen))
                facts_.sides[i].problem = fmt::format(
                    "{} has no thickness here: what it draws is not dimmed by a single one",
                    label_of(state_.sides[i]));
            else
                reading +=
                    fmt::format("{}{}mean {:.3g} mm, most {:.3g} mm", reading.empty() ? "" : "; ",
                                !both_seen() ? ""
                                : i == 0     ? "left: "
                                             : "right: ",
                                seen.mean, seen.most);
        }
        if (reading.empty())
            return;
        grow_scale(most);
        const auto lights = exhibit_.variants[state_.variant].lights.size();
        facts_.legend = {whole_, "mm",
                         lights == 1 ? "thickness toward the light"
                                     : fmt::format("thickness toward light 1 of {}", lights),
                         reading};
    }

    void measure_error() {
        const auto seen = error_seen(pixels(0), pixels(1));
        grow_scale(seen.most);
        facts_.legend = {whole_, "", "difference of the two sides, linear light, white is 1",
                         fmt::format("mean {:.3g}, most {:.3g}", seen.mean, seen.most)};
    }

    // Showing

    Composition composition() const {
        const bool split = state_.split && state_.look != Look::Error;
        return {.place = facts_.picture,
                .look = state_.look == Look::Error && !facts_.legend ? Look::Light : state_.look,
                .right_from = split                ? state_.split_at
                              : state_.active == 0 ? 1.0
                                                   : 0.0,
                .line = split,
                .whole = whole_ > 0 ? whole_ : 1,
                .reach = reach(),
                .surround = exhibit_.surround};
    }

    Expected<void> show() {
        measure();
        {
            const auto drawing = display_.draw_into();
            const gpu::PixelCanvas canvas(display_.width(), display_.height());
            canvas.clear(grey());
            pass_.draw(*targets_[0], *targets_[1], composition());
            display_.begin_controls();
            from_panel_ = draw_panel(state_, exhibit_, facts_);
            draw_controls();
            gpu::finish();
            whole_times_.add(seconds_now(), 1000 * (seconds_now() - picture_began_));
            facts_.milliseconds = whole_times_.median();
            if (state_.pictures > taken_)
                take_picture();
        }
        display_.present();
        return gpu::check("the viewer");
    }

    void take_picture() {
        taken_ = state_.pictures;
        const auto stem = free_stem(exhibit_.pieces[state_.scene].scene.id.value);
        const auto written = snapshot(stem);
        facts_.notice = written ? fmt::format("saved {}.png and the light as EXR", stem.string())
                                : written.error();
    }

    /// The window as it stands in the bound frame buffer, and the sides' light, antialiased.
    Expected<void> snapshot(const fs::path& stem) {
        Snapshot taken;
        taken.window = gpu::PixelCanvas(display_.width(), display_.height())
                           .read(0, 0, display_.width(), display_.height());
        for (std::size_t i = 0; i < targets_.size(); ++i) {
            if (!is_seen(state_, i) || stage_ == nullptr)
                continue;
            auto light = stage_->method(state_.sides[i]).and_then([&](auto* method) {
                return renderer::pictures::render_picture(*method, scene_now(),
                                                          facts_.picture.width,
                                                          facts_.picture.height, snapshot_samples);
            });
            if (!light)
                return tl::unexpected(light.error());
            taken.light.emplace(!both_seen() ? "" : i == 0 ? "-left" : "-right", std::move(*light));
        }
        return write_snapshot(stem, taken);
    }

    Expected<void> count_frame() {
        if (!options_.frames || !strokes_.empty() || ++frames_ < *options_.frames)
            return {};
        state_.done = true;
        if (!options_.screenshot)
            return {};
        for (std::size_t i = 0; i < targets_.size(); ++i)
            if (is_seen(state_, i) && !facts_.sides[i].problem.empty())
                return tl::unexpected(facts_.sides[i].problem);
        if (!state_.refusal.empty())
            return tl::unexpected(state_.refusal);
        const auto drawing = display_.draw_into();
        return snapshot(fs::path(*options_.screenshot).replace_extension());
    }

    const Exhibit& exhibit_;
    Display& display_;
    const ViewerOptions& options_;
    std::deque<std::string> strokes_;
    ViewerState state_;
    PicturePass pass_;

    std::unique_ptr<Stage> stage_;
    std::optional<std::size_t> opened_; ///< the scene that was tried last
    std::array<std::optional<gpu::Target>, 2> targets_;
    std::array<renderer::methods::Method*, 2> methods_{};
    std::array<FrameTimes, 2> times_;
    std::array<const renderer::methods::Method*, 2> timed_{}; ///< whose times they are
    FrameTimes whole_times_;
    Facts facts_;

    std::vector<Event> pending_; ///< what happened while something was being made
    std::vector<Input> from_panel_;
    double last_input_;
    double last_drawn_;
    double picture_began_ = 0;
    int frames_ = 0;
    int taken_ = 0;

    std::pair<Look, std::size_t> scaled_for_{Look::Light, 0};
    double whole_ = 0; ///< of the false colours' scale

    std::thread::id thread_ = std::this_thread::get_id();
    std::string work_;
    double work_began_ = 0;
    double noted_ = 0;
};

} // namespace

Expected<void> run_viewer(const Exhibit& exhibit, Display& display, const ViewerOptions& options) {
    EXPECTS(std::ranges::all_of(options.strokes,
                                [](const auto& key) { return input_of(key).has_value(); }));
    EXPECTS(!options.frames || *options.frames >= 1);
    auto pass = PicturePass::create();
    if (!pass)
        return tl::unexpected(pass.error());
    return Viewer(exhibit, display, options, std::move(*pass)).run();
}

} // namespace experiment::viewer
