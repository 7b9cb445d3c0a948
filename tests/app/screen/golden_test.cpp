// Compares every screen with its stored picture, of each size and palette. The pictures are made by
//   screen_sheet --golden tests/app/screen/golden
#include "tests/app/screen/golden_sheet.h"
#include "tests/app/screen/probes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include <cairo.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

const std::string golden_folder = TOUCHLINE_SOURCE_DIR "/tests/app/screen/golden/";

/// A stored picture as a canvas; a pixel by a pixel if there is none.
Canvas read_golden(const std::string& file) {
    const std::unique_ptr<cairo_surface_t, CairoDeleter> stored(
        cairo_image_surface_create_from_png((golden_folder + file).c_str()));
    const int width = std::max(cairo_image_surface_get_width(stored.get()), 1);
    const int height = std::max(cairo_image_surface_get_height(stored.get()), 1);
    Canvas canvas(width, height);
    cairo_set_source_surface(canvas.context(), stored.get(), 0.0, 0.0);
    cairo_paint(canvas.context());
    return canvas;
}

double brightness(const Canvas& canvas, int x, int y) {
    const Colour c = colour_at(canvas, {x + 0.5, y + 0.5});
    return (c.red + c.green + c.blue) / 3.0;
}

double mean_brightness(const Canvas& canvas, int left, int top, int size) {
    double sum = 0.0;
    for (int y = top; y < top + size; ++y)
        for (int x = left; x < left + size; ++x) sum += brightness(canvas, x, y);
    return sum / (size * size);
}

/// The share of tiles that differ. A tile is as high as a row of small letters, so that another
/// version of the font's renderer changes none, and a word that moved changes some.
double share_differing(const Canvas& a, const Canvas& b) {
    constexpr int tile_px = 8;
    constexpr double tolerance = 0.08;
    int tiles = 0;
    int differing = 0;
    for (int y = 0; y + tile_px <= a.height(); y += tile_px) {
        for (int x = 0; x + tile_px <= a.width(); x += tile_px) {
            ++tiles;
            differing += std::abs(mean_brightness(a, x, y, tile_px) -
                                  mean_brightness(b, x, y, tile_px)) > tolerance;
        }
    }
    return static_cast<double>(differing) / tiles;
}

TEST(Golden, EveryScreenOfEverySizeAndPaletteIsAsStored) {
    for (std::size_t i = 0; i < palette_count * text_size_count; ++i) {
        const GoldenLook look{static_cast<TextSize>(i % text_size_count),
                              static_cast<PaletteName>(i / text_size_count)};
        const Canvas stored = read_golden(golden_file(look));
        const Canvas drawn = golden_sheet(look);
        ASSERT_EQ(stored.width(), drawn.width()) << golden_file(look);
        ASSERT_EQ(stored.height(), drawn.height()) << golden_file(look);
        EXPECT_LT(share_differing(stored, drawn), 0.002) << golden_file(look);
    }
}

TEST(Golden, AWordThatMovedIsSeen) {
    const Canvas one = golden_sheet({});
    Canvas two(one.width(), one.height());
    cairo_set_source_surface(two.context(), one.surface(), 0.0, 4.0);
    cairo_paint(two.context());
    EXPECT_GT(share_differing(one, two), 0.002);
}

}  // namespace
}  // namespace touchline
