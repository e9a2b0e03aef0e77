#include "experiment/stimuli/recipe.h"

namespace {

using namespace experiment::stimuli;

protocols::Study study() {
    protocols::Study study;
    study.materials = {
        {.id = {"jade"}, .medium = protocols::Coefficients{{0.1, 0.2, 0.3}, {1, 2, 3}, 1.6}},
        {.id = {"wax"}, .medium = protocols::Colour{{0.8, 0.7, 0.5}, {4, 2, 1}}}};
    study.scenes.resize(1);
    study.scenes[0].material = "jade";
    return study;
}

std::string recipe_of(const protocols::Study& study) {
    return recipe(study, study.scenes.at(0), {}, {}, "a renderer", 8);
}

TEST(Recipe, KnowsWhatAMaterialOfTheStudyIsMadeOf) {
    const auto original = recipe_of(study());
    for (const auto change :
         {&protocols::Coefficients::sigma_a, &protocols::Coefficients::sigma_s_reduced}) {
        auto changed = study();
        (std::get<protocols::Coefficients>(changed.materials[0].medium).*change)[1] += 1e-15;
        EXPECT_NE(recipe_of(changed), original);
    }
    auto denser = study();
    std::get<protocols::Coefficients>(denser.materials[0].medium).index = 1.3;
    EXPECT_NE(recipe_of(denser), original);
    auto of_wax = study();
    of_wax.scenes[0].material = "wax";
    const auto wax = recipe_of(of_wax);
    std::get<protocols::Colour>(of_wax.materials[1].medium).mean_free_path_mm[2] = 1.5;
    EXPECT_NE(recipe_of(of_wax), wax);
}

TEST(Recipe, DoesNotChangeWithAMaterialNobodyUses) {
    auto changed = study();
    std::get<protocols::Colour>(changed.materials[1].medium).reflectance[0] = 0.1;
    EXPECT_EQ(recipe_of(changed), recipe_of(study()));
}

TEST(Recipe, KnowsTheSizeOfTheModel) {
    auto larger = study();
    larger.scenes[0].diameter_mm = 101;
    EXPECT_NE(recipe_of(larger), recipe_of(study()));
    auto by_unit = study();
    by_unit.scenes[0].mm_per_unit = 100; // the same number means another size
    EXPECT_NE(recipe_of(by_unit), recipe_of(study()));
}

} // namespace
