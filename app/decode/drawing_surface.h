// Private to app/decode: a sheet that libraries draw on, and its pixels.
// Threads: one sheet, one thread.
#pragma once

#include "app/decode/picture.h"

#include <memory>

#include <cairo.h>

namespace touchline::decode {

class DrawingSurface {
  public:
    /// Makes an empty sheet. The size must be within the limits of picture.h.
    DrawingSurface(int width, int height);

    /// Fills the sheet with white: some libraries draw as on paper.
    void whiten();

    [[nodiscard]] cairo_t* context() const { return context_.get(); }

    /// The drawing, over the background that shows it (compose of formats.h). Fails if cairo gave
    /// up.
    [[nodiscard]] Result<Picture> picture() const;

  private:
    struct Release {
        void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }

        void operator()(cairo_t* context) const { cairo_destroy(context); }
    };

    std::unique_ptr<cairo_surface_t, Release> surface_;
    std::unique_ptr<cairo_t, Release> context_;
};

}  // namespace touchline::decode
