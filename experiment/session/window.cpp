// The screen that people sit in front of.
#include "experiment/session/window.h"

#include "experiment/session/glfw.h"
#include "experiment/session/glfw_keys.h"
#include "experiment/session/page_drawing.h"
#include "experiment/session/pair_layout.h"
#include "renderer/gpu/context.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <map>
#include <span>

namespace experiment::session {

namespace {

using renderer::gpu::PixelCanvas;

// How often events are looked for: the resolution of response times.
constexpr double poll_seconds = 0.001;

Expected<GLFWmonitor*> chosen_monitor(int number) {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    if (number < 1 || number > count)
        return tl::unexpected(fmt::format(
            "monitor {} was asked for, but there are {}; expected 1 to {}", number, count, count));
    return monitors[number - 1];
}

Expected<WindowHandle> create_window(const WindowOptions& options, GLFWmonitor* monitor) {
    const auto* mode = glfwGetVideoMode(monitor);
    if (mode == nullptr)
        return tl::unexpected("the monitor has no video mode: " + glfw_complaint());
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_RED_BITS, mode->redBits);
    glfwWindowHint(GLFW_GREEN_BITS, mode->greenBits);
    glfwWindowHint(GLFW_BLUE_BITS, mode->blueBits);
    glfwWindowHint(GLFW_REFRESH_RATE, mode->refreshRate > 0 ? mode->refreshRate : GLFW_DONT_CARE);
    glfwWindowHint(GLFW_SAMPLES, 0);
    glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    const bool whole = !options.size;
    const auto size = options.size.value_or(WindowSize{mode->width, mode->height});
    WindowHandle window(glfwCreateWindow(size.width, size.height, "Pairlight session",
                                         whole ? monitor : nullptr, nullptr));
    if (!window)
        return tl::unexpected(fmt::format("no window of {} x {} with OpenGL 4.5 core can be opened "
                                          "({}); expected a driver with OpenGL 4.5, such as that "
                                          "of the package libgl1-mesa-dri",
                                          size.width, size.height, glfw_complaint()));
    glfwMakeContextCurrent(window.get());
    glfwSwapInterval(1);
    return window;
}

Places places_of(const WindowOptions& options) {
    const bool side_by_side = options.presentation == protocols::Presentation::SideBySide;
    if (options.reference)
        return side_by_side ? Places::Three : Places::OneAndReference;
    return side_by_side ? Places::Two : Places::One;
}

/// By scene: where its pictures lie, or why they do not fit.
using Layouts = std::map<protocols::SceneId, Expected<PairLayout>>;

Layouts lay_out(int width, int height, const WindowOptions& options) {
    Layouts layouts;
    for (const auto& [scene, size] : options.sizes)
        layouts.emplace(scene, lay_out_pair(width, height, size.width, size.height, options.gap,
                                            places_of(options)));
    return layouts;
}

// Mesa's rasterisers draw in memory; nothing they swap waits for a monitor.
bool is_software(const std::string& renderer) {
    for (const auto* name : {"llvmpipe", "softpipe", "swrast", "SWR", "Software"})
        if (renderer.find(name) != std::string::npos)
            return true;
    return false;
}

renderer::gpu::Picture8 solid(int width, int height, const Patch& colour) {
    renderer::gpu::Picture8 picture{width, height, {}};
    picture.rgb.reserve(static_cast<std::size_t>(3 * width * height));
    for (int pixel = 0; pixel < width * height; ++pixel)
        for (const auto code : {colour.red, colour.green, colour.blue})
            picture.rgb.push_back(code);
    return picture;
}

class Window final : public WindowScreen {
  public:
    Window(std::unique_ptr<Glfw> glfw,
           WindowHandle window,
           GLFWmonitor* monitor,
           const WindowOptions& options,
           PixelCanvas canvas,
           Layouts layouts,
           std::unique_ptr<PageDrawing> pages,
           LoadPicture load,
           const Clock& clock)
        : glfw_(std::move(glfw)), window_(std::move(window)), monitor_(monitor), options_(options),
          canvas_(canvas), layouts_(std::move(layouts)), pages_(std::move(pages)),
          cache_(std::move(load), options.sizes, options.reference), keys_(glfw_keys(options.keys)),
          clock_(clock) {
        glfwSetWindowUserPointer(window_.get(), this);
        glfwSetKeyCallback(window_.get(), [](GLFWwindow* event_window, int key, int, int action,
                                             int) { self(event_window).on_key(key, action); });
        glfwSetMouseButtonCallback(window_.get(),
                                   [](GLFWwindow* event_window, int button, int action, int) {
                                       if (button == GLFW_MOUSE_BUTTON_LEFT && action == GLFW_PRESS)
                                           self(event_window).on_click();
                                   });
        glfwSetWindowFocusCallback(window_.get(), [](GLFWwindow* event_window, int focused) {
            if (focused == GLFW_FALSE)
                self(event_window).happened(FocusLost{});
        });
        glfwSetWindowCloseCallback(window_.get(), [](GLFWwindow* event_window) {
            glfwSetWindowShouldClose(event_window, GLFW_FALSE);
            self(event_window).happened(CloseAsked{});
        });
        glfwSetWindowRefreshCallback(
            window_.get(), [](GLFWwindow* event_window) { self(event_window).damaged_ = true; });
        glfwSetFramebufferSizeCallback(window_.get(),
                                       [](GLFWwindow* event_window, int width, int height) {
                                           self(event_window).on_size(width, height);
                                       });
        glfwSetMonitorUserPointer(monitor_, this);
        glfwSetMonitorCallback([](GLFWmonitor* changed, int event) {
            auto* screen = static_cast<Window*>(glfwGetMonitorUserPointer(changed));
            if (screen != nullptr && event == GLFW_DISCONNECTED)
                screen->on_monitor_gone();
        });
        check_pixels();
        if (options_.test_swaps > 0)
            test_ = judge_swaps(time_swaps(options_.test_swaps), nominal_hz());
    }

    ~Window() override { glfwSetMonitorCallback(nullptr); }

    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    DisplayFacts facts() const override {
        DisplayFacts facts;
        facts.description = description();
        facts.timing = {test_ ? test_->verdict : SwapVerdict::Unstable,
                        is_software(renderer::gpu::description()) ? DisplayKind::Virtual
                        : options_.size                           ? DisplayKind::Windowed
                                                                  : DisplayKind::FullScreen};
        if (facts.timing.verdict == SwapVerdict::Synced && nominal_hz() > 0)
            facts.refresh = Monotonic(std::llround(1e9 / nominal_hz()));
        if (options_.setting_up)
            facts.setting_up = {display_page(options_.style, facts.description),
                                contrast_page(options_.style)};
        return facts;
    }

    renderer::gpu::Picture8 photograph() override {
        [[maybe_unused]] const auto drawn = draw();
        return canvas_.read(0, 0, canvas_.width(), canvas_.height());
    }

    double nominal_hz() const override {
        const auto* mode = monitor_ != nullptr ? glfwGetVideoMode(monitor_) : nullptr;
        return mode != nullptr ? mode->refreshRate : 0;
    }

    std::vector<Monotonic> time_swaps(int swaps) override {
        std::vector<Monotonic> intervals;
        auto last = Monotonic{};
        for (int i = 0; i <= swaps; ++i) {
            // Two greys that nobody tells apart.
            canvas_.clear(static_cast<std::uint8_t>(options_.surround ^ (i % 2)));
            glfwSwapBuffers(window_.get());
            canvas_.finish();
            const auto now = clock_.now();
            if (i > 0)
                intervals.push_back(now - last);
            last = now;
        }
        return intervals;
    }

    void prepare(const PairView& pair) override { cache_.prepare(pair); }

    Expected<Input> show(const View& view) override {
        view_ = view;
        const bool is_pair = std::holds_alternative<PairView>(view);
        glfwSetInputMode(window_.get(), GLFW_CURSOR,
                         is_pair ? GLFW_CURSOR_NORMAL : GLFW_CURSOR_HIDDEN);
        if (auto drawn = draw(); !drawn)
            return tl::unexpected(drawn.error());
        glfwSwapBuffers(window_.get());
        canvas_.finish();
        return Input{clock_.now(), OnsetSeen{"swap_return"}};
    }

    // Nothing is drawn while waiting, unless something else covered the window.
    std::optional<Input> wait(std::optional<Monotonic> until) override {
        while (inputs_.empty()) {
            double patience = poll_seconds;
            if (until) {
                const auto left = std::chrono::duration<double>(*until - clock_.now()).count();
                if (left <= 0)
                    return std::nullopt;
                patience = std::min(patience, left);
            }
            glfwWaitEventsTimeout(patience);
            cache_.upload_what_is_ready();
            if (std::exchange(damaged_, false) && draw()) {
                glfwSwapBuffers(window_.get());
                canvas_.finish();
            }
        }
        const auto input = inputs_.front();
        inputs_.pop_front();
        return input;
    }

  private:
    std::string description() const {
        const auto* mode = monitor_ != nullptr ? glfwGetVideoMode(monitor_) : nullptr;
        const auto* name = monitor_ != nullptr ? glfwGetMonitorName(monitor_) : nullptr;
        auto text = fmt::format(
            "screen={}; monitor={}; monitor_resolution={}x{}; resolution={}x{}; "
            "refresh_hz={}; colour_bits={}/{}/{}; surround_code={}; surround_read_back={}; "
            "picture_read_back={}; drawn_by={}",
            options_.size ? "window" : "full", name ? name : "unnamed", mode ? mode->width : 0,
            mode ? mode->height : 0, canvas_.width(), canvas_.height(),
            mode && mode->refreshRate > 0 ? std::to_string(mode->refreshRate) : "not reported",
            mode ? mode->redBits : 0, mode ? mode->greenBits : 0, mode ? mode->blueBits : 0,
            options_.surround, surround_exact_ ? "exact" : "changed",
            picture_exact_ ? "exact" : "changed", renderer::gpu::description());
        const auto& display = options_.display;
        if (mode && mode->width > 0 && display.screen_width_mm > 0) {
            const double pitch = display.screen_width_mm / mode->width;
            text += fmt::format("; pixel_pitch_mm={:.4f}", pitch);
            if (display.distance_mm > 0)
                text +=
                    fmt::format("; distance_mm={}; distance_in_heights={:.2f}; "
                                "pixels_per_degree={:.1f}",
                                display.distance_mm, display.distance_mm / (pitch * mode->height),
                                protocols::pixels_per_degree(display.distance_mm, pitch));
        }
        text += fmt::format("; eotf={}; surround_luminance={:.4f} of white", name_of(display.eotf),
                            relative_luminance(display.eotf, options_.surround));
        if (display.photodiode_px > 0)
            text += fmt::format("; photodiode_px={}", display.photodiode_px);
        if (test_)
            text += "; swaps=" + text_of(*test_);
        return text;
    }

    void on_size(int width, int height) {
        if (width <= 0 || height <= 0 || (width == canvas_.width() && height == canvas_.height()))
            return;
        happened(DisplayChanged{fmt::format("the window has {} x {} pixels, it had {} x {}", width,
                                            height, canvas_.width(), canvas_.height())});
        canvas_ = PixelCanvas(width, height);
        pages_->resize(width, height);
        // Where the pictures no longer fit, the next pair says so, and the sitting ends.
        layouts_ = lay_out(width, height, options_);
        damaged_ = true;
    }

    void on_monitor_gone() {
        monitor_ = nullptr;
        happened(DisplayChanged{"the monitor is gone"});
    }

    // Draws what a sitting draws, once, and looks at what came of it.  A driver's first drawing of
    // a kind can take a tenth of a second, which would make the first onset late.
    void check_pixels() {
        canvas_.clear(options_.surround);
        const auto surround = canvas_.read(0, 0, canvas_.width(), canvas_.height());
        surround_exact_ = std::ranges::all_of(
            surround.rgb, [&](std::uint8_t code) { return code == options_.surround; });
        picture_exact_ = true;
        for (const auto& [scene, layout] : layouts_)
            if (layout)
                check_pictures(*layout);
    }

    void check_pictures(const PairLayout& layout) {
        renderer::gpu::Picture8 codes{layout.width, layout.height, {}};
        for (int pixel = 0; pixel < codes.width * codes.height; ++pixel)
            for (const int value : {pixel, 255 - pixel, pixel ^ 0x55})
                codes.rgb.push_back(static_cast<std::uint8_t>(value & 0xff));
        const renderer::gpu::UploadedPicture uploaded(codes);
        for (const int left : {layout.left_x, layout.right_x}) {
            canvas_.draw(uploaded, left, layout.top);
            picture_exact_ = picture_exact_ &&
                             canvas_.read(left, layout.top, codes.width, codes.height) == codes;
        }
    }

    static Window& self(GLFWwindow* window) {
        return *static_cast<Window*>(glfwGetWindowUserPointer(window));
    }

    // The clock is read first: what follows takes time.
    void happened(decltype(Input::what) what) {
        const auto now = clock_.now();
        inputs_.push_back({now, std::move(what)});
    }

    void on_key(int glfw_key, int action) {
        const auto found = keys_.find(glfw_key);
        const auto key = found == keys_.end() ? Key::Other : found->second;
        if (action == GLFW_RELEASE)
            happened(LetGo{key});
        else
            happened(Pressed{key, Device::Keyboard, action == GLFW_REPEAT});
    }

    void on_click() {
        const auto now = clock_.now();
        double x = 0, y = 0;
        int width = 0, height = 0;
        glfwGetCursorPos(window_.get(), &x, &y);
        glfwGetWindowSize(window_.get(), &width, &height);
        const auto* pair = std::get_if<PairView>(&view_);
        if (width <= 0 || height <= 0 || pair == nullptr || !layout_of(*pair))
            return;
        const auto& layout = *layout_of(*pair);
        // Where a desktop scales windows, the cursor is not counted in pixels.
        x *= static_cast<double>(canvas_.width()) / width;
        y *= static_cast<double>(canvas_.height()) / height;
        const auto inside = [&](int left) {
            return x >= left && x < left + layout.width && y >= layout.top &&
                   y < layout.top + layout.height;
        };
        if (layout.left_x == layout.right_x)
            return; // one place: a click does not say which picture
        if (inside(layout.left_x))
            inputs_.push_back({now, Pressed{Key::Left, Device::Mouse}});
        else if (inside(layout.right_x))
            inputs_.push_back({now, Pressed{Key::Right, Device::Mouse}});
    }

    // Draws the view to the buffer that is not on the screen.
    Expected<void> draw() {
        canvas_.clear(options_.surround);
        if (const auto* page = std::get_if<PageView>(&view_)) {
            for (const auto& patch : page->patches)
                draw_patch(patch);
            return pages_->draw(*page);
        }
        const auto* pair = std::get_if<PairView>(&view_);
        draw_photodiode_patch(pair != nullptr);
        return pair != nullptr ? draw_pair(*pair) : Expected<void>{};
    }

    const Expected<PairLayout>& layout_of(const PairView& pair) const {
        return layouts_.at(pair.trial.scene);
    }

    Expected<void> draw_pair(const PairView& pair) {
        const auto& layout = layout_of(pair);
        if (!layout)
            return tl::unexpected(layout.error());
        const auto pictures = cache_.get(pair);
        if (!pictures)
            return tl::unexpected(pictures.error());
        if (pair.part != Part::Second)
            canvas_.draw((*pictures)->left, layout->left_x, layout->top);
        if (pair.part != Part::First)
            canvas_.draw((*pictures)->right, layout->right_x, layout->top);
        if ((*pictures)->reference)
            canvas_.draw(*(*pictures)->reference, layout->reference_x, layout->top);
        if (pair.part == Part::Both)
            return {};
        return pages_->draw_mark(pair.part == Part::First ? "1" : "2",
                                 layout->left_x + layout->width / 2, layout->top + layout->height);
    }

    void draw_patch(const Patch& patch) {
        const auto pixels = [](double share, int size) {
            return static_cast<int>(std::lround(share * size));
        };
        const renderer::gpu::UploadedPicture uploaded(solid(
            pixels(patch.width, canvas_.width()), pixels(patch.height, canvas_.height()), patch));
        canvas_.draw(uploaded, pixels(patch.left, canvas_.width()),
                     pixels(patch.top, canvas_.height()));
    }

    // White as long as pictures are on the screen, black in the grey between them.
    void draw_photodiode_patch(bool lit) {
        const int edge =
            std::min({options_.display.photodiode_px, canvas_.width(), canvas_.height()});
        if (edge <= 0)
            return;
        const auto code = static_cast<std::uint8_t>(lit ? 255 : 0);
        const renderer::gpu::UploadedPicture uploaded(
            solid(edge, edge, {0, 0, 0, 0, code, code, code}));
        canvas_.draw(uploaded, 0, canvas_.height() - edge);
    }

    // Destroyed from the last to the first: textures before the window, the window before GLFW.
    std::unique_ptr<Glfw> glfw_;
    WindowHandle window_;
    GLFWmonitor* monitor_;
    WindowOptions options_;
    PixelCanvas canvas_;
    Layouts layouts_;
    std::unique_ptr<PageDrawing> pages_;
    PairCache cache_;
    std::map<int, Key> keys_; ///< by GLFW's codes
    const Clock& clock_;
    bool surround_exact_ = false;
    bool picture_exact_ = false;
    std::optional<SwapTest> test_;
    View view_ = GreyView{};
    std::deque<Input> inputs_;
    bool damaged_ = false;
};

} // namespace

Expected<std::unique_ptr<WindowScreen>>
open_window(const WindowOptions& options, LoadPicture load, const Clock& clock) {
    auto glfw = Glfw::start(options.without_display);
    if (!glfw)
        return tl::unexpected(glfw.error());
    const auto monitor = chosen_monitor(options.monitor);
    if (!monitor)
        return tl::unexpected(monitor.error());
    auto window = create_window(options, *monitor);
    if (!window)
        return tl::unexpected(window.error());
    int width = 0, height = 0;
    glfwGetFramebufferSize(window->get(), &width, &height);
    auto layouts = lay_out(width, height, options);
    for (const auto& [scene, layout] : layouts)
        if (!layout)
            return tl::unexpected(layout.error());
    auto pages = PageDrawing::create(width, height,
                                     {options.display.text_scale, options.display.high_contrast});
    if (!pages)
        return tl::unexpected(pages.error());
    auto screen = std::make_unique<Window>(std::move(*glfw), std::move(*window), *monitor, options,
                                           PixelCanvas(width, height), std::move(layouts),
                                           std::move(*pages), std::move(load), clock);
    if (auto shown = screen->show(GreyView{}); !shown)
        return tl::unexpected(shown.error());
    return screen;
}

} // namespace experiment::session
