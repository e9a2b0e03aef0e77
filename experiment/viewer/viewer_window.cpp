// What happens in the window is kept in order and handed out once: a key that goes down and up
// again within one slow frame still counts.
#include "experiment/viewer/viewer_window.h"

#include "experiment/session/glfw.h"
#include "experiment/viewer/gui.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

namespace experiment::viewer {

namespace {

using session::Glfw;
using session::WindowHandle;

/// Names of keys that stand for no letter.
std::string name_of(int key) {
    switch (key) {
    case GLFW_KEY_LEFT:
        return "Left";
    case GLFW_KEY_RIGHT:
        return "Right";
    case GLFW_KEY_UP:
        return "Up";
    case GLFW_KEY_DOWN:
        return "Down";
    case GLFW_KEY_TAB:
        return "Tab";
    case GLFW_KEY_ESCAPE:
        return "Esc";
    case GLFW_KEY_F1:
        return "F1";
    default:
        return "";
    }
}

/// What a held key goes on doing; a switch is not to flicker.
bool is_arrow(int key) {
    return key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT || key == GLFW_KEY_UP ||
           key == GLFW_KEY_DOWN;
}

/// The letter that the layout puts on the key, in upper case; "" for other keys.
std::string letter_of(int key, int scancode) {
    const char* name = glfwGetKeyName(key, scancode);
    const std::string_view text = name == nullptr ? "" : name;
    if (text.size() != 1 || std::isalpha(static_cast<unsigned char>(text[0])) == 0)
        return "";
    return {static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])))};
}

class ViewerWindow final : public Display {
  public:
    ViewerWindow(std::unique_ptr<Glfw> glfw, WindowHandle window, std::unique_ptr<Gui> gui)
        : glfw_(std::move(glfw)), window_(std::move(window)), gui_(std::move(gui)) {
        glfwSetWindowUserPointer(window_.get(), this);
        watch();
        ImGui_ImplGlfw_InitForOpenGL(window_.get(), true); // calls what was set before, too
    }

    ~ViewerWindow() override { ImGui_ImplGlfw_Shutdown(); }

    int width() const override { return size().first; }

    int height() const override { return size().second; }

    std::vector<Event> events(double seconds) override {
        if (seconds > 0 && events_.empty())
            glfwWaitEventsTimeout(seconds);
        else
            glfwPollEvents();
        return std::exchange(events_, {});
    }

    renderer::gpu::DrawingInto draw_into() override { return {0, width(), height()}; }

    void begin_controls() override {
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
    }

    void present() override { glfwSwapBuffers(window_.get()); }

  private:
    static ViewerWindow& self(GLFWwindow* window) {
        return *static_cast<ViewerWindow*>(glfwGetWindowUserPointer(window));
    }

    // A window that is iconified has no pixels, but pictures have to have some.
    std::pair<int, int> size() const {
        int width = 0, height = 0;
        glfwGetFramebufferSize(window_.get(), &width, &height);
        return {std::max(width, 1), std::max(height, 1)};
    }

    void watch() {
        glfwSetKeyCallback(window_.get(),
                           [](GLFWwindow* window, int key, int scancode, int action, int held) {
                               if (action != GLFW_RELEASE)
                                   self(window).on_key(key, scancode, held, action == GLFW_REPEAT);
                           });
        glfwSetCharCallback(window_.get(), [](GLFWwindow* window, unsigned character) {
            self(window).on_character(character);
        });
        glfwSetCursorPosCallback(window_.get(), [](GLFWwindow* window, double x, double y) {
            self(window).on_pointer(x, y);
        });
        glfwSetScrollCallback(window_.get(), [](GLFWwindow* window, double, double notches) {
            if (!ImGui::GetIO().WantCaptureMouse)
                self(window).events_.push_back(Scroll{notches});
        });
        glfwSetWindowCloseCallback(
            window_.get(), [](GLFWwindow* window) { self(window).events_.push_back(Closed{}); });
    }

    void on_key(int key, int scancode, int held, bool is_repeat) {
        const bool not_for_us = (held & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0;
        if (not_for_us || ImGui::GetIO().WantTextInput) // a number is being typed
            return;
        auto name = name_of(key);
        if (name.empty())
            name = letter_of(key, scancode);
        if (name.empty() || (is_repeat && !is_arrow(key)))
            return;
        const bool shift = (held & GLFW_MOD_SHIFT) != 0 && name != "F1" && name != "Esc";
        events_.push_back(Stroke{(shift ? "Shift+" : "") + name});
    }

    // On a layout where + needs Shift, its key without Shift is as good.
    void on_character(unsigned character) {
        constexpr std::string_view signs = "+-[],.123456789";
        if (ImGui::GetIO().WantTextInput || character > 0x7e)
            return;
        const char sign = character == '=' ? '+' : static_cast<char>(character);
        if (signs.find(sign) != std::string_view::npos)
            events_.push_back(Stroke{std::string(1, sign)});
    }

    void on_pointer(double x, double y) {
        const double right = x - pointer_x_, up = pointer_y_ - y;
        pointer_x_ = x;
        pointer_y_ = y;
        const auto down = [&](int button) {
            return glfwGetMouseButton(window_.get(), button) == GLFW_PRESS;
        };
        const bool shift = glfwGetKey(window_.get(), GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS ||
                           glfwGetKey(window_.get(), GLFW_KEY_RIGHT_SHIFT) == GLFW_PRESS;
        const bool first = down(GLFW_MOUSE_BUTTON_LEFT), other = down(GLFW_MOUSE_BUTTON_RIGHT);
        if ((first || other) && !ImGui::GetIO().WantCaptureMouse)
            events_.push_back(Drag{right, up, other || shift});
    }

    // Destroyed from the last to the first: controls before the window, the window before GLFW.
    std::unique_ptr<Glfw> glfw_;
    WindowHandle window_;
    std::unique_ptr<Gui> gui_;
    std::vector<Event> events_;
    double pointer_x_ = 0, pointer_y_ = 0;
};

} // namespace

tl::expected<std::unique_ptr<Display>, std::string>
open_viewer_window(int width, int height, const std::string& title) {
    auto glfw = Glfw::start("expected a desktop, or --screenshot FILE, which needs none");
    if (!glfw)
        return tl::unexpected(glfw.error());
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_SAMPLES, 0);
    WindowHandle window(glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr));
    if (!window)
        return tl::unexpected(fmt::format("no window of {} x {} with OpenGL 4.5 core can be opened "
                                          "({}); expected a driver with OpenGL 4.5, such as that "
                                          "of the package libgl1-mesa-dri",
                                          width, height, session::glfw_complaint()));
    glfwMakeContextCurrent(window.get());
    glfwSwapInterval(1);
    auto gui = Gui::create();
    if (!gui)
        return tl::unexpected(gui.error());
    return std::make_unique<ViewerWindow>(std::move(*glfw), std::move(window), std::move(*gui));
}

} // namespace experiment::viewer
