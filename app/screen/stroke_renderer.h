// Draws Strokes with OpenGL: one shader, one draw call per list.
// Threads: the one that holds the context.
#pragma once

#include "app/screen/gl_objects.h"
#include "app/screen/strokes.h"

namespace touchline {

/// Strokes in the memory of the graphics driver.
class StrokeBuffer {
  public:
    StrokeBuffer() : buffer_(make_buffer()) {}

    void upload(const Strokes& strokes);

  private:
    friend class StrokeRenderer;

    GlBuffer buffer_;
    int vertex_count_ = 0;
};

class StrokeRenderer {
  public:
    [[nodiscard]] static Result<StrokeRenderer> make();

    /// Draws on a screen of this size (px).
    void draw(const StrokeBuffer& strokes, int width_px, int height_px) const;

  private:
    explicit StrokeRenderer(GlProgram program);

    GlProgram program_;
    int screen_ = -1;  // location of the uniform
};

}  // namespace touchline
