// Reads PLY, the polygon file format of Stanford's scans.
#include "renderer/geometry/ply_file.h"

#include "renderer/geometry/mesh_building.h"
#include "renderer/geometry/ply_values.h"

#include <fmt/format.h>

#include <array>

namespace renderer::geometry {

namespace {

/// What the mesh needs from the header.
struct Wanted {
    const PlyElement* vertex = nullptr;
    const PlyElement* face = nullptr;
    std::array<std::size_t, 3> coordinates{};
    std::size_t corners = 0;
};

Expected<Wanted> find_wanted(const PlyHeader& header, std::string_view name) {
    Wanted wanted;
    for (const auto& element : header.elements) {
        if (element.name == "vertex" && wanted.vertex == nullptr)
            wanted.vertex = &element;
        if (element.name == "face" && wanted.face == nullptr)
            wanted.face = &element;
    }
    auto missing = [&](std::string_view what) {
        return tl::unexpected(fmt::format("{}: the header declares no {}", name, what));
    };
    if (wanted.vertex == nullptr)
        return missing("element vertex");
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto found = wanted.vertex->find(std::string_view("xyz").substr(axis, 1));
        if (!found || wanted.vertex->properties[*found].list_count)
            return missing("vertex property x, y or z that is a single number");
        wanted.coordinates[axis] = *found;
    }
    if (wanted.face == nullptr || wanted.face->count == 0)
        return missing("faces; points alone have no thickness");
    auto corners = wanted.face->find("vertex_indices");
    if (!corners)
        corners = wanted.face->find("vertex_index");
    if (!corners || !wanted.face->properties[*corners].list_count)
        return missing("face property list vertex_indices");
    wanted.corners = *corners;
    return wanted;
}

template <class Values>
class PlyReader {
  public:
    PlyReader(const Wanted& wanted, Values values) : wanted_(wanted), values_(std::move(values)) {}

    Expected<Mesh> read(const PlyHeader& header, std::string_view name) {
        Problem problem;
        for (const auto& element : header.elements)
            if (problem = read_elements(element); problem)
                break;
        if (!problem && values_.begin_element())
            problem = "data after the last element, expected the end of the file";
        if (problem)
            return tl::unexpected(values_.place(name, *problem));
        return std::move(mesh_);
    }

  private:
    Problem read_elements(const PlyElement& element) {
        if (element.properties.empty())
            return std::nullopt;
        if (auto problem =
                check_count(fmt::format("elements {}", shown(element.name)), element.count,
                            Values::least_bytes(element), values_.bytes_left()))
            return problem;
        if (&element == wanted_.vertex)
            mesh_.positions.reserve(element.count);
        if (&element == wanted_.face)
            mesh_.triangles.reserve(element.count);
        for (std::size_t i = 0; i < element.count; ++i)
            if (auto problem = read_element(element, i))
                return problem;
        return std::nullopt;
    }

    Problem read_element(const PlyElement& element, std::size_t i) {
        if (!values_.begin_element())
            return fmt::format("the file ends after {} of {} elements {}", i, element.count,
                               shown(element.name));
        glm::dvec3 position{};
        for (std::size_t k = 0; k < element.properties.size(); ++k) {
            const auto& property = element.properties[k];
            double value = 0;
            auto problem =
                property.list_count ? read_list(property) : values_.read(property.type, value);
            if (problem)
                return problem;
            if (&element == wanted_.vertex)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    if (wanted_.coordinates[axis] == k)
                        position[static_cast<int>(axis)] = value;
            if (&element == wanted_.face && k == wanted_.corners)
                if (problem = append_polygon(mesh_, list_, wanted_.vertex->count); problem)
                    return problem;
        }
        if (&element == wanted_.vertex)
            if (auto problem = append_vertex(mesh_, position))
                return problem;
        return values_.end_element();
    }

    Problem read_list(const PlyProperty& property) {
        double length = 0;
        if (auto problem = values_.read(*property.list_count, length))
            return problem;
        if (!(length >= 0 && length <= static_cast<double>(values_.most_values_left())))
            return fmt::format("a list of {} values, but at most {} follow", length,
                               values_.most_values_left());
        list_.clear();
        for (double k = 0; k < length; ++k) {
            double value = 0;
            if (auto problem = values_.read(property.type, value))
                return problem;
            list_.push_back(value);
        }
        return std::nullopt;
    }

    const Wanted& wanted_;
    Values values_;
    std::vector<double> list_;
    Mesh mesh_;
};

} // namespace

Expected<Mesh> read_ply(std::string_view bytes, std::string_view name) {
    const auto header = read_ply_header(bytes, name);
    if (!header)
        return tl::unexpected(header.error());
    const auto wanted = find_wanted(*header, name);
    if (!wanted)
        return tl::unexpected(wanted.error());
    const auto data = bytes.substr(header->bytes);
    if (header->encoding == PlyEncoding::Ascii)
        return PlyReader(*wanted, TextValues(data, *header)).read(*header, name);
    return PlyReader(*wanted, BinaryValues(data, *header)).read(*header, name);
}

} // namespace renderer::geometry
