// Reads Wavefront OBJ, by tinyobjloader.
//
// tinyobjloader takes what is not a number for 0 without a word, so every line is checked first.
// Its callbacks hand over faces as they stand in the file; its own cutting of polygons is not
// needed.
#include "renderer/geometry/obj_file.h"

#include "renderer/geometry/mesh_building.h"
#include "renderer/geometry/text_fields.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

namespace renderer::geometry {

namespace {

/// The lines on which vertices and faces stand, in their order.
struct Places {
    std::vector<std::size_t> vertices, faces;
};

Problem check_vertex(const std::vector<std::string_view>& fields) {
    if (fields.size() < 4)
        return fmt::format("a vertex with {} coordinates, expected x y z", fields.size() - 1);
    for (std::size_t k = 1; k < 4; ++k)
        if (const auto value = parse_real(fields[k]); !value || !std::isfinite(*value))
            return fmt::format("a vertex with {}, expected a finite number", shown(fields[k]));
    return std::nullopt;
}

/// A corner is v, v/vt, v//vn or v/vt/vn, whole numbers that fit tinyobjloader's int.
bool is_corner(std::string_view field) {
    constexpr std::size_t longest_index = 10; // -999999999, which is above -2^31
    int parts = 0;
    for (bool more = true; more; ++parts) {
        const auto slash = field.find('/');
        auto index = field.substr(0, slash);
        more = slash != field.npos;
        field.remove_prefix(more ? slash + 1 : field.size());
        if (index.empty() && parts == 1 && more)
            continue;
        if (index.size() > longest_index || (index.size() == longest_index && index[0] != '-'))
            return false;
        if (index.starts_with('-'))
            index.remove_prefix(1);
        if (!parse_count(index))
            return false;
    }
    return parts <= 3;
}

Problem check_face(const std::vector<std::string_view>& fields) {
    for (std::size_t k = 1; k < fields.size(); ++k)
        if (!is_corner(fields[k]))
            return fmt::format(
                "a face with {}, expected vertex[/texture[/normal]] as whole numbers",
                shown(fields[k]));
    if (fields.size() < 4)
        return fmt::format("a face with {} corners, expected at least 3", fields.size() - 1);
    return std::nullopt;
}

Expected<Places> check_lines(std::string_view text, std::string_view name) {
    using namespace std::string_view_literals;
    Places places;
    Lines lines(text);
    std::vector<std::string_view> fields;
    while (const auto line = lines.next()) {
        Problem problem;
        if (line->find_first_of("\0\r\n"sv) != line->npos)
            problem = "a control character, expected lines of text with one kind of ending";
        split_fields(*line, fields);
        if (!problem && !fields.empty() && fields[0] == "v") {
            problem = check_vertex(fields);
            places.vertices.push_back(lines.number());
        } else if (!problem && !fields.empty() && fields[0] == "f") {
            problem = check_face(fields);
            places.faces.push_back(lines.number());
        }
        if (problem)
            return tl::unexpected(at_line(name, lines.number(), *problem));
    }
    if (places.faces.empty())
        return tl::unexpected(
            fmt::format("{}: no faces (lines that begin with f); points alone have "
                        "no thickness",
                        name));
    return places;
}

/// What tinyobjloader's callbacks fill.
struct Growing {
    const Places& places;
    std::string_view name;
    Mesh mesh;
    std::size_t faces = 0;
    std::vector<double> corners;
    Problem problem = std::nullopt; ///< the first one, with its place

    void add_vertex(glm::dvec3 position) {
        if (problem)
            return;
        const auto line = places.vertices[mesh.positions.size()];
        if (const auto what = append_vertex(mesh, position))
            problem = at_line(name, line, *what);
    }

    void add_face(std::span<const tinyobj::index_t> indices) {
        if (problem)
            return;
        const auto line = places.faces[faces++];
        const auto all = places.vertices.size();
        corners.clear();
        for (const auto& index : indices) {
            const long corner = index.vertex_index;
            const auto so_far = static_cast<long>(mesh.positions.size());
            if (corner == 0 || corner > static_cast<long>(all) || corner < -so_far) {
                problem = at_line(
                    name, line,
                    fmt::format(
                        "a face with vertex {}, expected 1 to {}, or -1 to -{} counted back",
                        corner, all, so_far));
                return;
            }
            corners.push_back(static_cast<double>(corner > 0 ? corner - 1 : so_far + corner));
        }
        if (const auto what = append_polygon(mesh, corners, all))
            problem = at_line(name, line, *what);
    }
};

} // namespace

Expected<Mesh> read_obj(std::string_view text, std::string_view name) {
    const auto places = check_lines(text, name);
    if (!places)
        return tl::unexpected(places.error());
    Growing growing{*places, name, {}, 0, {}};
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = [](void* user, double x, double y, double z, double) {
        static_cast<Growing*>(user)->add_vertex({x, y, z});
    };
    callbacks.index_cb = [](void* user, tinyobj::index_t* indices, int count) {
        static_cast<Growing*>(user)->add_face({indices, static_cast<std::size_t>(count)});
    };
    std::istringstream stream{std::string(text)};
    std::string error;
    if (!tinyobj::LoadObjWithCallback(stream, callbacks, &growing, nullptr, nullptr, &error))
        return tl::unexpected(fmt::format("{}: {}", name, error));
    if (growing.problem)
        return tl::unexpected(*growing.problem);
    return std::move(growing.mesh);
}

} // namespace renderer::geometry
