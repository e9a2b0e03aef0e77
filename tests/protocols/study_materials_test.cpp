// Materials that a study defines itself.
#include "tests/protocols/study_texts.h"

namespace {

using namespace study_texts;

/// `minimal`, whose scene is made of the material these lines define from line 21 on.
std::string with_material(const std::string& lines) {
    return changed("\"marble\"", "\"jade\"") + "[[material]]\nid = \"jade\"\n" + lines;
}

TEST(StudyFile, HasMaterialsOfItsOwn) {
    const auto study = parsed(example());
    const auto* jade = own_material(study, "jade");
    ASSERT_NE(jade, nullptr);
    const auto& medium = std::get<Coefficients>(jade->medium);
    EXPECT_EQ(medium.sigma_a, (std::array<double, 3>{0.006, 0.003, 0.005}));
    EXPECT_EQ(medium.sigma_s_reduced, (std::array<double, 3>{0.8, 1.0, 0.9}));
    EXPECT_EQ(medium.index, 1.6);
    const auto* wax = own_material(study, "wax");
    ASSERT_NE(wax, nullptr);
    const auto& colour = std::get<Colour>(wax->medium);
    EXPECT_EQ(colour.reflectance, (std::array<double, 3>{0.85, 0.7, 0.45}));
    EXPECT_EQ(colour.mean_free_path_mm, (std::array<double, 3>{4, 2, 1}));
    EXPECT_EQ(own_material(study, "skin1"), nullptr); // measured
}

TEST(StudyFile, ReducesTheScatteringOfAMaterialByItsAnisotropy) {
    const auto study = parsed(with_material("sigma_a = 0.01\nsigma_s = [10, 8, 6]\ng = 0.75\n"));
    const auto& medium = std::get<Coefficients>(study.materials.at(0).medium);
    EXPECT_EQ(medium.sigma_s_reduced, (std::array<double, 3>{2.5, 2, 1.5}));
    EXPECT_EQ(medium.sigma_a, (std::array<double, 3>{0.01, 0.01, 0.01})); // one number for all
    EXPECT_EQ(medium.index, 1.3);
}

TEST(StudyFile, WithAMaterialThatIsHalfDefinedIsToldTheOtherHalf) {
    EXPECT_EQ(complaint(with_material("")),
              "22: [[material]] 'jade' has neither 'sigma_a' nor 'colour', expected its "
              "coefficients or its colour");
    EXPECT_EQ(complaint(with_material("sigma_a = 1\n")),
              "21: [[material]] has no 'sigma_s_reduced', expected three numbers [r, g, b] or one "
              "for all, each from 0 to 1000000");
    EXPECT_EQ(complaint(with_material("sigma_a = 1\nsigma_s = 2\n")),
              "24: 'sigma_s' without 'g', expected the mean cosine of scattering beside it, or "
              "'sigma_s_reduced', which is (1 - g) sigma_s");
    EXPECT_EQ(complaint(with_material("sigma_a = 1\nsigma_s_reduced = 2\ng = 0.5\n")),
              "25: 'g' without 'sigma_s', expected both, or 'sigma_s_reduced' alone, which is "
              "(1 - g) sigma_s");
    EXPECT_THAT(complaint(with_material("colour = 0.5\n")),
                testing::StartsWith("21: [[material]] has no 'mean_free_path_mm', expected"));
}

TEST(StudyFile, WithAMaterialDefinedTwiceOverIsRefused) {
    EXPECT_EQ(complaint(with_material("sigma_a = 1\nsigma_s = 2\ng = 0.5\nsigma_s_reduced = 1\n")),
              "26: a material with both 'sigma_s' and 'sigma_s_reduced', expected one");
    EXPECT_EQ(complaint(with_material("colour = 0.5\nmean_free_path_mm = 1\nindex = 1.4\n")),
              "25: a material with both 'colour' and 'index', expected one: coefficients follow "
              "from the colour");
    EXPECT_EQ(complaint(with_material("sigma_a = 1\nsigma_s_reduced = 1\nmean_free_path_mm = 1\n")),
              "25: 'mean_free_path_mm' without 'colour', expected it only there: coefficients say "
              "how far light spreads");
    const std::string jade = "colour = 0.5\nmean_free_path_mm = 1\n";
    EXPECT_EQ(complaint(with_material(jade + "[[material]]\nid = \"jade\"\n" + jade)),
              "25: id 'jade' is already that of the material at line 21, expected a name of its "
              "own");
    EXPECT_EQ(complaint(minimal + "[[material]]\nid = \"marble\"\n" + jade),
              "22: id in [[material]] is \"marble\", expected another name: a measured material "
              "is called that");
}

TEST(StudyFile, WithAnImpossibleMediumIsToldTheRange) {
    const std::string range = "expected three numbers [r, g, b] or one for all, each from ";
    EXPECT_EQ(complaint(with_material("sigma_a = [1, -1, 1]\nsigma_s_reduced = 1\n")),
              "23: sigma_a in [[material]] is [1, -1, 1], " + range + "0 to 1000000");
    for (const std::string bad : {"[1, 1]", "[1, 1, nan]", "nan", "\"red\"", "true", "inf"})
        EXPECT_THAT(complaint(with_material("sigma_a = 1\nsigma_s_reduced = " + bad + "\n")),
                    testing::AllOf(testing::StartsWith("24: sigma_s_reduced in [[material]] is "),
                                   testing::HasSubstr(range)))
            << bad;
    EXPECT_EQ(complaint(with_material("colour = [0.5, 1.1, 0.5]\nmean_free_path_mm = 1\n")),
              "23: colour in [[material]] is [0.5, 1.1, 0.5], " + range + "0 to 1");
    EXPECT_THAT(complaint(with_material("colour = 0.5\nmean_free_path_mm = 0\n")),
                testing::StartsWith("24: mean_free_path_mm in [[material]] is 0, expected"));
    EXPECT_THAT(
        complaint(with_material("sigma_a = 1\nsigma_s = 1\ng = 1\n")),
        testing::StartsWith("25: g in [[material]] is 1, expected a number from -0.999 to"));
    EXPECT_THAT(
        complaint(with_material("sigma_a = 1\nsigma_s_reduced = 1\nindex = 0.9\n")),
        testing::StartsWith("25: index in [[material]] is 0.9, expected a number from 1 to"));
    EXPECT_EQ(complaint(with_material("sigma_a = [0, 1, 1]\nsigma_s_reduced = [0, 1, 1]\n")),
              "23: neither absorption nor scattering in a colour channel, expected a medium that "
              "light meets");
}

TEST(StudyFile, WithTheNameOfItsOwnMaterialMisspeltIsToldIt) {
    EXPECT_THAT(complaint(changed("\"marble\"", "\"jabe\"") +
                          "[[material]]\nid = \"jade\"\ncolour = 0.5\nmean_free_path_mm = 1\n"),
                testing::HasSubstr("whole-milk, jade (did you mean 'jade'?)"));
}

} // namespace
