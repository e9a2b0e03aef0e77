// A film as the channels of a picture file, from which it can be gone on with.
#pragma once

#include "renderer/expected.h"
#include "renderer/imaging/layers.h"
#include "renderer/reference/film.h"

namespace renderer::reference {

/// R, G, B, A: the mean and the coverage.  variance.R ...: of the mean.  count: samples.  sum,
/// squares and odd, each in three pieces whose sum is the double: what resuming needs, bit for bit.
/// Errors: EXPECTS two batches.
imaging::LayeredImage layers_of(const Film& film);

/// What the file beside its channels has to say of a film.
struct FilmRecord {
    std::uint64_t seed = 1;
    int log2_batch = 4;
    std::uint32_t batches = 0;
    std::uint64_t paths = 0, leaks = 0;
};

/// Errors: names the channel that is missing.
Expected<Film> film_of(const imaging::LayeredImage& image, const FilmRecord& record);

} // namespace renderer::reference
