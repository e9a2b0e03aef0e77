// Each method at its best: the coefficients k with which its pictures come nearest to others,
// usually the reference's.  docs/fair-parameters.md
#pragma once

#include "renderer/expected.h"
#include "renderer/imaging/linear_image.h"
#include "renderer/pictures/nonnegative_least_squares.h"
#include "renderer/scene.h"

#include <array>
#include <string_view>
#include <vector>

namespace renderer::methods {
class Method;
}

namespace renderer::pictures {

/// The four terms of the shading model, in the order of its sum.  [SHSS, eq. 3]
enum class Term { Ambient, Diffuse, Specular, Scatter };

inline constexpr std::array all_terms{Term::Ambient, Term::Diffuse, Term::Specular, Term::Scatter};

std::string_view name(Term term);

/// One light's pictures, of one size and view.
struct LightPictures {
    std::array<imaging::LinearImage, 4>
        terms;                   ///< each term alone with k = 1, in `all_terms`' order
    imaging::LinearImage target; ///< what they are to add up to
};

/// Mean over pixels of (x - y)^2 / (y^2 + 0.01), per channel: relMSE, y the target.
struct RelativeError {
    std::array<double, 3> rgb{};

    double mean() const { return (rgb[0] + rgb[1] + rgb[2]) / 3; }
};

/// For a fixed thickness a picture is linear in k, so the best k's are a linear least-squares
/// problem for each channel: over the pixels that both the method and the target cover wholly, of
/// all training lights, with the weight 1/(y^2 + 0.01).
class ReflectanceFit {
  public:
    /// Errors: pictures of different sizes, no common pixel, a pixel that is not finite.
    Expected<void> add_training_light(const LightPictures& pictures);

    /// `reflectance` has the four k's, >= 0; its exponent q is left for the caller to fill in with
    /// that of the pictures.  `absent` names the terms that are black in every picture: their k is
    /// 0 because the method does not have them, not because the target does not.
    struct Result {
        Reflectance reflectance;
        RelativeError training_error;
        std::vector<Term> absent;
    };

    /// EXPECTS at least one light.
    Result best() const;

  private:
    std::array<NonnegativeLeastSquares, 3> channels_;
    std::size_t pixels_ = 0;
};

/// How far the sum of the terms with these k's is from the target: for a light that was held out.
/// Errors: as of `add_training_light`.
Expected<RelativeError> fit_error(const Reflectance& k, const LightPictures& pictures);

/// The pictures of each term alone with k = 1 (exponent q as in the scene), drawn by the method.
/// Needs a current OpenGL context, the one the method was prepared in.
/// Errors: as of `render_picture`.
Expected<std::array<imaging::LinearImage, 4>>
term_pictures(methods::Method& method, const Scene& scene, int width, int height, int samples);

} // namespace renderer::pictures
