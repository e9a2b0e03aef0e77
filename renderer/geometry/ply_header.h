// The header of a PLY file: which elements follow, in which order and encoding.
#pragma once

#include "renderer/expected.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace renderer::geometry {

enum class PlyEncoding { Ascii, BinaryLittleEndian, BinaryBigEndian };

enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

/// Bytes of one value in a binary file.
std::size_t size_of(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;
    std::optional<PlyType> list_count; ///< of a list: the type of its length
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;

    /// Index of the property of that name.
    std::optional<std::size_t> find(std::string_view property) const;
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::Ascii;
    std::vector<PlyElement> elements;
    std::size_t lines = 0; ///< of the header, end_header included
    std::size_t bytes = 0; ///< of the header: the data begin here
};

/// Errors: "<name>:<line>: ..." for anything that is not a PLY 1.0 header.
Expected<PlyHeader> read_ply_header(std::string_view bytes, std::string_view name);

} // namespace renderer::geometry
