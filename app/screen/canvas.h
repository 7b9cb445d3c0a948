// A Cairo image surface and its context, owned.
// Threads: one at a time.
#pragma once

#include "app/documents/decode/picture.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include <cairo.h>

namespace touchline {

struct CairoDeleter {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }

    void operator()(cairo_t* context) const { cairo_destroy(context); }
};

/// 32-bit premultiplied BGRA in memory, rows from the top. Transparent at first.
class Canvas {
  public:
    /// Sizes 1 ... 32767 px.
    Canvas(int width, int height);

    [[nodiscard]] cairo_t* context() const { return context_.get(); }

    [[nodiscard]] cairo_surface_t* surface() const { return surface_.get(); }

    [[nodiscard]] int width() const;
    [[nodiscard]] int height() const;

    /// The pixels as drawn so far: rows of `stride` bytes.
    [[nodiscard]] const unsigned char* pixels() const;
    [[nodiscard]] int stride() const;

  private:
    std::unique_ptr<cairo_surface_t, CairoDeleter> surface_;
    std::unique_ptr<cairo_t, CairoDeleter> context_;
};

/// The picture, reduced so that its longer side is at most `longest_px`: as much as the screen can
/// show.
[[nodiscard]] Canvas canvas_of(const Picture& picture, int longest_px);

/// A frame of the camera: rows of B, G, R bytes from the top, `stride` bytes apart; `bgr` holds
/// them all. Sizes as for Canvas.
[[nodiscard]] Canvas canvas_of_frame(std::span<const std::uint8_t> bgr, int width, int height,
                                     std::size_t stride);

/// The canvas over a black background.
[[nodiscard]] Picture picture_of(const Canvas& canvas);

}  // namespace touchline
