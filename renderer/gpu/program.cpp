// Compiling and linking, with messages that lead to the line.
#include "renderer/gpu/program.h"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace renderer::gpu {

namespace {

void delete_shader(unsigned name) {
    glDeleteShader(name);
}

void delete_program(unsigned name) {
    glDeleteProgram(name);
}

std::string source(std::span<const ShaderPart> parts) {
    std::string text = "#version 450 core\n";
    for (const auto& part : parts)
        text += fmt::format("{}\n", part.text);
    return text;
}

// A #line directive with a number for every part would be shorter, but Mesa's log leaves the number
// out.
std::string places(std::span<const ShaderPart> parts) {
    std::string list;
    std::ptrdiff_t line = 2;
    for (const auto& part : parts) {
        list += fmt::format("{}{} from line {}", list.empty() ? "" : ", ", part.name, line);
        line += 1 + std::count(part.text.begin(), part.text.end(), '\n');
    }
    return list;
}

std::string shader_log(unsigned shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetShaderInfoLog(shader, length, nullptr, log.data());
    return log.c_str(); // up to the terminating zero
}

std::string program_log(unsigned program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetProgramInfoLog(program, length, nullptr, log.data());
    return log.c_str();
}

Expected<Object> compile(GLenum kind, std::span<const ShaderPart> parts) {
    Object shader(glCreateShader(kind), delete_shader);
    const auto text = source(parts);
    const char* begin = text.data();
    const auto length = static_cast<GLint>(text.size());
    glShaderSource(shader.name(), 1, &begin, &length);
    glCompileShader(shader.name());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE)
        return tl::make_unexpected(
            fmt::format("shader ({}): {}", places(parts), shader_log(shader.name())));
    return shader;
}

bool is_linked(const Object& program) {
    GLint linked = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    return linked != GL_FALSE;
}

} // namespace

Expected<Program> Program::link(std::span<const ShaderPart> vertex,
                                std::span<const ShaderPart> fragment) {
    const auto vertex_shader = compile(GL_VERTEX_SHADER, vertex);
    if (!vertex_shader)
        return tl::make_unexpected(vertex_shader.error());
    const auto fragment_shader = compile(GL_FRAGMENT_SHADER, fragment);
    if (!fragment_shader)
        return tl::make_unexpected(fragment_shader.error());

    Object program(glCreateProgram(), delete_program);
    glAttachShader(program.name(), vertex_shader->name());
    glAttachShader(program.name(), fragment_shader->name());
    glLinkProgram(program.name());
    glDetachShader(program.name(), vertex_shader->name());
    glDetachShader(program.name(), fragment_shader->name());
    if (!is_linked(program))
        return tl::make_unexpected(fmt::format("linking ({}) with ({}): {}", places(vertex),
                                               places(fragment), program_log(program.name())));
    return Program(std::move(program));
}

Expected<Program> Program::link_capturing(std::span<const ShaderPart> vertex,
                                          std::span<const char* const> captured) {
    const auto shader = compile(GL_VERTEX_SHADER, vertex);
    if (!shader)
        return tl::make_unexpected(shader.error());
    Object program(glCreateProgram(), delete_program);
    glAttachShader(program.name(), shader->name());
    glTransformFeedbackVaryings(program.name(), static_cast<GLsizei>(captured.size()),
                                captured.data(), GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program.name());
    glDetachShader(program.name(), shader->name());
    if (!is_linked(program))
        return tl::make_unexpected(fmt::format("linking ({}), capturing {}: {}", places(vertex),
                                               fmt::join(captured, ", "),
                                               program_log(program.name())));
    return Program(std::move(program));
}

void Program::use() const {
    glUseProgram(program_.name());
}

} // namespace renderer::gpu
