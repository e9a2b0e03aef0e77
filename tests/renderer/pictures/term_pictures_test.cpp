// Fitting, with pictures that a method has drawn.
#include "renderer/geometry/bodies.h"
#include "renderer/methods/catalogue.h"
#include "renderer/pictures/fitting.h"
#include "tests/renderer/methods/known_worlds.h"

#include <cmath>
#include <utility>

namespace {

using namespace known_worlds;
using pictures::Term;

constexpr int size = 48;

class TermPictures : public MethodTest {
  protected:
    /// Fits the method to pictures that it drew itself, under three lights.
    pictures::ReflectanceFit::Result fit_to_itself(std::string_view name,
                                                   const methods::Dials& dials) {
        const auto mesh = geometry::torus(1, 0.4, 48, 24);
        auto scene = scene_of(mesh, {0, 0, 1}, {.elevation_degrees = 35});
        auto method = methods::prepare_method(
            name, dials,
            {.mesh = mesh,
             .surface = *shading::Surface::upload(mesh),
             .material = scene.material,
             .placement = scene.placement,
             .field =
                 [&](const thickness::FieldOptions& options) {
                     return thickness::compute_thickness_field(mesh, options)
                         .map([](thickness::ThicknessField field) {
                             return std::make_shared<const thickness::ThicknessField>(
                                 std::move(field));
                         });
                 },
             .progress = {}});
        EXPECT_TRUE(method) << method.error();
        pictures::ReflectanceFit fit;
        for (const auto to_light :
             {glm::dvec3(0, 0.3, 1), glm::dvec3(-1, 0.2, 0.1), glm::dvec3(0, 0.3, -1)}) {
            scene.lights = {{DirectionalLight{glm::normalize(to_light)}, {0.9F, 1.0F, 1.1F}}};
            pictures::LightPictures pictures;
            auto target = pictures::render_picture(**method, scene, size, size, 1);
            EXPECT_TRUE(target) << target.error();
            pictures.target = std::move(target).value();
            auto terms = pictures::term_pictures(**method, scene, size, size, 1);
            EXPECT_TRUE(terms) << terms.error();
            pictures.terms = std::move(terms).value();
            const auto added = fit.add_training_light(pictures);
            EXPECT_TRUE(added) << added.error();
        }
        return fit.best();
    }
};

void expect_near(LinearRgb found, LinearRgb expected) {
    EXPECT_LE(std::abs(found.r - expected.r), 1e-5F);
    EXPECT_LE(std::abs(found.g - expected.g), 1e-5F);
    EXPECT_LE(std::abs(found.b - expected.b), 1e-5F);
}

TEST_F(TermPictures, GiveBackTheCoefficientsOfMethodsThatHaveAllTerms) {
    const auto truth = colourful_material().reflectance;
    const std::vector<std::pair<std::string, methods::Dials>> methods_with_all_terms{
        {"green", {}}, {"shss", {{"directions", std::int64_t{64}}}}};
    for (const auto& [name, dials] : methods_with_all_terms) {
        const auto best = fit_to_itself(name, dials);
        expect_near(best.reflectance.ambient, truth.ambient);
        expect_near(best.reflectance.diffuse, truth.diffuse);
        expect_near(best.reflectance.specular, truth.specular);
        expect_near(best.reflectance.scatter, truth.scatter);
        EXPECT_THAT(best.absent, testing::IsEmpty()) << name;
        EXPECT_LE(best.training_error.mean(), 1e-12) << name;
    }
}

TEST_F(TermPictures, NameTheTermThatPatroDoesNotHave) {
    const auto truth = colourful_material().reflectance;
    for (const std::string variant : {"normals", "harmonics"}) {
        const auto best = fit_to_itself("patro", {{"variant", variant}});
        expect_near(best.reflectance.ambient, truth.ambient);
        expect_near(best.reflectance.diffuse, truth.diffuse);
        expect_near(best.reflectance.specular, truth.specular);
        EXPECT_EQ(best.reflectance.scatter, (LinearRgb{0, 0, 0}));
        EXPECT_THAT(best.absent, testing::ElementsAre(Term::Scatter));
    }
}

} // namespace
