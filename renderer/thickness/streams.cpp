// Quantisation band by band, in bytes block by block.
#include "renderer/thickness/streams.h"

#include "renderer/contract.h"
#include "renderer/harmonics/basis.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace renderer::thickness {

namespace {

/// Largest magnitude in one band; 1 where there is none, so that it can be divided by.
float largest_in_band(const ThicknessField& field, int l) {
    const auto stride = static_cast<std::size_t>(harmonics::coefficient_count(field.bands));
    const auto begin = static_cast<std::size_t>(l * l),
               end = static_cast<std::size_t>((l + 1) * (l + 1));
    float largest = 0;
    for (std::size_t v = 0; v < field.coefficients.size(); v += stride)
        for (std::size_t i = begin; i < end; ++i)
            largest = std::max(largest, std::abs(field.coefficients[v + i]));
    return largest > 0 ? largest : 1.0f;
}

/// Float16 reaches from 6e-8 to 65504, and models come in any unit: dividing by the power of two
/// next to the largest leaves every digit and no overflow.
float scale_of_band(const ThicknessField& field, int l, ComponentType type) {
    switch (type) {
    case ComponentType::Float32:
        return 1;
    case ComponentType::Float16:
    case ComponentType::Int8: // centres and steps are Float16
        return std::exp2(std::ceil(std::log2(largest_in_band(field, l))));
    }
    return 1;
}

/// Of a number in -1..1, nearest, ties to even.
std::uint16_t float16(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const std::uint32_t sign = bits >> 16 & 0x8000u;
    const std::uint32_t magnitude = bits & 0x7fffffffu;
    const std::uint32_t even = magnitude >> 13 & 1u;
    const std::uint32_t half =
        magnitude < 0x38800000u // below 2^-14 steps are 2^-24, everywhere
            ? static_cast<std::uint32_t>(std::nearbyint(std::bit_cast<float>(magnitude) * 0x1p24f))
            : (magnitude - 0x38000000u + 0xfffu + even) >> 13;
    return static_cast<std::uint16_t>(sign | half);
}

float from_float16(std::uint16_t half) {
    const std::uint32_t exponent = half >> 10 & 0x1fu, significand = half & 0x3ffu;
    const float magnitude = exponent == 0
                                ? static_cast<float>(significand) * 0x1p-24f
                                : std::bit_cast<float>((exponent + 112u) << 23 | significand << 13);
    return half & 0x8000u ? -magnitude : magnitude;
}

template <class T>
std::byte* put(std::byte* out, T value) {
    std::memcpy(out, &value, sizeof value);
    return out + sizeof value;
}

template <class T>
T get(const std::byte* in) {
    T value;
    std::memcpy(&value, in, sizeof value);
    return value;
}

/// What bytes are read against.
struct Range {
    float centre = 0, step = 0;
};

std::uint32_t packed(float centre, float step) {
    return static_cast<std::uint32_t>(float16(step)) << 16 | float16(centre);
}

Range unpacked(std::uint32_t word) {
    return {from_float16(static_cast<std::uint16_t>(word)),
            from_float16(static_cast<std::uint16_t>(word >> 16))};
}

/// The range that holds least..most.  As Float16 it is rounded: the centre first, then the step
/// upward, past what the centre has moved.
std::uint32_t range_of(float least, float most) {
    const float centre = from_float16(float16((least + most) / 2));
    const float reach = std::max(most - centre, centre - least);
    std::uint32_t word = packed(centre, reach);
    if (unpacked(word).step < reach)
        word += 1u << 16; // the next Float16
    return word;
}

std::byte* write(std::byte* out, ComponentType type, float value, Range range) {
    switch (type) {
    case ComponentType::Float32:
        return put(out, value);
    case ComponentType::Float16:
        return put(out, float16(value));
    case ComponentType::Int8: {
        const float steps = range.step > 0 ? (value - range.centre) / range.step : 0;
        return put(out, static_cast<std::int8_t>(std::lround(127 * steps)));
    }
    }
    return out;
}

float read(const std::byte* in, ComponentType type, Range range) {
    switch (type) {
    case ComponentType::Float32:
        return get<float>(in);
    case ComponentType::Float16:
        return from_float16(get<std::uint16_t>(in));
    case ComponentType::Int8:
        return range.centre + range.step * (static_cast<float>(get<std::int8_t>(in)) / 127);
    }
    return 0;
}

std::size_t blocks_of(std::size_t vertices) {
    return (vertices + block_vertices - 1) / block_vertices;
}

/// Of component k at vertex v; nothing for a type without blocks.
Range range_at(const Stream& stream, std::size_t v, std::size_t k) {
    return stream.blocks.empty()
               ? Range{}
               : unpacked(stream.blocks[v / block_vertices * stream.scale.size() + k]);
}

/// The ranges of a stream's components in each block; `first` is its first coefficient.
std::vector<std::uint32_t>
block_ranges(const ThicknessField& field, std::size_t first, std::span<const float> scale) {
    const auto stride = static_cast<std::size_t>(harmonics::coefficient_count(field.bands));
    const std::size_t vertices = field.coefficients.size() / stride;
    std::vector<std::uint32_t> ranges;
    for (std::size_t begin = 0; begin < vertices; begin += block_vertices)
        for (std::size_t k = 0; k < scale.size(); ++k) {
            float least = INFINITY, most = -INFINITY;
            for (std::size_t v = begin; v < std::min(vertices, begin + block_vertices); ++v) {
                const float value = field.coefficients[v * stride + first + k] / scale[k];
                least = std::min(least, value);
                most = std::max(most, value);
            }
            ranges.push_back(range_of(least, most));
        }
    return ranges;
}

Stream stream_of(const ThicknessField& field, int first_band, int last_band, ComponentType type) {
    Stream stream{type, first_band, last_band, {}, {}, {}};
    for (int l = first_band; l <= last_band; ++l)
        stream.scale.insert(stream.scale.end(), static_cast<std::size_t>(2 * l + 1),
                            scale_of_band(field, l, type));
    const auto stride = static_cast<std::size_t>(harmonics::coefficient_count(field.bands));
    const auto first = static_cast<std::size_t>(first_band * first_band);
    const std::size_t vertices = field.coefficients.size() / stride;
    if (type == ComponentType::Int8)
        stream.blocks = block_ranges(field, first, stream.scale);
    stream.bytes.resize(vertices * stream.scale.size() * bytes_of(type));
    std::byte* out = stream.bytes.data();
    for (std::size_t v = 0; v < vertices; ++v)
        for (std::size_t k = 0; k < stream.scale.size(); ++k)
            out = write(out, type, field.coefficients[v * stride + first + k] / stream.scale[k],
                        range_at(stream, v, k));
    return stream;
}

} // namespace

std::size_t bytes_of(ComponentType type) {
    switch (type) {
    case ComponentType::Float32:
        return 4;
    case ComponentType::Float16:
        return 2;
    case ComponentType::Int8:
        return 1;
    }
    return 0;
}

std::vector<Stream> band_streams(const ThicknessField& field, int bands, ComponentType type) {
    EXPECTS(bands >= 1 && bands <= field.bands);
    std::vector<Stream> streams{stream_of(field, 0, std::min(bands, 2) - 1, type)};
    for (int l = 2; l < bands; ++l)
        streams.push_back(stream_of(field, l, l, type));
    return streams;
}

std::vector<float> coefficients_of(std::span<const Stream> streams) {
    EXPECTS(!streams.empty());
    const int bands = streams.back().last_band + 1;
    const auto stride = static_cast<std::size_t>(harmonics::coefficient_count(bands));
    const auto vertices = streams.front().bytes.size() /
                          (streams.front().scale.size() * bytes_of(streams.front().type));
    std::vector<float> coefficients(vertices * stride);
    for (const auto& stream : streams) {
        const std::size_t size = bytes_of(stream.type), components = stream.scale.size();
        EXPECTS(stream.bytes.size() == vertices * components * size);
        const auto first = static_cast<std::size_t>(stream.first_band * stream.first_band);
        EXPECTS(first + components <= stride);
        EXPECTS(stream.blocks.size() ==
                (stream.type == ComponentType::Int8 ? blocks_of(vertices) * components : 0));
        for (std::size_t v = 0; v < vertices; ++v)
            for (std::size_t k = 0; k < components; ++k)
                coefficients[v * stride + first + k] =
                    stream.scale[k] * read(&stream.bytes[(v * components + k) * size], stream.type,
                                           range_at(stream, v, k));
    }
    return coefficients;
}

} // namespace renderer::thickness
