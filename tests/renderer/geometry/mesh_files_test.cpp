// PLY, OFF and OBJ: what is read, and what is said about what cannot be.
#include "renderer/geometry/mesh_files.h"
#include "renderer/geometry/obj_file.h"
#include "renderer/geometry/off_file.h"
#include "renderer/geometry/ply_file.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>

namespace {

using namespace renderer;
using namespace renderer::geometry;
using testing::HasSubstr;

/// A pyramid over a square: one face is not a triangle.
const std::vector<glm::dvec3> pyramid_positions{
    {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0.75}};
const std::vector<std::vector<std::uint32_t>> pyramid_faces{
    {3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
const std::vector<Triangle> pyramid_triangles{{3, 2, 1}, {3, 1, 0}, {0, 1, 4},
                                              {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

std::string pyramid_off() {
    return "OFF\n5 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 0.75\n"
           "4 3 2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";
}

std::string pyramid_obj() {
    return "# a pyramid\no base\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 0.75\n"
           "f 4 3 2 1\ng sides\nf 1 2 5\nf 2/1 3/2 5/3\nf 3//1 4//1 5//1\nf -2/7/1 -5/7/1 -1/7/1\n";
}

std::string pyramid_ascii_ply() {
    return "ply\nformat ascii 1.0\ncomment a pyramid\nelement vertex 5\nproperty float x\n"
           "property float y\nproperty float z\nelement face 5\n"
           "property list uchar int vertex_indices\nend_header\n"
           "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 0.75\n"
           "4 3 2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";
}

template <class Number>
void append(std::string& bytes, Number value, bool big_endian) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (big_endian)
        std::reverse(raw, raw + sizeof value);
    bytes.append(raw, sizeof value);
}

/// Doubles in the order z, x, y behind a colour, an element of another kind in between, faces with
/// a quality before the list: everything that may be passed over is there.
std::string pyramid_binary_ply(bool big_endian) {
    std::string bytes = "ply\nformat ";
    bytes += big_endian ? "binary_big_endian" : "binary_little_endian";
    bytes += " 1.0\nobj_info made by a test\nelement vertex 5\nproperty uchar red\n"
             "property double z\nproperty double x\nproperty float64 y\n"
             "element edge 2\nproperty list ushort int16 ends\nproperty uint8 kind\n"
             "element face 5\nproperty float quality\n"
             "property list uint8 uint32 vertex_index\nend_header\n";
    for (const auto& p : pyramid_positions) {
        append(bytes, std::uint8_t{200}, big_endian);
        for (const double value : {p.z, p.x, p.y})
            append(bytes, value, big_endian);
    }
    for (int edge = 0; edge < 2; ++edge) {
        append(bytes, std::uint16_t{2}, big_endian);
        append(bytes, std::int16_t{-1}, big_endian);
        append(bytes, std::int16_t{4}, big_endian);
        append(bytes, std::uint8_t{7}, big_endian);
    }
    for (const auto& face : pyramid_faces) {
        append(bytes, 0.5f, big_endian);
        append(bytes, static_cast<std::uint8_t>(face.size()), big_endian);
        for (const auto corner : face)
            append(bytes, corner, big_endian);
    }
    return bytes;
}

using Reader = Expected<Mesh> (*)(std::string_view, std::string_view);

struct Sample {
    std::string name;
    Reader read;
    std::string bytes;
};

std::vector<Sample> samples() {
    return {{"a.off", read_off, pyramid_off()},
            {"a.obj", read_obj, pyramid_obj()},
            {"ascii.ply", read_ply, pyramid_ascii_ply()},
            {"little.ply", read_ply, pyramid_binary_ply(false)},
            {"big.ply", read_ply, pyramid_binary_ply(true)}};
}

std::string with(std::string text, std::string_view old, std::string_view replacement) {
    const auto at = text.find(old);
    EXPECT_NE(at, text.npos) << old;
    return text.replace(at, old.size(), replacement);
}

std::string error_of(const Expected<Mesh>& result) {
    return result ? "no error" : result.error();
}

TEST(MeshFiles, OfEveryKindGiveTheSameMesh) {
    for (const auto& sample : samples()) {
        const auto mesh = sample.read(sample.bytes, sample.name);
        ASSERT_TRUE(mesh) << mesh.error();
        ASSERT_EQ(mesh->positions.size(), pyramid_positions.size()) << sample.name;
        // tinyobjloader adds up digits and may miss the last bit; our own readers may not.
        const double tolerance = sample.name == "a.obj" ? 1e-15 : 0;
        for (std::size_t v = 0; v < pyramid_positions.size(); ++v)
            EXPECT_LE(glm::distance(mesh->positions[v], pyramid_positions[v]), tolerance);
        EXPECT_EQ(mesh->triangles, pyramid_triangles) << sample.name;
    }
}

TEST(MeshFiles, OfTextMayEndTheirLinesInEveryWay) {
    for (const auto& sample : samples()) {
        if (sample.bytes.find("binary") != std::string::npos)
            continue;
        for (const auto* ending : {"\r\n", "\r"}) {
            std::string bytes;
            for (const char c : sample.bytes)
                bytes += c == '\n' ? std::string(ending) : std::string(1, c);
            const auto mesh = sample.read(bytes, sample.name);
            ASSERT_TRUE(mesh) << mesh.error();
            EXPECT_EQ(mesh->triangles, pyramid_triangles) << sample.name;
        }
    }
}

/// Whatever the bytes: a mesh that can be walked, or one line that begins with the file's name.
void expect_mesh_or_error(const Sample& sample, const std::string& bytes) {
    const auto result = sample.read(bytes, sample.name);
    if (!result) {
        EXPECT_TRUE(result.error().starts_with(sample.name + ":")) << result.error();
        EXPECT_EQ(result.error().find('\n'), std::string::npos) << result.error();
        return;
    }
    EXPECT_FALSE(result->triangles.empty());
    for (const auto& triangle : result->triangles)
        for (const auto corner : triangle)
            EXPECT_LT(corner, result->positions.size());
    for (const auto& p : result->positions)
        EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
}

TEST(MeshFiles, SurviveTruncationAtEveryByte) {
    for (const auto& sample : samples())
        for (std::size_t length = 0; length < sample.bytes.size(); ++length) {
            SCOPED_TRACE(sample.name + " cut to " + std::to_string(length));
            expect_mesh_or_error(sample, sample.bytes.substr(0, length));
        }
}

TEST(MeshFiles, WithCountsNoticeEveryMissingFace) {
    for (const auto& sample : samples()) {
        if (sample.name == "a.obj") // says nowhere how many faces there are
            continue;
        for (std::size_t length = 0; length + 1 < sample.bytes.size(); ++length)
            if (const auto mesh = sample.read(sample.bytes.substr(0, length), sample.name)) {
                EXPECT_EQ(mesh->triangles.size(), pyramid_triangles.size());
            }
    }
}

TEST(MeshFiles, SurviveEveryFlippedBitAndManyWrongBytes) {
    for (const auto& sample : samples())
        for (std::size_t at = 0; at < sample.bytes.size(); ++at) {
            SCOPED_TRACE(sample.name + " changed at " + std::to_string(at));
            for (int bit = 0; bit < 8; ++bit) {
                auto bytes = sample.bytes;
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << bit));
                expect_mesh_or_error(sample, bytes);
            }
            for (const char c : {'\0', '\n', '\r', ' ', '-', '9', '/', '\xff'}) {
                auto bytes = sample.bytes;
                bytes[at] = c;
                expect_mesh_or_error(sample, bytes);
                bytes.insert(at, 1, c);
                expect_mesh_or_error(sample, bytes);
            }
        }
}

TEST(OffFile, ReadsCountsOnTheFirstLineAndComments) {
    auto text = with(pyramid_off(), "OFF\n5 5 0\n", "# scanned\nOFF 5 5 # no edges\n\n");
    text = with(text, "1 1 0\n", "1 1 0 # a corner\n\n#3\n");
    const auto mesh = read_off(text, "a.off");
    ASSERT_TRUE(mesh) << mesh.error();
    EXPECT_EQ(mesh->triangles, pyramid_triangles);
}

TEST(OffFile, PassesOverNormalsAndColours) {
    auto text = with(pyramid_off(), "OFF", "CNOFF");
    text = with(text, "0.5 0.5 0.75", "0.5 0.5 0.75 0 0 1 255 0 0 255");
    text = with(text, "3 0 1 4\n", "3 0 1 4 0.5 0.5 0.5\n");
    const auto mesh = read_off(text, "a.off");
    ASSERT_TRUE(mesh) << mesh.error();
    EXPECT_EQ(mesh->positions, pyramid_positions);
    EXPECT_EQ(mesh->triangles, pyramid_triangles);
}

TEST(OffFile, SaysWhatIsWrongAndWhere) {
    const auto good = pyramid_off();
    auto error = [&](std::string_view old, std::string_view replacement) {
        return error_of(read_off(with(good, old, replacement), "a.off"));
    };
    EXPECT_EQ(error("OFF", "PLY"), "a.off:1: 'PLY', expected OFF");
    EXPECT_EQ(error_of(read_off("", "a.off")), "a.off:1: nothing, expected OFF");
    EXPECT_THAT(error("OFF", "4OFF"), HasSubstr("a.off:1: '4OFF' is not read here"));
    EXPECT_THAT(error("OFF", "OFF BINARY"), HasSubstr("binary OFF is not read here; save"));
    EXPECT_THAT(error("5 5 0", "5 x 0"), HasSubstr("a.off:2: '5' where the counts should be"));
    EXPECT_THAT(error("5 5 0", "5 0 0"), HasSubstr("a.off:2: no faces"));
    EXPECT_THAT(error("5 5 0", "5000000000 5 0"), HasSubstr("5000000000 vertices are declared"));
    EXPECT_THAT(error("5 5 0", "5 18446744073709551615 0"), HasSubstr("faces are declared, but"));
    EXPECT_EQ(error("1 1 0", "1 one 0"), "a.off:5: vertex 2 has 'one', expected a number");
    EXPECT_EQ(error("1 1 0", "1 nan 0"),
              "a.off:5: vertex 2 has the y coordinate nan, expected a finite number");
    EXPECT_EQ(error("1 1 0", "1 1"), "a.off:5: vertex 2 has 2 fields, expected x y z");
    EXPECT_EQ(
        error("3 1 2 4", "3 1 2 5"),
        "a.off:10: a face with vertex 5, expected 0 or above and below 5, the number of vertices");
    EXPECT_THAT(error("3 1 2 4", "4 1 2 4"), HasSubstr("a.off:10: face 2 says it has '4' corners"));
    EXPECT_EQ(error("3 1 2 4", "2 1 2"), "a.off:10: a face with 2 corners, expected at least 3");
    EXPECT_THAT(error("3 3 0 4\n", ""), HasSubstr("the file ends after 4 of 5 faces"));
    EXPECT_THAT(error("3 3 0 4\n", "3 3 0 4\n3 0 1 2\n"),
                HasSubstr("a.off:13: '3' follows the last"));
}

TEST(ObjFile, SaysWhatIsWrongAndWhere) {
    const auto good = pyramid_obj();
    auto error = [&](std::string_view old, std::string_view replacement) {
        return error_of(read_obj(with(good, old, replacement), "a.obj"));
    };
    EXPECT_EQ(error("v 1 1 0", "v 1 nan 0"),
              "a.obj:5: a vertex with 'nan', expected a finite number");
    EXPECT_EQ(error("v 1 1 0", "v 1 1"), "a.obj:5: a vertex with 2 coordinates, expected x y z");
    EXPECT_EQ(error("f 1 2 5", "f 1 2 6"),
              "a.obj:10: a face with vertex 6, expected 1 to 5, or -1 to -5 counted back");
    EXPECT_THAT(error("f 1 2 5", "f 1 2 0"), HasSubstr("a.obj:10: a face with vertex 0"));
    EXPECT_THAT(error("f 1 2 5", "f 1 2 -6"), HasSubstr("a.obj:10: a face with vertex -6"));
    EXPECT_THAT(error("f 1 2 5", "f 1 2 x"),
                HasSubstr("a.obj:10: a face with 'x', expected vertex"));
    EXPECT_THAT(error("f 1 2 5", "f 1 2 99999999999"), HasSubstr("a face with '99999999999'"));
    EXPECT_EQ(error("f 1 2 5", "f 1 2"), "a.obj:10: a face with 2 corners, expected at least 3");
    EXPECT_EQ(error("f 1 2 5", "f"), "a.obj:10: a face with 0 corners, expected at least 3");
    EXPECT_THAT(error_of(read_obj("v 0 0 0\n", "a.obj")), HasSubstr("a.obj: no faces"));
}

TEST(PlyFile, SaysWhatIsWrongInItsHeader) {
    const auto good = pyramid_ascii_ply();
    auto error = [&](std::string_view old, std::string_view replacement) {
        return error_of(read_ply(with(good, old, replacement), "a.ply"));
    };
    EXPECT_THAT(error("ply\n", "plx\n"), HasSubstr("a.ply:1: expected ply"));
    EXPECT_THAT(error("ascii 1.0", "ascii 2.0"), HasSubstr("a.ply:2: this format is not known"));
    EXPECT_THAT(error("format ascii 1.0\n", ""), HasSubstr("no format line"));
    EXPECT_THAT(error("vertex 5", "vertex five"), HasSubstr("a.ply:4: expected element"));
    EXPECT_THAT(error("float y", "real y"), HasSubstr("a.ply:6: expected property"));
    EXPECT_THAT(error("list uchar int", "list float int"), HasSubstr("a.ply:9: expected property"));
    EXPECT_THAT(error("property float y\n", ""),
                HasSubstr("declares no vertex property x, y or z"));
    EXPECT_THAT(error("element face 5\nproperty list uchar int vertex_indices\n", ""),
                HasSubstr("declares no faces"));
    EXPECT_THAT(error("vertex_indices", "strips"),
                HasSubstr("no face property list vertex_indices"));
    EXPECT_THAT(error("vertex 5", "vertex 5000000000"),
                HasSubstr("a.ply:10: 5000000000 elements 'vertex' are declared"));
    EXPECT_THAT(error_of(read_ply("ply\nformat ascii 1.0\n", "a.ply")),
                HasSubstr("a.ply:2: the file ends before the header does"));
}

TEST(PlyFile, SaysWhatIsWrongInItsText) {
    const auto good = pyramid_ascii_ply();
    auto error = [&](std::string_view old, std::string_view replacement) {
        return error_of(read_ply(with(good, old, replacement), "a.ply"));
    };
    EXPECT_THAT(error("1 1 0", "1 1"), HasSubstr("a.ply:13: the line ends after 2 values"));
    EXPECT_THAT(error("1 1 0", "1 1 0 7"), HasSubstr("a.ply:13: 4 values, expected 3"));
    EXPECT_THAT(error("1 1 0", "1 inf 0"),
                HasSubstr("a.ply:13: vertex 2 has the y coordinate inf"));
    EXPECT_THAT(error("3 0 1 4", "9 0 1 4"),
                HasSubstr("a.ply:17: a list of 9 values, but at most 3"));
    EXPECT_THAT(error("3 0 1 4", "3 0 1 4.5"), HasSubstr("a.ply:17: a face with vertex 4.5"));
    EXPECT_THAT(error("3 0 1 4", "3 0 1 -4"), HasSubstr("a.ply:17: a face with vertex -4"));
    EXPECT_THAT(error("3 3 0 4\n", ""), HasSubstr("a.ply:19: the file ends after 4 of 5"));
    EXPECT_THAT(error("3 3 0 4\n", "3 3 0 4\n0\n"), HasSubstr("a.ply:21: data after the last"));
}

TEST(PlyFile, SaysWhatIsWrongInItsBinaryData) {
    for (const bool big_endian : {false, true}) {
        const auto good = pyramid_binary_ply(big_endian);
        const auto last_corner = good.size() - (big_endian ? 1 : 4);
        auto wrong_index = good;
        wrong_index[last_corner] = 9;
        EXPECT_EQ(
            error_of(read_ply(wrong_index, "a.ply")),
            "a.ply: byte " + std::to_string(good.size()) +
                ": a face with vertex 9, expected 0 or above and below 5, the number of vertices");
        EXPECT_THAT(error_of(read_ply(good.substr(0, good.size() - 1), "a.ply")),
                    HasSubstr("the file ends in the middle of an element"));
        EXPECT_THAT(error_of(read_ply(good + '\0', "a.ply")),
                    HasSubstr("data after the last element"));
    }
}

TEST(ReadMesh, ChoosesTheReaderByTheEnding) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "pairlight_read_mesh";
    std::filesystem::create_directories(folder);
    for (const auto& sample : samples()) {
        std::ofstream(folder / sample.name, std::ios::binary) << sample.bytes;
        const auto mesh = read_mesh(folder / sample.name);
        ASSERT_TRUE(mesh) << mesh.error();
        EXPECT_EQ(mesh->triangles, pyramid_triangles);
    }
    std::ofstream(folder / "CAPITAL.OFF") << pyramid_off();
    EXPECT_TRUE(read_mesh(folder / "CAPITAL.OFF"));
    std::filesystem::remove_all(folder);
}

TEST(ReadMesh, SaysWhyAFileCannotBeRead) {
    EXPECT_EQ(error_of(read_mesh("nowhere/a.ply")), "nowhere/a.ply: No such file or directory");
    EXPECT_EQ(error_of(read_mesh("a.stl")), "a.stl: a model file ends in .ply, .off or .obj");
    const auto folder = std::filesystem::path(testing::TempDir()) / "pairlight_folder.off";
    std::filesystem::create_directories(folder);
    EXPECT_THAT(error_of(read_mesh(folder)), HasSubstr("pairlight_folder.off: Is a directory"));
    std::filesystem::remove(folder);
}

TEST(OffFile, IsWrittenWithEveryDigit) {
    const Mesh mesh{{{0.1, 1.0 / 3, -0.0}, {1e-300, 2e17, 3}, {4, 5, 6}}, {{0, 1, 2}, {2, 1, 0}}};
    const auto again = read_off(off_text(mesh), "a.off");
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(again->positions, mesh.positions);
    EXPECT_EQ(again->triangles, mesh.triangles);
}

} // namespace
