// The values of a PLY file's elements, one by one, whatever their encoding.
//
// Two classes with the same members, so that one reader, a template, serves both encodings without
// a virtual call for every number.
#pragma once

#include "renderer/geometry/mesh_building.h"
#include "renderer/geometry/ply_header.h"
#include "renderer/geometry/text_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace renderer::geometry {

static_assert(std::endian::native == std::endian::little);

/// The values of a text's elements: one element to a line.
class TextValues {
  public:
    TextValues(std::string_view text, const PlyHeader& header)
        : lines_(text), lines_before_(header.lines) {}

    /// Goes to the next element; false at the end of the file.
    bool begin_element() {
        next_ = 0;
        while (const auto line = lines_.next()) {
            split_fields(*line, fields_);
            if (!fields_.empty())
                return true;
        }
        return false;
    }

    Problem read(PlyType, double& value) {
        if (next_ == fields_.size())
            return fmt::format("the line ends after {} values, expected more", next_);
        const auto number = parse_real(fields_[next_]);
        if (!number)
            return fmt::format("{}, expected a number", shown(fields_[next_]));
        ++next_;
        value = *number;
        return std::nullopt;
    }

    Problem end_element() const {
        if (next_ == fields_.size())
            return std::nullopt;
        return fmt::format("{} values, expected {}", fields_.size(), next_);
    }

    /// Bytes that `element` takes at least: a digit and a separator for each property.
    static std::size_t least_bytes(const PlyElement& element) {
        return 2 * element.properties.size();
    }

    /// The last line may lack its ending.
    std::size_t bytes_left() const { return lines_.rest().size() + 1; }

    std::size_t most_values_left() const { return fields_.size() - next_; }

    std::string place(std::string_view name, std::string_view what) const {
        return at_line(name, lines_before_ + lines_.number(), what);
    }

  private:
    Lines lines_;
    std::size_t lines_before_;
    std::vector<std::string_view> fields_;
    std::size_t next_ = 0;
};

/// The values of binary data, one after the other.
class BinaryValues {
  public:
    BinaryValues(std::string_view data, const PlyHeader& header)
        : data_(data), bytes_before_(header.bytes),
          is_swapped_(header.encoding == PlyEncoding::BinaryBigEndian) {}

    bool begin_element() const { return next_ < data_.size(); }

    Problem read(PlyType type, double& value) {
        const auto size = size_of(type);
        if (size > data_.size() - next_)
            return std::string("the file ends in the middle of an element");
        std::array<char, 8> bytes{};
        std::memcpy(bytes.data(), data_.data() + next_, size);
        if (is_swapped_)
            std::reverse(bytes.data(), bytes.data() + size);
        next_ += size;
        value = decoded(type, bytes);
        return std::nullopt;
    }

    Problem end_element() const { return std::nullopt; }

    static std::size_t least_bytes(const PlyElement& element) {
        std::size_t bytes = 0;
        for (const auto& property : element.properties)
            bytes += size_of(property.list_count.value_or(property.type));
        return bytes;
    }

    std::size_t bytes_left() const { return data_.size() - next_; }

    std::size_t most_values_left() const { return bytes_left(); }

    std::string place(std::string_view name, std::string_view what) const {
        return fmt::format("{}: byte {}: {}", name, bytes_before_ + next_, what);
    }

  private:
    template <class Number>
    static double as(const std::array<char, 8>& bytes) {
        Number number;
        std::memcpy(&number, bytes.data(), sizeof number);
        return static_cast<double>(number);
    }

    static double decoded(PlyType type, const std::array<char, 8>& bytes) {
        switch (type) {
        case PlyType::Int8:
            return as<std::int8_t>(bytes);
        case PlyType::Uint8:
            return as<std::uint8_t>(bytes);
        case PlyType::Int16:
            return as<std::int16_t>(bytes);
        case PlyType::Uint16:
            return as<std::uint16_t>(bytes);
        case PlyType::Int32:
            return as<std::int32_t>(bytes);
        case PlyType::Uint32:
            return as<std::uint32_t>(bytes);
        case PlyType::Float32:
            return as<float>(bytes);
        case PlyType::Float64:
            return as<double>(bytes);
        }
        return 0;
    }

    std::string_view data_;
    std::size_t bytes_before_;
    bool is_swapped_;
    std::size_t next_ = 0;
};

} // namespace renderer::geometry
