#include "tests/end_to_end/small_study.h"

#include "renderer/imaging/image_files.h"
#include "tests/end_to_end/program.h"

#include <fmt/format.h>

#include <functional>
#include <stdexcept>

namespace tests {

namespace {

constexpr const char* study_text = R"([study]
id       = "small"
title    = "A small study"
question = "Which picture looks more realistic?"
seed     = 7
width    = 200
height   = 150

[session]
sessions   = 1
days_apart = 0
warm_ups   = 3
training   = 4
grey_ms    = 100
closed_ms  = 50
adapt_s    = 1
gap_px     = 20

[instructions]
language = "en"
file     = "instructions.md"

[[scene]]
id = "garden"

[[scene]]
id = "harbour"

[[condition]]
id     = "first"
source = "images"

[[condition]]
id     = "second"
source = "images"

[[condition]]
id     = "third"
source = "images"
)";

} // namespace

renderer::imaging::EncodedImage small_picture(const std::string& scene,
                                              const std::string& condition) {
    renderer::imaging::EncodedImage image{picture_width, picture_height, 8, {}};
    auto state = static_cast<std::uint32_t>(std::hash<std::string>{}(scene + condition)) | 1U;
    for (int i = 0; i < 3 * picture_width * picture_height; ++i) {
        state = state * 1664525U + 1013904223U;
        image.codes.push_back(static_cast<std::uint16_t>(state >> 24));
    }
    return image;
}

void write_small_study(const std::filesystem::path& folder) {
    write_file(folder / "study.toml", study_text);
    write_file(folder / "instructions.md", "# Welcome\n\nChoose the more realistic picture.\n");
    for (const std::string& scene : {std::string("garden"), std::string("harbour")})
        for (const std::string& condition :
             {std::string("first"), std::string("second"), std::string("third")}) {
            const auto file = folder / "stimuli" / scene / (condition + ".png");
            std::filesystem::create_directories(file.parent_path());
            if (const auto written =
                    renderer::imaging::write_png(file, small_picture(scene, condition));
                !written)
                throw std::runtime_error(written.error());
        }
}

void write_seed_study(const std::filesystem::path& folder) {
    std::string text = R"([study]
id       = "seed-shape"
title    = "The seed study's shape"
question = "Which picture looks more realistic?"
seed     = 2012
width    = 200
height   = 150

[session]
sessions = 3
)";
    for (const auto* scene : {"armadillo", "bunny", "horse"})
        text += fmt::format("\n[[scene]]\nid = \"{}\"\n", scene);
    for (const auto* variant : {"back", "front", "left"})
        text += fmt::format("\n[[variant]]\nid = \"{}\"\n", variant);
    for (const auto* condition : {"shss-25", "shss-4", "green", "phong"})
        text += fmt::format("\n[[condition]]\nid = \"{}\"\nsource = \"images\"\n", condition);
    write_file(folder / "study.toml", text);
    write_file(folder / "instructions.md", "# Welcome\n\nChoose the more realistic picture.\n");
    for (const std::string scene : {"armadillo", "bunny", "horse"})
        for (const std::string variant : {"back", "front", "left"})
            for (const std::string condition : {"shss-25", "shss-4", "green", "phong"}) {
                const auto file = folder / "stimuli" / scene / variant / (condition + ".png");
                std::filesystem::create_directories(file.parent_path());
                if (const auto written = renderer::imaging::write_png(
                        file, small_picture(scene + variant, condition));
                    !written)
                    throw std::runtime_error(written.error());
            }
}

} // namespace tests
