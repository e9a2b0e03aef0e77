// The header of a PLY file: which elements follow, in which order and encoding.
#include "renderer/geometry/ply_header.h"

#include "renderer/geometry/mesh_building.h"
#include "renderer/geometry/text_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace renderer::geometry {

namespace {

using Fields = std::vector<std::string_view>;

std::optional<PlyType> type_named(std::string_view name) {
    static constexpr std::array<std::pair<std::string_view, PlyType>, 16> names{
        {{"char", PlyType::Int8},
         {"int8", PlyType::Int8},
         {"uchar", PlyType::Uint8},
         {"uint8", PlyType::Uint8},
         {"short", PlyType::Int16},
         {"int16", PlyType::Int16},
         {"ushort", PlyType::Uint16},
         {"uint16", PlyType::Uint16},
         {"int", PlyType::Int32},
         {"int32", PlyType::Int32},
         {"uint", PlyType::Uint32},
         {"uint32", PlyType::Uint32},
         {"float", PlyType::Float32},
         {"float32", PlyType::Float32},
         {"double", PlyType::Float64},
         {"float64", PlyType::Float64}}};
    for (const auto& [known, type] : names)
        if (known == name)
            return type;
    return std::nullopt;
}

bool is_whole(PlyType type) {
    return type != PlyType::Float32 && type != PlyType::Float64;
}

Problem read_format(const Fields& fields, PlyHeader& header) {
    const auto format = fields.size() == 3 && fields[2] == "1.0" ? fields[1] : std::string_view{};
    if (format == "ascii")
        header.encoding = PlyEncoding::Ascii;
    else if (format == "binary_little_endian")
        header.encoding = PlyEncoding::BinaryLittleEndian;
    else if (format == "binary_big_endian")
        header.encoding = PlyEncoding::BinaryBigEndian;
    else
        return std::string("this format is not known, expected ascii, binary_little_endian or "
                           "binary_big_endian 1.0");
    return std::nullopt;
}

Problem read_element(const Fields& fields, PlyHeader& header) {
    const auto count = fields.size() == 3 ? parse_count(fields[2]) : std::nullopt;
    if (!count)
        return std::string("expected element, its name and a count");
    header.elements.push_back({std::string(fields[1]), *count, {}});
    return std::nullopt;
}

Problem read_property(const Fields& fields, PlyHeader& header) {
    if (header.elements.empty())
        return std::string("a property before the first element");
    PlyProperty property{std::string(fields.back()), {}, {}};
    const bool is_list = fields.size() == 5 && fields[1] == "list";
    const auto type =
        is_list || fields.size() == 3 ? type_named(fields[fields.size() - 2]) : std::nullopt;
    if (is_list)
        property.list_count = type_named(fields[2]);
    if (!type || (is_list && !(property.list_count && is_whole(*property.list_count))))
        return std::string(
            "expected property, a type and a name, or property list, a whole type, a "
            "type and a name");
    property.type = *type;
    header.elements.back().properties.push_back(std::move(property));
    return std::nullopt;
}

} // namespace

std::size_t size_of(PlyType type) {
    switch (type) {
    case PlyType::Int8:
    case PlyType::Uint8:
        return 1;
    case PlyType::Int16:
    case PlyType::Uint16:
        return 2;
    case PlyType::Int32:
    case PlyType::Uint32:
    case PlyType::Float32:
        return 4;
    case PlyType::Float64:
        return 8;
    }
    return 0;
}

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
    const auto found = std::find_if(properties.begin(), properties.end(),
                                    [&](const auto& p) { return p.name == property; });
    if (found == properties.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - properties.begin());
}

Expected<PlyHeader> read_ply_header(std::string_view bytes, std::string_view name) {
    PlyHeader header;
    Lines lines(bytes);
    if (lines.next() != "ply")
        return tl::unexpected(at_line(name, 1, "expected ply, the first line of every PLY file"));
    Fields fields;
    bool has_format = false;
    while (const auto line = lines.next()) {
        split_fields(*line, fields);
        if (fields.empty() || fields[0] == "comment" || fields[0] == "obj_info")
            continue;
        Problem problem;
        if (fields[0] == "end_header") {
            if (!has_format)
                return tl::unexpected(at_line(name, lines.number(), "no format line came before"));
            header.lines = lines.number();
            header.bytes = bytes.size() - lines.rest().size();
            return header;
        }
        if (fields[0] == "format") {
            problem = read_format(fields, header);
            has_format = true;
        } else if (fields[0] == "element") {
            problem = read_element(fields, header);
        } else if (fields[0] == "property") {
            problem = read_property(fields, header);
        } else {
            problem = fmt::format("{}, expected format, element, property, comment or end_header",
                                  shown(fields[0]));
        }
        if (problem)
            return tl::unexpected(at_line(name, lines.number(), *problem));
    }
    return tl::unexpected(
        at_line(name, lines.number(), "the file ends before the header does, with end_header"));
}

} // namespace renderer::geometry
