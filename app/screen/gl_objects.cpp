#include "app/screen/gl_objects.h"

#include <array>

#include <epoxy/gl.h>
#include <fmt/format.h>

namespace touchline {

namespace {

/// The first line of a driver's log.
std::string first_line(const char* log) {
    const std::string text(log);
    return text.substr(0, text.find('\n'));
}

Result<GLuint> compile(GLenum kind, const char* source) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint is_compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &is_compiled);
    if (is_compiled == GL_TRUE) return shader;
    std::array<char, 512> log{};
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    glDeleteShader(shader);
    return failure(fmt::format("the graphics driver refused a shader: {}; update the driver",
                               first_line(log.data())));
}

}  // namespace

void destroy_program(std::uint32_t name) {
    glDeleteProgram(name);
}

void destroy_buffer(std::uint32_t name) {
    glDeleteBuffers(1, &name);
}

void destroy_texture(std::uint32_t name) {
    glDeleteTextures(1, &name);
}

Result<GlProgram> make_program(const char* vertex_source, const char* fragment_source,
                               std::initializer_list<const char*> attributes) {
    const auto vertex = compile(GL_VERTEX_SHADER, vertex_source);
    if (!vertex) return tl::unexpected(vertex.error());
    const auto fragment = compile(GL_FRAGMENT_SHADER, fragment_source);
    if (!fragment) {
        glDeleteShader(*vertex);
        return tl::unexpected(fragment.error());
    }
    GlProgram program(glCreateProgram());
    GLuint place = 0;
    for (const char* attribute : attributes)
        glBindAttribLocation(program.get(), place++, attribute);
    for (const GLuint shader : {*vertex, *fragment}) {
        glAttachShader(program.get(), shader);
        glDeleteShader(shader);  // lives as long as the program
    }
    glLinkProgram(program.get());
    GLint is_linked = GL_FALSE;
    glGetProgramiv(program.get(), GL_LINK_STATUS, &is_linked);
    if (is_linked == GL_TRUE) return program;
    std::array<char, 512> log{};
    glGetProgramInfoLog(program.get(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    return failure(fmt::format("the graphics driver cannot link the shaders: {}; update the driver",
                               first_line(log.data())));
}

GlBuffer make_buffer() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return GlBuffer(name);
}

GlTexture make_texture() {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return GlTexture(name);
}

void bind_vertices(const GlBuffer& buffer, std::size_t stride,
                   std::initializer_list<VertexAttribute> attributes) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer.get());
    GLuint place = 0;
    for (const VertexAttribute& attribute : attributes) {
        // OpenGL takes the offset into the bound buffer as a pointer.
        const auto* const offset = reinterpret_cast<const void*>(attribute.offset);
        const GLenum type = attribute.is_bytes ? GL_UNSIGNED_BYTE : GL_FLOAT;
        const GLboolean is_normalised = attribute.is_bytes ? GL_TRUE : GL_FALSE;
        glEnableVertexAttribArray(place);
        glVertexAttribPointer(place, attribute.count, type, is_normalised,
                              static_cast<GLsizei>(stride), offset);
        ++place;
    }
}

}  // namespace touchline
