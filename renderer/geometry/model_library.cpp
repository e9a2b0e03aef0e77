// Finds a model by its name: a body of our own, a file on the search path, or a path.
#include "renderer/geometry/model_library.h"

#include "renderer/contract.h"
#include "renderer/geometry/bodies.h"
#include "renderer/geometry/mesh_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace renderer::geometry {

namespace {

namespace fs = std::filesystem;

struct KnownBody {
    std::string_view name;
    Mesh (*make)();
};

// Fine enough that thickness is right to a thousandth: (edge length)^2 over 8 for a unit sphere.
constexpr std::array<KnownBody, 5> known_bodies{
    {{"sphere", [] { return sphere(1, 5); }},
     {"shell", [] { return shell(1, 0.5, 5); }},
     {"torus", [] { return torus(0.7, 0.3, 176, 76); }},
     {"slab", [] { return slab(2, 2, 0.2, 64); }},
     {"rounded-box", [] {
          return rounded_box({0.8, 0.5, 0.35}, 0.15, 64);
      }}}};

constexpr auto known_names = [] {
    std::array<std::string_view, known_bodies.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = known_bodies[i].name;
    return names;
}();

const KnownBody* find_body(std::string_view name) {
    const auto* found = std::find_if(known_bodies.begin(), known_bodies.end(),
                                     [&](const auto& body) { return body.name == name; });
    return found == known_bodies.end() ? nullptr : found;
}

bool is_path(std::string_view name) {
    return name.find('/') != name.npos ||
           std::any_of(mesh_file_endings.begin(), mesh_file_endings.end(),
                       [&](auto ending) { return name.ends_with(ending); });
}

bool is_file(const fs::path& path) {
    std::error_code ignored; // what cannot be looked at is not there
    return fs::is_regular_file(path, ignored);
}

std::string not_found(std::string_view name, const ModelSearch& search) {
    std::string folders;
    for (const auto& folder : search.folders)
        folders += fmt::format("{}{}", folders.empty() ? "" : ", ", folder.string());
    return fmt::format("model '{}' is neither a body ({}) nor {} ending in .ply, .off or .obj; "
                       "tools/fetch-models brings models, and a path to a file of your own will do",
                       name, fmt::join(known_names, ", "),
                       folders.empty() ? "on the search path, which is empty, a file"
                                       : fmt::format("in {} a file", folders));
}

} // namespace

std::span<const std::string_view> body_names() {
    return known_names;
}

Expected<Model> find_model(std::string_view name, const ModelSearch& search) {
    if (find_body(name) != nullptr)
        return Body{std::string(name)};
    if (is_path(name)) {
        const auto path = search.study_folder / name; // an absolute path stands alone
        if (is_file(path))
            return path;
        return tl::unexpected(
            fmt::format("model '{}': there is no file {}; paths start at the study's "
                        "folder",
                        name, path.string()));
    }
    if (!name.empty())
        for (const auto& folder : search.folders)
            for (const auto ending : mesh_file_endings)
                if (const auto path = folder / fmt::format("{}{}", name, ending); is_file(path))
                    return path;
    return tl::unexpected(not_found(name, search));
}

Expected<Mesh> load_model(const Model& model) {
    if (const auto* file = std::get_if<fs::path>(&model))
        return read_mesh(*file);
    const auto* body = find_body(std::get<Body>(model).name);
    EXPECTS(body != nullptr);
    return body->make();
}

} // namespace renderer::geometry
