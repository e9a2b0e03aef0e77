// Where a model's name leads.
#include "renderer/geometry/mesh_repair.h"
#include "renderer/geometry/model_library.h"

#include <glm/geometric.hpp>

#include <fstream>

namespace {

using namespace renderer::geometry;
using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr const char* tetrahedron =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

class ModelLibrary : public testing::Test {
  protected:
    void SetUp() override {
        root_ = fs::path(testing::TempDir()) /
                (std::string("pairlight_models_") +
                 testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(root_);
        for (const auto* folder : {"study/mine", "first", "second"})
            fs::create_directories(root_ / folder);
        search_ = {root_ / "study", {root_ / "first", root_ / "missing", root_ / "second"}};
    }

    void TearDown() override { fs::remove_all(root_); }

    void put(const fs::path& file) { std::ofstream(root_ / file) << tetrahedron; }

    fs::path found(std::string_view name) {
        const auto model = find_model(name, search_);
        return model ? fs::relative(std::get<fs::path>(*model), root_) : fs::path(model.error());
    }

    fs::path root_;
    ModelSearch search_;
};

TEST_F(ModelLibrary, LooksThroughTheFoldersInTheirOrder) {
    put("second/horse.off");
    EXPECT_EQ(found("horse"), "second/horse.off");
    put("first/horse.obj");
    EXPECT_EQ(found("horse"), "first/horse.obj");
    put("first/horse.ply");
    EXPECT_EQ(found("horse"), "first/horse.ply");
}

TEST_F(ModelLibrary, TakesPathsFromTheStudyFolderOrFromTheRoot) {
    put("study/mine/statue.off");
    put("study/plain.off");
    EXPECT_EQ(found("mine/statue.off"), "study/mine/statue.off");
    EXPECT_EQ(found("plain.off"), "study/plain.off");
    EXPECT_EQ(found((root_ / "study/plain.off").string()), "study/plain.off");
}

TEST_F(ModelLibrary, SaysWhereItLookedAndHowToGetModels) {
    const auto missing = find_model("dragon", search_);
    ASSERT_FALSE(missing);
    EXPECT_EQ(
        missing.error(),
        "model 'dragon' is neither a body (sphere, shell, torus, slab, rounded-box) nor in " +
            (root_ / "first").string() + ", " + (root_ / "missing").string() + ", " +
            (root_ / "second").string() +
            " a file ending in .ply, .off or .obj; tools/fetch-models brings models, and a path "
            "to a file of your own will do");
    const auto missing_path = find_model("mine/dragon.ply", search_);
    ASSERT_FALSE(missing_path);
    EXPECT_EQ(missing_path.error(), "model 'mine/dragon.ply': there is no file " +
                                        (root_ / "study/mine/dragon.ply").string() +
                                        "; paths start at the study's folder");
    EXPECT_THAT(find_model("", {}).error(), HasSubstr("the search path, which is empty"));
}

TEST_F(ModelLibrary, GivesBodiesByNameWhateverTheFoldersHold) {
    put("first/sphere.off");
    ASSERT_EQ(body_names().size(), 5u);
    for (const auto name : body_names()) {
        const auto model = find_model(name, search_);
        ASSERT_TRUE(model) << model.error();
        EXPECT_TRUE(std::holds_alternative<Body>(*model)) << name;
        auto prepared = load_model(*model).and_then([&](Mesh mesh) { return prepare(mesh, name); });
        ASSERT_TRUE(prepared) << prepared.error();
        EXPECT_TRUE(describe(prepared->repairs).empty()) << name;
        const auto size = bounding_sphere(prepared->mesh);
        EXPECT_NEAR(size.radius, 1, 0.45) << name; // the slab's corners reach out to 1.42
        EXPECT_LE(glm::length(size.centre), 0.01) << name;
    }
}

TEST_F(ModelLibrary, LoadsTheFileItFound) {
    put("first/solid.off");
    const auto mesh = find_model("solid", search_).and_then(load_model);
    ASSERT_TRUE(mesh) << mesh.error();
    EXPECT_EQ(mesh->triangles.size(), 4u);
}

} // namespace
