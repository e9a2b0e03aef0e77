// A context on EGL's surfaceless platform, and controls that nobody touches.
#include "experiment/viewer/off_screen.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace experiment::viewer {

tl::expected<std::unique_ptr<OffScreen>, std::string> OffScreen::create(int width, int height) {
    auto context = renderer::gpu::Context::surfaceless();
    if (!context)
        return tl::unexpected(context.error());
    auto target = renderer::gpu::Target::create(width, height);
    if (!target)
        return tl::unexpected(target.error());
    auto gui = Gui::create();
    if (!gui)
        return tl::unexpected(gui.error());
    return std::unique_ptr<OffScreen>(
        new OffScreen(std::move(*context), std::move(*target), std::move(*gui)));
}

void OffScreen::begin_controls() {
    auto& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width()), static_cast<float>(height())};
    io.DeltaTime = 1.0F / 60.0F; // nothing moves, but it has to be above 0
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
}

} // namespace experiment::viewer
