// Of two pictures, the channel that differs most.
#include "renderer/pictures/choice_change.h"

#include "renderer/imaging/brightness.h"
#include "renderer/pictures/picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace renderer::pictures {

namespace {

double largest_rms(const imaging::LinearImage& a, const imaging::LinearImage& b) {
    const auto mask = imaging::covered_pixels(a.coverage);
    std::array<double, 3> squares{};
    for (const auto i : mask) {
        const auto &x = a.pixels[i], &y = b.pixels[i];
        const std::array<double, 3> off{static_cast<double>(x.r) - static_cast<double>(y.r),
                                        static_cast<double>(x.g) - static_cast<double>(y.g),
                                        static_cast<double>(x.b) - static_cast<double>(y.b)};
        for (std::size_t c = 0; c < 3; ++c)
            squares[c] += off[c] * off[c];
    }
    return std::sqrt(*std::max_element(squares.begin(), squares.end()) /
                     static_cast<double>(mask.size()));
}

} // namespace

Expected<std::optional<double>> measured_change(methods::Method& method,
                                                const Scene& scene,
                                                const imaging::LinearImage& image,
                                                int samples) {
    if (!method.predicted_change())
        return std::nullopt;
    method.let_choose(false);
    const auto whole = render_picture(method, scene, image.width, image.height, samples);
    method.let_choose(true);
    if (!whole)
        return tl::make_unexpected(whole.error());
    return largest_rms(image, *whole);
}

} // namespace renderer::pictures
