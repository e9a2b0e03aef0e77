// Reads and writes OFF, the Object File Format of Geomview.
#include "renderer/geometry/off_file.h"

#include "renderer/geometry/mesh_building.h"
#include "renderer/geometry/text_fields.h"

#include <fmt/format.h>

namespace renderer::geometry {

namespace {

class OffReader {
  public:
    OffReader(std::string_view text, std::string_view name) : lines_(text), name_(name) {}

    Expected<Mesh> read() {
        Problem problem = read_header();
        for (std::size_t i = 0; i < vertices_ && !problem; ++i)
            problem = read_vertex(i);
        for (std::size_t i = 0; i < faces_ && !problem; ++i)
            problem = read_face(i);
        if (!problem && next_fields())
            problem = fmt::format("{} follows the last of {} faces, expected the end of the file",
                                  shown(fields_.front()), faces_);
        if (problem)
            return tl::unexpected(at_line(name_, lines_.number(), *problem));
        return std::move(mesh_);
    }

  private:
    /// Fields of the next line that has any, comments taken off; false at the end of the file.
    bool next_fields() {
        while (const auto line = lines_.next()) {
            split_fields(line->substr(0, line->find('#')), fields_);
            if (!fields_.empty())
                return true;
        }
        return false;
    }

    Problem read_header() {
        if (!next_fields() || !fields_.front().ends_with("OFF"))
            return fmt::format("{}, expected OFF", fields_.empty() ? "nothing" : shown(fields_[0]));
        const auto prefix = fields_.front().substr(0, fields_.front().size() - 3);
        if (prefix.find_first_not_of("STCN") != prefix.npos)
            return fmt::format("{} is not read here, expected OFF in three dimensions",
                               shown(fields_.front()));
        has_more_per_vertex_ = !prefix.empty();
        if (fields_.size() > 1 && fields_[1] == "BINARY")
            return std::string("binary OFF is not read here; save the model as text, or as PLY");
        fields_.erase(fields_.begin());
        if (fields_.empty() && !next_fields())
            return std::string("the file ends before the counts of vertices, faces and edges");
        return read_counts();
    }

    Problem read_counts() {
        std::optional<std::size_t> counts[2];
        for (std::size_t k = 0; k < 2 && k < fields_.size(); ++k)
            counts[k] = parse_count(fields_[k]);
        if (!counts[0] || !counts[1] || fields_.size() > 3)
            return fmt::format("{} where the counts should be, expected three whole numbers: "
                               "vertices, faces, edges",
                               shown(fields_.front()));
        vertices_ = *counts[0];
        faces_ = *counts[1];
        if (faces_ == 0)
            return std::string("no faces; points alone have no thickness");
        const auto bytes = lines_.rest().size() + 1; // the last line may lack its ending
        if (auto problem = check_count("vertices", vertices_, sizeof "0 0 0", bytes))
            return problem;
        if (auto problem = check_count("faces", faces_, sizeof "3 0 1 2", bytes))
            return problem;
        mesh_.positions.reserve(vertices_);
        mesh_.triangles.reserve(faces_);
        return std::nullopt;
    }

    Problem read_vertex(std::size_t i) {
        if (!next_fields())
            return fmt::format("the file ends after {} of {} vertices", i, vertices_);
        if (fields_.size() < 3 || (fields_.size() > 3 && !has_more_per_vertex_))
            return fmt::format("vertex {} has {} fields, expected x y z", i, fields_.size());
        glm::dvec3 position;
        for (int axis = 0; axis < 3; ++axis) {
            const auto field = fields_[static_cast<std::size_t>(axis)];
            const auto value = parse_real(field);
            if (!value)
                return fmt::format("vertex {} has {}, expected a number", i, shown(field));
            position[axis] = *value;
        }
        return append_vertex(mesh_, position);
    }

    Problem read_face(std::size_t i) {
        if (!next_fields())
            return fmt::format("the file ends after {} of {} faces", i, faces_);
        const auto corners = parse_count(fields_.front());
        if (!corners || *corners > fields_.size() - 1) // what follows the corners is a colour
            return fmt::format("face {} says it has {} corners and {} fields follow", i,
                               shown(fields_.front()), fields_.size() - 1);
        corners_.clear();
        for (std::size_t k = 1; k <= *corners; ++k) {
            const auto corner = parse_count(fields_[k]);
            if (!corner)
                return fmt::format("face {} has {}, expected the index of a vertex", i,
                                   shown(fields_[k]));
            corners_.push_back(static_cast<double>(*corner));
        }
        return append_polygon(mesh_, corners_, vertices_);
    }

    Lines lines_;
    std::string_view name_;
    bool has_more_per_vertex_ = false;
    std::size_t vertices_ = 0, faces_ = 0;
    std::vector<std::string_view> fields_;
    std::vector<double> corners_;
    Mesh mesh_;
};

} // namespace

Expected<Mesh> read_off(std::string_view text, std::string_view name) {
    return OffReader(text, name).read();
}

std::string off_text(const Mesh& mesh) {
    auto text = fmt::format("OFF\n{} {} 0\n", mesh.positions.size(), mesh.triangles.size());
    for (const auto& p : mesh.positions)
        text += fmt::format("{} {} {}\n", p.x, p.y, p.z);
    for (const auto& [a, b, c] : mesh.triangles)
        text += fmt::format("3 {} {} {}\n", a, b, c);
    return text;
}

} // namespace renderer::geometry
