#include "renderer/geometry/bodies.h"
#include "renderer/thickness/cache.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

namespace {

using namespace renderer::thickness;
using renderer::geometry::Mesh;
namespace fs = std::filesystem;

/// A folder that goes with the test.
class Cache : public testing::Test {
  protected:
    Cache() {
        std::string name = (fs::temp_directory_path() / "pairlight-cache-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
        field_ = compute_thickness_field(mesh_, options_).value();
    }

    ~Cache() override { fs::remove_all(folder_); }

    fs::path file() const { return folder_ / "ball.thickness"; }

    std::string bytes() const {
        std::ifstream stream(file(), std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    void replace(std::string_view bytes) const {
        std::ofstream(file(), std::ios::binary | std::ios::trunc) << bytes;
    }

    void replace_byte(std::size_t position, char byte) const {
        std::fstream stream(file(), std::ios::binary | std::ios::in | std::ios::out);
        stream.seekp(static_cast<std::streamoff>(position));
        stream.put(byte);
    }

    void write() const { ASSERT_TRUE(write_field(file(), mesh_hash(mesh_), field_)); }

    auto read(const FieldOptions& options) const {
        return read_field(file(), mesh_hash(mesh_), options);
    }

    /// Neither a field nor a word about damage: there is nothing to use.
    void expect_of_no_use(const FieldOptions& options) const {
        const auto found = read(options);
        ASSERT_TRUE(found) << found.error();
        EXPECT_FALSE(*found);
    }

    fs::path folder_;
    Mesh mesh_ = renderer::geometry::sphere(1, 0);
    FieldOptions options_{.bands = 2, .directions = 64, .rotation_seed = 9};
    ThicknessField field_;
};

template <class T>
void expect_same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(T)), 0);
}

TEST_F(Cache, ReturnsEveryBit) {
    field_.coefficients[3] = -0.0f; // equal to 0, and yet not the same
    write();
    const auto found = read(options_);
    ASSERT_TRUE(found) << found.error();
    ASSERT_TRUE(*found);
    const ThicknessField& back = **found;
    EXPECT_EQ(back.bands, 2);
    EXPECT_EQ(back.options, options_);
    expect_same_bits(back.coefficients, field_.coefficients);
    expect_same_bits(back.energy, field_.energy);
    EXPECT_EQ(back.d_n, field_.d_n);
    EXPECT_EQ(back.percentiles, field_.percentiles);
    EXPECT_EQ(back.percentiles.size(), 6u);
    EXPECT_EQ(back.bounds.centre, field_.bounds.centre);
    EXPECT_EQ(back.bounds.radius, field_.bounds.radius);
    EXPECT_EQ(back.statistics.rays, field_.statistics.rays);
    EXPECT_EQ(back.statistics.retried, field_.statistics.retried);
    EXPECT_EQ(back.statistics.fallbacks, field_.statistics.fallbacks);
    EXPECT_EQ(back.normal_bins, field_.normal_bins);
}

TEST_F(Cache, WithoutAFileHasNothing) {
    expect_of_no_use(options_);
}

TEST_F(Cache, ServesFewerBandsThanItHas) {
    write();
    FieldOptions fewer = options_;
    fewer.bands = 1;
    const auto found = read(fewer);
    ASSERT_TRUE(found && *found);
    EXPECT_EQ((*found)->bands, 2); // as it is: the caller takes what it needs
}

TEST_F(Cache, IsOfNoUseForOtherOptions) {
    write();
    for (const auto change :
         {+[](FieldOptions& o) { o.bands = 4; }, +[](FieldOptions& o) { o.directions = 65; },
          +[](FieldOptions& o) { o.rotation_seed = 10; },
          +[](FieldOptions& o) { o.kind = Kind::Span; }}) {
        FieldOptions other = options_;
        change(other);
        expect_of_no_use(other);
    }
}

TEST_F(Cache, IsOfNoUseForAnotherMesh) {
    write();
    std::vector<Mesh> others(4, mesh_);
    others[0].positions[5].y = std::nextafter(others[0].positions[5].y, 2.0); // one bit
    std::swap(others[1].triangles[0], others[1].triangles[1]);
    std::swap(others[2].triangles[0][0], others[2].triangles[0][1]);
    others[3].positions.push_back({0, 0, 0});
    for (const auto& other : others) {
        EXPECT_NE(mesh_hash(other), mesh_hash(mesh_));
        const auto found = read_field(file(), mesh_hash(other), options_);
        ASSERT_TRUE(found) << found.error();
        EXPECT_FALSE(*found);
    }
}

TEST_F(Cache, OfAnotherVersionOrByteOrderIsOfNoUse) {
    write();
    const std::string right = bytes();
    std::string other = right;
    other[12] = 77; // the version, little or big end
    replace(other);
    expect_of_no_use(options_);
    other = right;
    std::reverse(other.begin() + 8, other.begin() + 12);
    replace(other);
    expect_of_no_use(options_);
}

TEST_F(Cache, FindsATruncationAtEveryByte) {
    write();
    const std::string whole = bytes();
    ASSERT_GT(whole.size(), 1000u);
    for (std::size_t length = whole.size(); length-- > 0;) {
        fs::resize_file(file(), length);
        const auto found = read(options_);
        ASSERT_FALSE(found) << length;
        ASSERT_THAT(found.error(), testing::AllOf(testing::StartsWith(file().string()),
                                                  testing::HasSubstr("damaged")));
    }
    replace(whole + 'x');
    EXPECT_FALSE(read(options_));
}

TEST_F(Cache, FindsEveryFlippedByteAndEveryBitOfItsHeader) {
    write();
    const std::string whole = bytes();
    for (std::size_t i = 0; i < whole.size(); ++i)
        for (int bit = 0; bit < 8; ++bit) {
            if (i >= 64 && bit != static_cast<int>(i % 8))
                continue; // all bits of every byte are the checksum's own test
            replace_byte(i, static_cast<char>(whole[i] ^ (1 << bit)));
            const auto found = read(options_);
            ASSERT_TRUE(!found || !*found) << "bit " << bit << " of byte " << i;
            replace_byte(i, whole[i]);
        }
    EXPECT_TRUE(read(options_).value()); // whole again
    replace("not a field at all, though long enough to have a header");
    EXPECT_THAT(read(options_).error(), testing::HasSubstr("is not a thickness field"));
}

// Two programs that trace the same model at once: whoever comes last, the file is whole, and
// nothing else is left in the folder.
TEST_F(Cache, IsWholeWhoeverElseWrites) {
    ThicknessField other = field_;
    for (auto& c : other.coefficients)
        c *= 2;
    const auto write_often = [&](const ThicknessField& field) {
        for (int i = 0; i < 30; ++i)
            EXPECT_TRUE(write_field(file(), mesh_hash(mesh_), field));
    };
    write();
    {
        const std::jthread first([&] { write_often(field_); }), second([&] { write_often(other); });
        for (int i = 0; i < 100; ++i) {
            const auto found = read(options_);
            ASSERT_TRUE(found) << found.error();
            ASSERT_TRUE(*found);
            EXPECT_TRUE((*found)->coefficients == field_.coefficients ||
                        (*found)->coefficients == other.coefficients);
        }
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(Cache, SaysWhyItCannotBeWritten) {
    const fs::path nowhere = folder_ / "no such folder" / "ball.thickness";
    const auto written = write_field(nowhere, 1, field_);
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error(), testing::AllOf(testing::StartsWith(nowhere.string()),
                                                testing::HasSubstr("cannot be written")));
    // a folder has the name already: the new file does not take its place, and does not stay
    fs::create_directory(file());
    EXPECT_FALSE(write_field(file(), 1, field_));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
    EXPECT_FALSE(read(options_)); // nor can a folder be read
}

} // namespace
