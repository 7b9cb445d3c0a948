#include "app/screen/stroke_renderer.h"

#include <cstddef>

#include <epoxy/gl.h>

namespace touchline {

namespace {

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

void StrokeBuffer::upload(const Strokes& strokes) {
    const auto& vertices = strokes.vertices();
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.get());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(StrokeVertex)),
                 vertices.data(), GL_STREAM_DRAW);
    vertex_count_ = static_cast<int>(vertices.size());
}

Result<StrokeRenderer> StrokeRenderer::make() {
    auto program =
        make_program(stroke_vertex_source, stroke_fragment_source, {"place", "stroke", "colour"});
    if (!program) return tl::unexpected(program.error());
    return StrokeRenderer(std::move(*program));
}

StrokeRenderer::StrokeRenderer(GlProgram program)
    : program_(std::move(program)), screen_(glGetUniformLocation(program_.get(), "screen")) {}

void StrokeRenderer::draw(const StrokeBuffer& strokes, int width_px, int height_px) const {
    if (strokes.vertex_count_ == 0) return;
    glUseProgram(program_.get());
    glUniform2f(screen_, static_cast<float>(width_px), static_cast<float>(height_px));
    bind_vertices(strokes.buffer_, sizeof(StrokeVertex),
                  {{2, false, offsetof(StrokeVertex, x)},
                   {4, false, offsetof(StrokeVertex, along)},
                   {4, true, offsetof(StrokeVertex, rgba)}});
    glDrawArrays(GL_TRIANGLES, 0, strokes.vertex_count_);
}

}  // namespace touchline
