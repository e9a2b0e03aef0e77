// Box filter with exact overlaps, one direction after the other.
#include "renderer/imaging/reduction.h"

#include "renderer/contract.h"

#include <algorithm>
#include <cmath>

namespace renderer::imaging {

namespace {

// How the pixels of a shorter line are made of those of a longer one.
struct Overlap {
    std::size_t to, from;
    float weight; // of `from` in `to`; those of one `to` sum to 1
};

std::vector<Overlap> overlaps(int from, int to) {
    std::vector<Overlap> found;
    const double scale = static_cast<double>(from) / to;
    for (int target = 0; target < to; ++target) {
        const double begin = target * scale;
        const double end = (target + 1) * scale;
        for (int source = static_cast<int>(begin); source < from && source < end; ++source) {
            const double shared =
                std::min(end, source + 1.0) - std::max(begin, static_cast<double>(source));
            if (shared > 0)
                found.push_back({static_cast<std::size_t>(target), static_cast<std::size_t>(source),
                                 static_cast<float>(shared / scale)});
        }
    }
    return found;
}

void add(LinearRgb& sum, LinearRgb light, float weight) {
    sum.r += weight * light.r;
    sum.g += weight * light.g;
    sum.b += weight * light.b;
}

int reduced_edge(int edge, int longer, int greatest) {
    return std::max(1,
                    static_cast<int>(std::lround(static_cast<double>(edge) * greatest / longer)));
}

} // namespace

EncodedImage reduced(const EncodedImage& image, int greatest_edge) {
    EXPECTS(image.width > 0 && image.height > 0 && greatest_edge >= 1);
    const int longer = std::max(image.width, image.height);
    const int greatest = std::min(longer, greatest_edge);
    const int width = reduced_edge(image.width, longer, greatest);
    const int height = reduced_edge(image.height, longer, greatest);
    const auto wide = static_cast<std::size_t>(image.width);
    const auto narrow = static_cast<std::size_t>(width);
    const auto tall = static_cast<std::size_t>(image.height);
    const auto low = static_cast<std::size_t>(height);

    std::vector<LinearRgb> squeezed(narrow * tall);
    for (std::size_t row = 0; row < tall; ++row)
        for (const auto& [to, from, weight] : overlaps(image.width, width))
            add(squeezed[row * narrow + to], light_at(image, row * wide + from), weight);

    LinearImage small{width, height, std::vector<LinearRgb>(narrow * low),
                      std::vector<float>(narrow * low, 1.0F)};
    for (const auto& [to, from, weight] : overlaps(image.height, height))
        for (std::size_t column = 0; column < narrow; ++column)
            add(small.pixels[to * narrow + column], squeezed[from * narrow + column], weight);
    return encode_8bit(small);
}

} // namespace renderer::imaging
