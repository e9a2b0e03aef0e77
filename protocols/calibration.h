// What a photometer says of a display: the light of grey code values, and the curve through them.
#pragma once

#include "protocols/display.h"
#include "protocols/expected.h"

#include <string_view>
#include <vector>

namespace protocols {

/// The greys to be measured: 0, 32, 64, ..., 224, 255.
const std::vector<int>& photometer_codes();

/// Reads "code,cd_m2", or "code_r,code_g,code_b,X,Y,Z" of which the greys are taken (Y in cd/m2).
/// Returns steps by rising code.
/// Errors: "<file>:<line>: ..." for other columns, values out of range, a code twice; fewer than 9
/// greys; no 0 or no 255; a light that does not rise.
Expected<std::vector<GreyStep>> parse_photometer(std::string_view text, std::string_view file);

/// L = black + (white - black) (code / 255)^gamma, by least squares over the steps between.
struct GammaFit {
    double black_cd_m2 = 0;
    double white_cd_m2 = 0;
    double gamma = 0;
    double worst_residual = 0; ///< of a step's luminance, as a share of white
};

/// EXPECTS what parse_photometer returns.  Black and white are the measured ones; gamma is that of
/// least squared residuals between 0.5 and 5, to 1e-6.
GammaFit fit_gamma(const std::vector<GreyStep>& steps);

} // namespace protocols
