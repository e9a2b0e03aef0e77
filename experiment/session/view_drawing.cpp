#include "experiment/session/view_drawing.h"

#include <algorithm>
#include <cmath>

namespace experiment::session {

namespace {

using renderer::gpu::Picture8;
using renderer::gpu::UploadedPicture;

Picture8 solid(int width, int height, const Patch& colour) {
    Picture8 picture{width, height, {}};
    picture.rgb.reserve(static_cast<std::size_t>(3 * width * height));
    for (int pixel = 0; pixel < width * height; ++pixel)
        for (const auto code : {colour.red, colour.green, colour.blue})
            picture.rgb.push_back(code);
    return picture;
}

} // namespace

ViewDrawing::ViewDrawing(
    int width, int height, DrawingStyle style, std::unique_ptr<PageDrawing> pages, LoadPicture load)
    : style_(std::move(style)), canvas_(width, height), layouts_(lay_out()),
      pages_(std::move(pages)), cache_(std::move(load), style_.sizes, style_.reference) {}

Expected<ViewDrawing>
ViewDrawing::create(int width, int height, DrawingStyle style, LoadPicture load) {
    auto pages = PageDrawing::create(width, height, style.text);
    if (!pages)
        return tl::unexpected(pages.error());
    ViewDrawing drawing(width, height, std::move(style), std::move(*pages), std::move(load));
    for (const auto& [scene, layout] : drawing.layouts_)
        if (!layout)
            return tl::unexpected(layout.error());
    return drawing;
}

ViewDrawing::Layouts ViewDrawing::lay_out() const {
    Layouts layouts;
    for (const auto& [scene, size] : style_.sizes)
        layouts.emplace(scene, lay_out_pair(canvas_.width(), canvas_.height(), size.width,
                                            size.height, style_.gap, style_.places));
    return layouts;
}

void ViewDrawing::resize(int width, int height) {
    canvas_ = renderer::gpu::PixelCanvas(width, height);
    pages_->resize(width, height);
    layouts_ = lay_out();
}

// A driver's first drawing of a kind can take a tenth of a second, which would make the first onset
// late.
PixelCheck ViewDrawing::check_pixels() const {
    canvas_.clear(style_.surround);
    const auto surround = canvas_.read(0, 0, canvas_.width(), canvas_.height());
    PixelCheck check{
        std::ranges::all_of(surround.rgb, [&](auto code) { return code == style_.surround; }),
        true};
    for (const auto& [scene, layout] : layouts_)
        if (layout)
            check.picture_exact = is_exact(*layout) && check.picture_exact;
    return check;
}

bool ViewDrawing::is_exact(const PairLayout& layout) const {
    Picture8 codes{layout.width, layout.height, {}};
    for (int pixel = 0; pixel < codes.width * codes.height; ++pixel)
        for (const int value : {pixel, 255 - pixel, pixel ^ 0x55})
            codes.rgb.push_back(static_cast<std::uint8_t>(value & 0xff));
    const UploadedPicture uploaded(codes);
    bool exact = true;
    for (const int left : {layout.left_x, layout.right_x}) {
        canvas_.draw(uploaded, left, layout.top);
        exact = canvas_.read(left, layout.top, codes.width, codes.height) == codes && exact;
    }
    return exact;
}

std::optional<Key> ViewDrawing::picture_at(const PairView& pair, double x, double y) const {
    const auto& layout = layouts_.at(pair.trial.scene);
    if (!layout || layout->left_x == layout->right_x)
        return std::nullopt; // one place: a click does not say which picture
    const auto inside = [&](int left) {
        return x >= left && x < left + layout->width && y >= layout->top &&
               y < layout->top + layout->height;
    };
    if (inside(layout->left_x))
        return Key::Left;
    return inside(layout->right_x) ? std::optional(Key::Right) : std::nullopt;
}

Expected<void> ViewDrawing::draw(const View& view) {
    canvas_.clear(style_.surround);
    if (const auto* page = std::get_if<PageView>(&view)) {
        for (const auto& patch : page->patches)
            draw_patch(patch);
        return pages_->draw(*page);
    }
    const auto* pair = std::get_if<PairView>(&view);
    draw_photodiode_patch(pair != nullptr);
    return pair != nullptr ? draw_pair(*pair) : Expected<void>{};
}

Expected<void> ViewDrawing::draw_pair(const PairView& pair) {
    const auto& layout = layouts_.at(pair.trial.scene);
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

void ViewDrawing::draw_patch(const Patch& patch) const {
    const auto pixels = [](double share, int size) {
        return static_cast<int>(std::lround(share * size));
    };
    const UploadedPicture uploaded(
        solid(pixels(patch.width, canvas_.width()), pixels(patch.height, canvas_.height()), patch));
    canvas_.draw(uploaded, pixels(patch.left, canvas_.width()),
                 pixels(patch.top, canvas_.height()));
}

// White as long as pictures are on the screen, black in the grey between them.
void ViewDrawing::draw_photodiode_patch(bool lit) const {
    const int edge = std::min({style_.photodiode_px, canvas_.width(), canvas_.height()});
    if (edge <= 0)
        return;
    const auto code = static_cast<std::uint8_t>(lit ? 255 : 0);
    const UploadedPicture uploaded(solid(edge, edge, {0, 0, 0, 0, code, code, code}));
    canvas_.draw(uploaded, 0, canvas_.height() - edge);
}

} // namespace experiment::session
