// What storing coefficients in fewer bytes changes in the picture: the share of the body's pixels
// in which some channel is off by a code value of an 8-bit display or more, and the largest step.
// Every model in the three materials and sizes of the study's scenes.
//
//   storage_bench MODEL...
#include "renderer/gpu/context.h"
#include "renderer/imaging/colour.h"
#include "renderer/pictures/picture.h"
#include "tests/bench/workbench.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

namespace {

using namespace bench;

constexpr int size = 480;

struct Off {
    double share = 0;   ///< of the body's pixels, one code value or more
    double largest = 0; ///< code values
};

double code_values_apart(LinearRgb a, LinearRgb b) {
    const auto x = imaging::encode(a), y = imaging::encode(b);
    return 255.0 * static_cast<double>(
                       std::max({std::abs(x.r - y.r), std::abs(x.g - y.g), std::abs(x.b - y.b)}));
}

Off compare(const imaging::LinearImage& exact, const imaging::LinearImage& stored) {
    Off off;
    int body = 0, beyond = 0;
    for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
        if (exact.coverage[i] < 1)
            continue;
        ++body;
        const double apart = code_values_apart(exact.pixels[i], stored.pixels[i]);
        off.largest = std::max(off.largest, apart);
        beyond += apart >= 1 ? 1 : 0;
    }
    off.share = static_cast<double>(beyond) / body;
    return off;
}

struct Matter {
    std::string name;
    Millimetres diameter;
};

const std::array<Matter, 3> matters{{{"marble", {100}}, {"skim-milk", {100}}, {"skin2", {60}}}};

void measure(const std::string& model,
             const geometry::Mesh& mesh,
             const Workbench& workbench,
             const Matter& matter) {
    auto scene = scene_of(mesh, size, size, matter.diameter);
    scene.material = *measured_material(matter.name);
    const std::vector<std::pair<std::string, glm::dvec3>> lights{
        {"back", {0, 0.3, -1}}, {"front", {0.3, 0.3, 1}}, {"left", {-1, 0.2, 0.2}}};
    for (const std::string law : {"paper", "physical"})
        for (const auto& [name, to_light] : lights) {
            scene.lights.front().place = DirectionalLight{to_light};
            const auto draw = [&](const std::string& type) {
                return value_or_throw(pictures::render_picture(
                    *workbench.prepare("shss", {{"law", law}, {"coefficients", type}}), scene, size,
                    size, 4));
            };
            const auto exact = draw("float32");
            for (const std::string type : {"float16", "int8"}) {
                const auto off = compare(exact, draw(type));
                fmt::print("| {} | {}, {} mm | {} | {} | {} | {:.3f} % | {:.2f} |\n", model,
                           matter.name, matter.diameter.value, law, name, type, 100 * off.share,
                           off.largest);
            }
        }
}

} // namespace

int main(int argc, char** argv) {
    try {
        const auto context = value_or_throw(gpu::Context::surfaceless());
        fmt::print("| model | material | law | light | stored as | off by a code value or more | "
                   "largest, code "
                   "values |\n|---|---|---|---|---|---|---|\n");
        for (int i = 1; i < argc; ++i) {
            const auto mesh = load_drawn_mesh(argv[i]);
            const Workbench workbench(mesh, scene_of(mesh, size, size));
            for (const auto& matter : matters)
                measure(argv[i], mesh, workbench, matter);
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "storage_bench: {}\n", error.what());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
