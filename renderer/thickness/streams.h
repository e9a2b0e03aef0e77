// Coefficients as the graphics memory holds them: one stream for each band, in few bytes.
//
// A frame that uses n bands fetches the streams of these bands, and no more has to be stored.
#pragma once

#include "renderer/thickness/thickness_field.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace renderer::thickness {

/// How one component is written.
enum class ComponentType : std::uint32_t {
    Float32, ///< as it is
    Float16, ///< IEEE 754 binary16, nearest, ties to even
    Int8     ///< signed byte i, -127..127: i/127 of a step from the centre of its block
};

std::size_t bytes_of(ComponentType type);

/// So many vertices, one after the other, make a block.  Neighbours are alike: within a block a
/// coefficient spans a third of what it spans over the mesh, if vertices lie in an order that keeps
/// neighbours together (geometry::along_morton_curve).  Smaller blocks are finer and cost more.
inline constexpr std::size_t block_vertices = 128;

/// Bands first_band..last_band of all vertices, vertex by vertex without padding, native byte
/// order: bands 0 and 1 together (4 components), then a stream for each band (5, 7, 9, ...).
struct Stream {
    ComponentType type = ComponentType::Float32;
    int first_band = 0, last_band = 0;
    /// A coefficient is scale[k] times component k as its type is read.  So multiply y(L) by it
    /// once a frame, and the components can be used as they are.  One value for each band, repeated
    /// for its components: 1 for Float32, a power of two for the others.
    std::vector<float> scale;
    std::vector<std::byte> bytes;
    /// Of Int8 alone: component k in block b reads centre + step i/127; blocks[b components() + k]
    /// holds both as Float16, the centre in the lower half.
    std::vector<std::uint32_t> blocks;

    int components() const { return static_cast<int>(scale.size()); } ///< of one vertex
};

/// The first `bands` bands of a field.  Without an error for Float32; else with one in each
/// coefficient of at most 2^-11 of itself (Float16) or 1/254 of its step (Int8), which is half of
/// what the coefficient spans in its block and 2^-10 of the band's largest at most.  Errors delta
/// of a vertex's coefficients change its thickness by n/(2 sqrt(pi)) ||delta|| at most. Errors:
/// EXPECTS 1 <= bands <= field.bands.
std::vector<Stream> band_streams(const ThicknessField& field, int bands, ComponentType type);

/// The coefficients that streams stand for, vertex-major as in `ThicknessField`.
/// Errors: EXPECTS the streams of `band_streams`, all of them and in their order.
std::vector<float> coefficients_of(std::span<const Stream> streams);

} // namespace renderer::thickness
