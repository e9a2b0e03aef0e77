#include "renderer/gpu/context.h"
#include "renderer/gpu/program.h"

#include <array>

namespace {

using renderer::gpu::Program;
using renderer::gpu::ShaderPart;

constexpr ShaderPart good_vertex{"good.vert", "void main() { gl_Position = vec4(0.0); }"};
constexpr ShaderPart good_fragment{"good.frag", "out vec4 c; void main() { c = vec4(1.0); }"};

class ProgramTest : public testing::Test {
  protected:
    void SetUp() override { ASSERT_TRUE(context_) << context_.error(); }

    static std::string error(std::span<const ShaderPart> vertex,
                             std::span<const ShaderPart> fragment) {
        const auto program = Program::link(vertex, fragment);
        return program ? "no error" : program.error();
    }

    renderer::Expected<renderer::gpu::Context> context_ = renderer::gpu::Context::surfaceless();
};

TEST_F(ProgramTest, LinksPartsInTheirOrder) {
    const std::array vertex{ShaderPart{"shared.glsl", "float one() { return 1.0; }"},
                            ShaderPart{"own.vert", "void main() { gl_Position = vec4(one()); }"}};
    const std::array fragment{good_fragment};
    EXPECT_EQ(error(vertex, fragment), "no error");
}

TEST_F(ProgramTest, AMistakeIsReportedWithItsFileAndLine) {
    const std::array vertex{ShaderPart{"shared.glsl", "float one() { return 1.0; }"},
                            ShaderPart{"own.vert", "void main() {\n  gl_Position = nonsense;\n}"}};
    const std::array fragment{good_fragment};
    const auto message = error(vertex, fragment);
    EXPECT_THAT(message,
                testing::StartsWith("shader (shared.glsl from line 2, own.vert from line 3): "));
    EXPECT_THAT(message, testing::ContainsRegex("[:(]4[:()]")); // the second line of own.vert
    EXPECT_THAT(message, testing::HasSubstr("nonsense"));
}

TEST_F(ProgramTest, PartsThatDoNotFitAreNamedTogether) {
    const std::array vertex{good_vertex};
    const std::array fragment{ShaderPart{
        "lonely.frag", "in float missing; out vec4 c; void main() { c = vec4(missing); }"}};
    EXPECT_THAT(
        error(vertex, fragment),
        testing::StartsWith("linking (good.vert from line 2) with (lonely.frag from line 2): "));
}

} // namespace
