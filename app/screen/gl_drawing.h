// Images and strokes drawn with OpenGL. Uses only the part of OpenGL 2.1 that OpenGL ES 2.0 has too
// (buffers, shaders, textures), so that small computers and software drawing run it alike.
// Threads: the one that holds the context; objects must die before the context.
#pragma once

#include "app/screen/canvas.h"
#include "app/screen/marks.h"
#include "config/types/result.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace touchline {

/// The name of an OpenGL object, deleted with its owner.
template <void (*destroy)(std::uint32_t)>
class GlName {
  public:
    explicit GlName(std::uint32_t name = 0) : name_(name) {}

    GlName(GlName&& other) noexcept : name_(other.name_) { other.name_ = 0; }

    GlName& operator=(GlName&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }

    ~GlName() {
        if (name_ != 0) destroy(name_);
    }

    [[nodiscard]] std::uint32_t get() const { return name_; }

  private:
    std::uint32_t name_;
};

void destroy_program(std::uint32_t name);
void destroy_buffer(std::uint32_t name);
void destroy_texture(std::uint32_t name);

using GlProgram = GlName<destroy_program>;
using GlBuffer = GlName<destroy_buffer>;
using GlTexture = GlName<destroy_texture>;

/// A painted canvas as a texture, drawn pixel for pixel.
class ImageLayer {
  public:
    ImageLayer();

    /// Shows `canvas` with its upper left corner at (x, y) of a screen of this size (px).
    void upload(const Canvas& canvas, int x, int y, int screen_width, int screen_height);

    /// Shows nothing from now on.
    void clear() { is_filled_ = false; }

    [[nodiscard]] bool is_filled() const { return is_filled_; }

  private:
    friend class Renderer;

    GlTexture texture_;
    GlBuffer corners_;
    bool is_filled_ = false;
};

/// Strokes in the memory of the graphics driver.
class StrokeBuffer {
  public:
    StrokeBuffer();

    /// Returns whether they differ from those uploaded last. O(strokes).
    bool upload(const Strokes& strokes);

  private:
    friend class Renderer;

    GlBuffer buffer_;
    std::vector<StrokeVertex> vertices_;  // uploaded last
};

/// One shader for all images and one for all strokes; one draw call each.
class Renderer {
  public:
    /// Fails with the driver's words.
    [[nodiscard]] static Result<Renderer> make();

    /// Draws it over what is there. The layer must be filled.
    void draw(const ImageLayer& layer) const;

    /// Draws on a screen of this size (px).
    void draw(const StrokeBuffer& strokes, int width_px, int height_px) const;

  private:
    Renderer(GlProgram images, GlProgram strokes);

    GlProgram images_;
    GlProgram strokes_;
    int screen_;  // location of the uniform
};

}  // namespace touchline
