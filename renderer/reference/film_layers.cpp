// A double is the sum of three floats, each the rounding of what the ones before left: 72 bits of
// room for 53.
#include "renderer/reference/film_layers.h"

#include "renderer/contract.h"

#include <fmt/format.h>

#include <array>
#include <string>

namespace renderer::reference {

namespace {

constexpr std::array<const char*, 3> channel_names{"R", "G", "B"};
constexpr std::array<const char*, 3> pieces{"", ".low", ".lower"};

using Sums = std::vector<Spectrum<3>>;

std::string channel_name(const char* what, std::size_t piece, std::size_t k) {
    return fmt::format("{}{}.{}", what, pieces[piece], channel_names[k]);
}

void append(imaging::LayeredImage& image, const char* what, const Sums& sums) {
    for (std::size_t k = 0; k < 3; ++k) {
        std::array<imaging::Layer, 3> layers;
        for (std::size_t piece = 0; piece < 3; ++piece)
            layers[piece].channel = channel_name(what, piece, k);
        for (const auto& sum : sums) {
            double left = sum[k];
            for (auto& layer : layers) {
                layer.values.push_back(static_cast<float>(left));
                left -= static_cast<double>(layer.values.back());
            }
        }
        for (auto& layer : layers)
            image.layers.push_back(std::move(layer));
    }
}

Expected<void> restore(const imaging::LayeredImage& image, const char* what, Sums& sums) {
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t piece = 3; piece-- > 0;) { // small ones first: no rounding
            const auto name = channel_name(what, piece, k);
            const auto* layer = imaging::find_layer(image, name);
            if (layer == nullptr)
                return tl::unexpected(
                    fmt::format("has no channel {}: not a reference that can be continued", name));
            for (std::size_t i = 0; i < sums.size(); ++i)
                sums[i][k] += static_cast<double>(layer->values[i]);
        }
    return {};
}

} // namespace

imaging::LayeredImage layers_of(const Film& film) {
    EXPECTS(film.batches > 1);
    const auto light = picture(film);
    const auto error = error_picture(film);
    imaging::LayeredImage image{film.width, film.height, {}};
    const auto add_layer = [&](const char* name, auto&& value) {
        imaging::Layer layer{name, {}};
        for (std::size_t i = 0; i < film.sum.size(); ++i)
            layer.values.push_back(value(i));
        image.layers.push_back(std::move(layer));
    };
    add_layer("R", [&](std::size_t i) { return light.pixels[i].r; });
    add_layer("G", [&](std::size_t i) { return light.pixels[i].g; });
    add_layer("B", [&](std::size_t i) { return light.pixels[i].b; });
    add_layer("A", [&](std::size_t i) { return light.coverage[i]; });
    add_layer("variance.R", [&](std::size_t i) { return error.pixels[i].r * error.pixels[i].r; });
    add_layer("variance.G", [&](std::size_t i) { return error.pixels[i].g * error.pixels[i].g; });
    add_layer("variance.B", [&](std::size_t i) { return error.pixels[i].b * error.pixels[i].b; });
    const auto samples =
        static_cast<float>(film.batches) * static_cast<float>(1u << film.log2_batch);
    add_layer("count", [&](std::size_t) { return samples; });
    add_layer("covered", [&](std::size_t i) { return static_cast<float>(film.covered[i]); });
    append(image, "sum", film.sum);
    append(image, "squares", film.squares);
    append(image, "odd", film.odd);
    return image;
}

Expected<Film> film_of(const imaging::LayeredImage& image, const FilmRecord& record) {
    Film film = blank_film(image.width, image.height, record.seed, record.log2_batch);
    film.batches = record.batches;
    film.paths = record.paths;
    film.leaks = record.leaks;
    const auto* covered = imaging::find_layer(image, "covered");
    if (covered == nullptr)
        return tl::unexpected(
            std::string("has no channel covered: not a reference that can be continued"));
    film.covered.assign(covered->values.begin(), covered->values.end());
    const auto restored = restore(image, "sum", film.sum)
                              .and_then([&] { return restore(image, "squares", film.squares); })
                              .and_then([&] { return restore(image, "odd", film.odd); });
    if (!restored)
        return tl::unexpected(restored.error());
    return film;
}

} // namespace renderer::reference
