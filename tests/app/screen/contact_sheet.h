// Paints screens into memory as the window shows them, alone or many on one sheet.
#pragma once

#include "app/screen/canvas.h"
#include "app/screen/screen_layers.h"

#include <string>
#include <vector>

namespace touchline {

/// Paints `canvas` with its upper left corner there, made smaller by `scale`.
void paint_at(const Canvas& onto, const Canvas& canvas, PixelPoint at, double scale);

/// Composes the layers as they lie on a screen of this size, with the picture's lines and without
/// the hand.
[[nodiscard]] Canvas composed(const ScreenLayers& layers, int width_px, int height_px);

struct Thumbnail {
    std::string name;
    Canvas canvas;
};

/// Lays screens out in rows of `columns`, each `width_px` wide with its name above.
[[nodiscard]] Canvas contact_sheet(const std::vector<Thumbnail>& screens, int columns,
                                   int width_px);

}  // namespace touchline
