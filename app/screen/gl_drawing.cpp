#include "app/screen/gl_drawing.h"

#include <array>
#include <cstddef>
#include <string>

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

/// Compiles and links; attribute i of `attributes` gets place i. Fails with the driver's words.
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

/// One vertex attribute of floats or normalised bytes, `offset` bytes into each vertex.
struct VertexAttribute {
    int count = 0;
    bool is_bytes = false;
    std::size_t offset = 0;
};

/// Binds the buffer's vertices of `stride` bytes to attributes 0, 1, ...
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

constexpr const char* image_vertex_source = R"(#version 120
attribute vec4 corner;  // place on the screen (-1 ... 1), place on the texture (0 ... 1)
varying vec2 vary_place;

void main() {
    vary_place = corner.zw;
    gl_Position = vec4(corner.xy, 0.0, 1.0);
}
)";

constexpr const char* image_fragment_source = R"(#version 120
uniform sampler2D image;
varying vec2 vary_place;

void main() {
    gl_FragColor = texture2D(image, vary_place);
}
)";

constexpr const char* stroke_vertex_source = R"(#version 120
attribute vec2 place;   // px, y down
attribute vec4 stroke;  // along, across, length, half width (px)
attribute vec4 colour;
uniform vec2 screen;
varying vec4 vary_stroke;
varying vec4 vary_colour;

void main() {
    vary_stroke = stroke;
    vary_colour = colour;
    gl_Position = vec4(2.0 * place.x / screen.x - 1.0, 1.0 - 2.0 * place.y / screen.y, 0.0, 1.0);
}
)";

// The distance to the line between the ends decides: inside, on the smooth rim, or outside.
constexpr const char* stroke_fragment_source = R"(#version 120
varying vec4 vary_stroke;
varying vec4 vary_colour;

void main() {
    float beyond = max(max(-vary_stroke.x, vary_stroke.x - vary_stroke.z), 0.0);
    float distance_px = length(vec2(beyond, vary_stroke.y));
    float alpha = vary_colour.a * clamp(vary_stroke.w + 0.5 - distance_px, 0.0, 1.0);
    gl_FragColor = vec4(vary_colour.rgb * alpha, alpha);
}
)";

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

ImageLayer::ImageLayer() : texture_(make_texture()), corners_(make_buffer()) {}

void ImageLayer::upload(const Canvas& canvas, int x, int y, int screen_width, int screen_height) {
    is_filled_ = true;
    glBindTexture(GL_TEXTURE_2D, texture_.get());
    // Cairo's order of channels, so that the driver rearranges nothing.
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, canvas.width(), canvas.height(), 0, GL_BGRA,
                 GL_UNSIGNED_BYTE, canvas.pixels());
    const auto across = [screen_width](int px) {
        return 2.0F * static_cast<float>(px) / static_cast<float>(screen_width) - 1.0F;
    };
    const auto down = [screen_height](int px) {
        return 1.0F - 2.0F * static_cast<float>(px) / static_cast<float>(screen_height);
    };
    const float left = across(x);
    const float right = across(x + canvas.width());
    const float top = down(y);
    const float bottom = down(y + canvas.height());
    // Two separate triangles, clockwise from the upper left. Software drawing takes such a pair for
    // a copy, three times as fast as a strip, which it shades pixel by pixel.
    const std::array<float, 24> corners{left,  top,    0.0F, 0.0F, right, top,    1.0F, 0.0F,
                                        right, bottom, 1.0F, 1.0F, left,  top,    0.0F, 0.0F,
                                        right, bottom, 1.0F, 1.0F, left,  bottom, 0.0F, 1.0F};
    glBindBuffer(GL_ARRAY_BUFFER, corners_.get());
    glBufferData(GL_ARRAY_BUFFER, sizeof(corners), corners.data(), GL_STATIC_DRAW);
}

StrokeBuffer::StrokeBuffer() : buffer_(make_buffer()) {}

bool StrokeBuffer::upload(const Strokes& strokes) {
    const auto& vertices = strokes.vertices();
    if (vertices == vertices_) return false;
    vertices_ = vertices;
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.get());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(StrokeVertex)),
                 vertices.data(), GL_STREAM_DRAW);
    return true;
}

Result<Renderer> Renderer::make() {
    auto images = make_program(image_vertex_source, image_fragment_source, {"corner"});
    if (!images) return tl::unexpected(images.error());
    auto strokes =
        make_program(stroke_vertex_source, stroke_fragment_source, {"place", "stroke", "colour"});
    if (!strokes) return tl::unexpected(strokes.error());
    return Renderer(std::move(*images), std::move(*strokes));
}

Renderer::Renderer(GlProgram images, GlProgram strokes)
    : images_(std::move(images)),
      strokes_(std::move(strokes)),
      screen_(glGetUniformLocation(strokes_.get(), "screen")) {}

void Renderer::draw(const ImageLayer& layer) const {
    glUseProgram(images_.get());
    glBindTexture(GL_TEXTURE_2D, layer.texture_.get());
    bind_vertices(layer.corners_, 4 * sizeof(float), {{4, false, 0}});
    glDrawArrays(GL_TRIANGLES, 0, 6);
}

void Renderer::draw(const StrokeBuffer& strokes, int width_px, int height_px) const {
    if (strokes.vertices_.empty()) return;
    glUseProgram(strokes_.get());
    glUniform2f(screen_, static_cast<float>(width_px), static_cast<float>(height_px));
    bind_vertices(strokes.buffer_, sizeof(StrokeVertex),
                  {{2, false, offsetof(StrokeVertex, x)},
                   {4, false, offsetof(StrokeVertex, along)},
                   {4, true, offsetof(StrokeVertex, rgba)}});
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(strokes.vertices_.size()));
}

}  // namespace touchline
