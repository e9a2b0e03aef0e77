// GLFW's door: windows are opened through it.
#pragma once

#include "protocols/expected.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <memory>
#include <string>
#include <string_view>

namespace experiment::session {

/// GLFW's last complaint, for messages.
std::string glfw_complaint();

/// The library, initialised while this lives.
class Glfw {
  public:
    /// Errors: no display; the message ends with `remedy`.
    static protocols::Expected<std::unique_ptr<Glfw>> start(std::string_view remedy);

    ~Glfw();
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;

  private:
    Glfw() = default;
};

struct DestroyWindow {
    void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};

using WindowHandle = std::unique_ptr<GLFWwindow, DestroyWindow>;

} // namespace experiment::session
