#include "app/screen/image_layer.h"

#include <array>

#include <epoxy/gl.h>

namespace touchline {

namespace {

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

}  // namespace

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

Result<ImageRenderer> ImageRenderer::make() {
    auto program = make_program(image_vertex_source, image_fragment_source, {"corner"});
    if (!program) return tl::unexpected(program.error());
    return ImageRenderer(std::move(*program));
}

void ImageRenderer::draw(const ImageLayer& layer) const {
    glUseProgram(program_.get());
    glBindTexture(GL_TEXTURE_2D, layer.texture_.get());
    bind_vertices(layer.corners_, 4 * sizeof(float), {{4, false, 0}});
    glDrawArrays(GL_TRIANGLES, 0, 6);
}

}  // namespace touchline
