// A painted canvas as a texture, drawn pixel for pixel.
// Threads: the one that holds the context.
#pragma once

#include "app/screen/canvas.h"
#include "app/screen/gl_objects.h"

namespace touchline {

class ImageLayer {
  public:
    ImageLayer() : texture_(make_texture()), corners_(make_buffer()) {}

    /// Shows `canvas` with its upper left corner at (x, y) of a screen of this size (px).
    void upload(const Canvas& canvas, int x, int y, int screen_width, int screen_height);

    /// Shows nothing from now on.
    void clear() { is_filled_ = false; }

    [[nodiscard]] bool is_filled() const { return is_filled_; }

  private:
    friend class ImageRenderer;

    GlTexture texture_;
    GlBuffer corners_;
    bool is_filled_ = false;
};

class ImageRenderer {
  public:
    [[nodiscard]] static Result<ImageRenderer> make();

    /// Draws it over what is there. The layer must be filled.
    void draw(const ImageLayer& layer) const;

  private:
    explicit ImageRenderer(GlProgram program) : program_(std::move(program)) {}

    GlProgram program_;
};

}  // namespace touchline
