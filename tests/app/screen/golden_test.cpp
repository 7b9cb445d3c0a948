// Compares every screen with its stored picture, of each size, palette and resolution, and the key
// screens that people look at. The pictures are made by
//   build/release/tests/app/screen/screen_sheet --golden .
#include "tests/app/screen/golden_sheet.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <cairo.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

const std::string source_folder = TOUCHLINE_SOURCE_DIR "/";

/// A stored picture; a pixel by a pixel if there is none.
GreyPicture read_grey(const std::string& file) {
    const std::unique_ptr<cairo_surface_t, CairoDeleter> stored(
        cairo_image_surface_create_from_png((source_folder + file).c_str()));
    const int width = std::max(cairo_image_surface_get_width(stored.get()), 1);
    const int height = std::max(cairo_image_surface_get_height(stored.get()), 1);
    const Canvas canvas(width, height);
    cairo_set_source_surface(canvas.context(), stored.get(), 0.0, 0.0);
    cairo_paint(canvas.context());
    return grey_of(canvas);
}

/// A part of a picture, in its pixels.
struct Cell {
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;
};

/// Of the screen with this number on a golden sheet.
Cell cell_of(std::size_t screen) {
    const int number = static_cast<int>(screen);
    return {number % golden_columns * golden_width_px, number / golden_columns * golden_height_px,
            golden_width_px, golden_height_px};
}

double mean_of(const GreyPicture& picture, const Cell& tile) {
    double sum = 0.0;
    for (int y = tile.top; y < tile.top + tile.height; ++y)
        for (int x = tile.left; x < tile.left + tile.width; ++x)
            sum += picture.grey[static_cast<std::size_t>(y * picture.width + x)];
    return sum / (255.0 * tile.width * tile.height);
}

/// The share of the cell's tiles that differ. A tile is as high as a row of small letters, so that
/// another version of the font's renderer changes none, and a word that moved changes some.
double share_differing(const GreyPicture& a, const GreyPicture& b, const Cell& cell, int tile_px) {
    constexpr double tolerance = 0.05;
    int tiles = 0;
    int differing = 0;
    for (int y = cell.top; y + tile_px <= cell.top + cell.height; y += tile_px) {
        for (int x = cell.left; x + tile_px <= cell.left + cell.width; x += tile_px) {
            const Cell tile{x, y, tile_px, tile_px};
            ++tiles;
            differing += std::abs(mean_of(a, tile) - mean_of(b, tile)) > tolerance;
        }
    }
    return static_cast<double>(differing) / tiles;
}

constexpr int golden_tile_px = 2;
constexpr int key_tile_px = 16;
constexpr double most_differing = 0.003;  // one tile of a screen on a golden sheet

TEST(Golden, EveryScreenOfEverySizePaletteAndResolutionIsAsStored) {
    for (const GoldenLook& look : golden_looks()) {
        const std::string file = "tests/app/screen/golden/" + golden_file(look);
        const GreyPicture stored = read_grey(file);
        const GoldenSheet drawn = golden_sheet(look);
        ASSERT_EQ(stored.width, drawn.picture.width) << file;
        ASSERT_EQ(stored.height, drawn.picture.height) << file;
        for (std::size_t i = 0; i < drawn.names.size(); ++i)
            EXPECT_LT(share_differing(stored, drawn.picture, cell_of(i), golden_tile_px),
                      most_differing)
                << file << ", " << drawn.names[i];
    }
}

TEST(Golden, TheKeyScreensAreAsStored) {
    const GreyPicture stored = read_grey("app/screen/key-screens.png");
    const GreyPicture drawn = grey_of(key_screens());
    ASSERT_EQ(stored.width, drawn.width);
    ASSERT_EQ(stored.height, drawn.height);
    const Cell all{0, 0, drawn.width, drawn.height};
    EXPECT_LT(share_differing(stored, drawn, all, key_tile_px), most_differing);
}

/// By the height of a row, on every screen: the one that is off has a single line, and that is
/// grey.
TEST(Golden, AWordThatMovedIsSeen) {
    const GoldenLook look;
    const GoldenSheet sheet = golden_sheet(look);
    GreyPicture moved = sheet.picture;
    std::rotate(moved.grey.begin(), moved.grey.end() - golden_tile_px * moved.width,
                moved.grey.end());
    for (std::size_t i = 0; i < sheet.names.size(); ++i)
        EXPECT_GT(share_differing(sheet.picture, moved, cell_of(i), golden_tile_px), most_differing)
            << sheet.names[i];
}

}  // namespace
}  // namespace touchline
