// What shows the pictures, as far as a program can be told: size, distance, code values and light.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace protocols {

/// A measured step of a display: the light of a grey code value.
struct GreyStep {
    int code = 0;     ///< 0..255
    double cd_m2 = 0; ///< luminance
    bool operator==(const GreyStep&) const = default;
};

/// From code values to light, relative to white.  [IEC61966-2-1] for sRGB.
struct Eotf {
    enum class Kind { Srgb, Gamma, Measured };
    Kind kind = Kind::Srgb;
    double gamma = 2.2;          ///< Gamma: (code / 255)^gamma
    std::string file;            ///< Measured: of measurements, relative to the study folder
    std::vector<GreyStep> steps; ///< Measured: by rising code, first and last are 0 and 255
};

/// "srgb", "gamma 2.2", "table calibration.csv"
std::string name_of(const Eotf& eotf);

/// Light of a grey code value relative to code 255, 0..1.  A table is joined by straight lines.
/// EXPECTS a code of 0..255 and, for a table, steps.
double relative_luminance(const Eotf& eotf, int code);

/// The code whose light is nearest.  EXPECTS 0..1.
int nearest_code(const Eotf& eotf, double luminance);

/// Relative luminance of CIE lightness L*, 0..100.  [CIE15]
double luminance_of_lightness(double lightness);

/// The grey around the pictures, as the code value written to the frame buffer in every channel.
struct Surround {
    int code = 128;
    std::string definition = "code:128"; ///< as the study asks for it
    bool operator==(const Surround&) const = default;
};

/// "code:128", "lstar:50" or "linear:0.5" as a code of this display.  Empty where it is none.
std::optional<Surround> surround_of(const std::string& definition, const Eotf& eotf);

struct Display {
    Eotf eotf;
    double screen_width_mm = 0; ///< of the visible picture; 0: not known
    double distance_mm = 0;     ///< eye to screen; 0: free, or not known
    int photodiode_px = 0;      ///< edge of a patch in the lower left corner; 0: none
    double text_scale = 1;      ///< of the pages
    bool high_contrast = false; ///< pages in black on white
};

/// What only the experimenter can measure; empty is "not recorded".  Names as in BT.500.
struct Room {
    std::optional<double> peak_cd_m2;       ///< luminance of white
    std::optional<double> black_ratio;      ///< luminance of black over that of white, dark room
    std::optional<double> screen_off_ratio; ///< of the inactive screen over white
    std::optional<double> background_ratio; ///< of the wall behind the display over white
    std::optional<double> ambient_lux;      ///< on the screen
    std::optional<double> max_angle_deg;    ///< of an observer to the screen's normal
    std::string background_white;           ///< of the wall, such as "D65"
};

/// What is recorded of it, "peak_cd_m2=120; black_ratio=0.01"; "" where nothing is.
std::string text_of(const Room& room);

/// pi/180 d / p, the tangent of a small angle.  EXPECTS positive numbers.
double pixels_per_degree(double distance_mm, double pixel_pitch_mm);

} // namespace protocols
