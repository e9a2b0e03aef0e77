// Reads meshes from files: PLY, OFF and OBJ.
#include "renderer/geometry/mesh_files.h"

#include "renderer/geometry/obj_file.h"
#include "renderer/geometry/off_file.h"
#include "renderer/geometry/ply_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace renderer::geometry {

namespace {

Expected<std::string> read_bytes(const std::filesystem::path& file) {
    std::error_code error;
    const auto size = std::filesystem::file_size(file, error); // fails on a folder, too
    if (error)
        return tl::unexpected(fmt::format("{}: {}", file.string(), error.message()));
    std::ifstream stream(file, std::ios::binary);
    std::string bytes(size, '\0');
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(size)))
        return tl::unexpected(
            fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
    return bytes;
}

} // namespace

Expected<Mesh> read_mesh(const std::filesystem::path& file) {
    auto ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
        return static_cast<char>(c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c);
    });
    const auto reader = ending == ".ply"   ? read_ply
                        : ending == ".off" ? read_off
                        : ending == ".obj" ? read_obj
                                           : nullptr;
    if (reader == nullptr)
        return tl::unexpected(
            fmt::format("{}: a model file ends in .ply, .off or .obj", file.string()));
    return read_bytes(file).and_then([&](const std::string& bytes) -> Expected<Mesh> {
        if (bytes.empty())
            return tl::unexpected(
                fmt::format("{}: the file is empty, expected a model", file.string()));
        return reader(bytes, file.string());
    });
}

} // namespace renderer::geometry
