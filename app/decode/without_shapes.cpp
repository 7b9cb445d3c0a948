#include "app/decode/without_shapes.h"

#include <algorithm>
#include <utility>

namespace touchline::decode {
namespace {

constexpr int largest_letter = 6;      // of them fill the longer side
constexpr double most_of_a_box = 0.3;  // that a line fills
constexpr int soft_edge_px = 3;

/// What is dark, as in a printed page.
OwnedPix dark_parts_of(Pix* grey) {
    Pix* dark = nullptr;
    pixOtsuAdaptiveThreshold(grey, pixGetWidth(grey), pixGetHeight(grey), 0, 0, 0.0F, nullptr,
                             &dark);
    return OwnedPix(dark);
}

bool is_large_line(Pix* part, int longer_side) {
    const int width = pixGetWidth(part);
    const int height = pixGetHeight(part);
    if (largest_letter * std::max(width, height) <= longer_side) return false;
    int dark = 0;
    pixCountPixels(part, &dark, nullptr);
    return dark < most_of_a_box * width * height;
}

void paint_over(Pix* grey, Pix* part, int left, int top) {
    constexpr int reach = 2 * soft_edge_px + 1;
    const OwnedPix framed(pixAddBorder(part, soft_edge_px, 0));
    const OwnedPix grown(pixDilateBrick(nullptr, framed.get(), reach, reach));
    if (grown != nullptr)
        pixPaintThroughMask(grey, grown.get(), left - soft_edge_px, top - soft_edge_px, 255);
}

}  // namespace

OwnedPix without_shapes(OwnedPix grey) {
    const OwnedPix dark = dark_parts_of(grey.get());
    if (dark == nullptr) return grey;
    Pixa* found = nullptr;
    const std::unique_ptr<Boxa, PixRelease> boxes(pixConnComp(dark.get(), &found, 8));
    const std::unique_ptr<Pixa, PixRelease> parts(found);
    if (boxes == nullptr || parts == nullptr) return grey;
    const int longer_side = std::max(pixGetWidth(grey.get()), pixGetHeight(grey.get()));
    for (int i = 0; i < pixaGetCount(parts.get()); ++i) {
        const OwnedPix part(pixaGetPix(parts.get(), i, L_CLONE));
        int left = 0;
        int top = 0;
        boxaGetBoxGeometry(boxes.get(), i, &left, &top, nullptr, nullptr);
        if (is_large_line(part.get(), longer_side)) paint_over(grey.get(), part.get(), left, top);
    }
    return grey;
}

}  // namespace touchline::decode
