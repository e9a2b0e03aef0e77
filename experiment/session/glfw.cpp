// Starting GLFW, and saying why it does not start.
#include "experiment/session/glfw.h"

#include <fmt/format.h>

#include <cstdlib>

namespace experiment::session {

std::string glfw_complaint() {
    const char* words = nullptr;
    return glfwGetError(&words) == GLFW_NO_ERROR || words == nullptr ? "no reason given" : words;
}

protocols::Expected<std::unique_ptr<Glfw>> Glfw::start(std::string_view remedy) {
    if (glfwInit() == GLFW_TRUE)
        return std::unique_ptr<Glfw>(new Glfw);
    const char* display = std::getenv("DISPLAY");
    return tl::unexpected(fmt::format(
        "there is no display to show pictures on (DISPLAY is {}; {}); {}",
        display ? fmt::format("\"{}\"", display) : "not set", glfw_complaint(), remedy));
}

Glfw::~Glfw() {
    glfwTerminate();
}

} // namespace experiment::session
