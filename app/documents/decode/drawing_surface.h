// Private to app/documents/decode: what SVG and PDF are drawn with: a sheet that libraries draw on,
// with its pixels, and what GLib gives. Threads: one sheet, one thread.
#pragma once

#include "app/documents/decode/picture.h"
#include "app/isolation/process/descriptor.h"

#include <cairo.h>
#include <glib.h>

namespace touchline::decode {

using GlibText = Owned<gchar, g_free>;
using GlibError = Owned<GError, g_error_free>;

class DrawingSurface {
  public:
    /// Makes an empty sheet. The size must be within the limits of picture.h.
    DrawingSurface(int width, int height);

    [[nodiscard]] cairo_t* context() const { return context_.get(); }

    /// The drawing, over the background that shows it (compose of readers.h). Fails if cairo gave
    /// up.
    [[nodiscard]] Result<Picture> picture() const;

  private:
    Owned<cairo_surface_t, cairo_surface_destroy> surface_;
    Owned<cairo_t, cairo_destroy> context_;
};

}  // namespace touchline::decode
