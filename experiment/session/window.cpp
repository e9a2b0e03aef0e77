// The screen that people sit in front of.
#include "experiment/session/window.h"

#include "experiment/session/glfw.h"
#include "experiment/session/glfw_keys.h"
#include "experiment/session/view_drawing.h"
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

DrawingStyle style_of(const WindowOptions& options) {
    return {.surround = options.surround,
            .sizes = options.sizes,
            .gap = options.gap,
            .places = places_of(options),
            .reference = options.reference,
            .photodiode_px = options.display.photodiode_px,
            .text = {options.display.text_scale, options.display.high_contrast}};
}

// Mesa's rasterisers draw in memory; nothing they swap waits for a monitor.
bool is_software(const std::string& renderer) {
    for (const auto* name : {"llvmpipe", "softpipe", "swrast", "SWR", "Software"})
        if (renderer.find(name) != std::string::npos)
            return true;
    return false;
}

class Window final : public WindowScreen {
  public:
    Window(std::unique_ptr<Glfw> glfw,
           WindowHandle window,
           GLFWmonitor* monitor,
           const WindowOptions& options,
           ViewDrawing drawing,
           const Clock& clock)
        : glfw_(std::move(glfw)), window_(std::move(window)), monitor_(monitor), options_(options),
          drawing_(std::move(drawing)), keys_(glfw_keys(options.keys)), clock_(clock) {
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
        pixels_ = drawing_.check_pixels();
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
        [[maybe_unused]] const auto drawn = drawing_.draw(view_);
        const auto& canvas = drawing_.canvas();
        return canvas.read(0, 0, canvas.width(), canvas.height());
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
            drawing_.canvas().clear(static_cast<std::uint8_t>(options_.surround ^ (i % 2)));
            swap();
            const auto now = clock_.now();
            if (i > 0)
                intervals.push_back(now - last);
            last = now;
        }
        return intervals;
    }

    void prepare(const PairView& pair) override { drawing_.pictures().prepare(pair); }

    Expected<Input> show(const View& view) override {
        view_ = view;
        const bool is_pair = std::holds_alternative<PairView>(view);
        glfwSetInputMode(window_.get(), GLFW_CURSOR,
                         is_pair ? GLFW_CURSOR_NORMAL : GLFW_CURSOR_HIDDEN);
        if (auto drawn = drawing_.draw(view_); !drawn)
            return tl::unexpected(drawn.error());
        swap();
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
            drawing_.pictures().upload_what_is_ready();
            if (std::exchange(damaged_, false) && drawing_.draw(view_))
                swap();
        }
        const auto input = inputs_.front();
        inputs_.pop_front();
        return input;
    }

  private:
    // Returns when the monitor has been given the picture.
    void swap() {
        glfwSwapBuffers(window_.get());
        drawing_.canvas().finish();
    }

    std::string description() const {
        const auto* mode = monitor_ != nullptr ? glfwGetVideoMode(monitor_) : nullptr;
        const auto* name = monitor_ != nullptr ? glfwGetMonitorName(monitor_) : nullptr;
        auto text = fmt::format(
            "screen={}; monitor={}; monitor_resolution={}x{}; resolution={}x{}; "
            "refresh_hz={}; colour_bits={}/{}/{}; surround_code={}; surround_read_back={}; "
            "picture_read_back={}; drawn_by={}",
            options_.size ? "window" : "full", name ? name : "unnamed", mode ? mode->width : 0,
            mode ? mode->height : 0, drawing_.canvas().width(), drawing_.canvas().height(),
            mode && mode->refreshRate > 0 ? std::to_string(mode->refreshRate) : "not reported",
            mode ? mode->redBits : 0, mode ? mode->greenBits : 0, mode ? mode->blueBits : 0,
            options_.surround, pixels_.surround_exact ? "exact" : "changed",
            pixels_.picture_exact ? "exact" : "changed", renderer::gpu::description());
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
        const int old_width = drawing_.canvas().width(), old_height = drawing_.canvas().height();
        if (width <= 0 || height <= 0 || (width == old_width && height == old_height))
            return;
        happened(DisplayChanged{fmt::format("the window has {} x {} pixels, it had {} x {}", width,
                                            height, old_width, old_height)});
        drawing_.resize(width, height);
        damaged_ = true;
    }

    void on_monitor_gone() {
        monitor_ = nullptr;
        happened(DisplayChanged{"the monitor is gone"});
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
        if (width <= 0 || height <= 0 || pair == nullptr)
            return;
        // Where a desktop scales windows, the cursor is not counted in pixels.
        x *= static_cast<double>(drawing_.canvas().width()) / width;
        y *= static_cast<double>(drawing_.canvas().height()) / height;
        if (const auto key = drawing_.picture_at(*pair, x, y))
            inputs_.push_back({now, Pressed{*key, Device::Mouse}});
    }

    // Destroyed from the last to the first: textures before the window, the window before GLFW.
    std::unique_ptr<Glfw> glfw_;
    WindowHandle window_;
    GLFWmonitor* monitor_;
    WindowOptions options_;
    ViewDrawing drawing_;
    std::map<int, Key> keys_; ///< by GLFW's codes
    const Clock& clock_;
    PixelCheck pixels_;
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
    auto drawing = ViewDrawing::create(width, height, style_of(options), std::move(load));
    if (!drawing)
        return tl::unexpected(drawing.error());
    auto screen = std::make_unique<Window>(std::move(*glfw), std::move(*window), *monitor, options,
                                           std::move(*drawing), clock);
    if (auto shown = screen->show(GreyView{}); !shown)
        return tl::unexpected(shown.error());
    return screen;
}

} // namespace experiment::session
