// Tests every variant of each format: ImageMagick makes it, our workers open it, and ImageMagick
// shows the reference.
#include "tests/app/documents/decode/reference.h"

#include "app/documents/decode/opening.h"
#include "tests/config/scratch_folder.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

struct Form {
    std::string name;       // with its extension
    std::string arguments;  // of convert, after the drawing
    std::string prefix;     // before the file's name
    int most = 0;
    double mean = 0.0;
};

void PrintTo(const Form& form, std::ostream* out) {
    *out << form.name;
}

// For lossy codecs, and for transparency and 16 bits: every decoder rounds; ours rounds to nearest.
constexpr int most_of_lossy = 3;
constexpr double mean_of_lossy = 0.5;

// Colours, edges and gradients; no block and no byte divides the sides.
constexpr auto drawing =
    "convert -seed 1 -size 131x77 plasma:red-blue -fill yellow -draw 'circle 40,40 60,50' "
    "-fill black -draw 'rectangle 90,10 120,70' -depth 8 ";

class Reference : public testing::TestWithParam<Form> {
  protected:
    ScratchFolder folder_;
};

TEST_P(Reference, ShowsTheSame) {
    const Form& form = GetParam();
    const std::string path = folder_.path_of(form.name);
    ASSERT_TRUE(run_command(drawing + form.arguments + " '" + form.prefix + path + "'"));
    const auto page = open_page_of(path);
    ASSERT_TRUE(page.has_value()) << page.error().line;
    const auto expected = reference_picture(path, *page);
    ASSERT_TRUE(expected.has_value()) << expected.error().line;
    const Difference found = difference(page->picture, *expected);
    EXPECT_TRUE(found.is_comparable) << page->picture.width << 'x' << page->picture.height
                                     << " against " << expected->width << 'x' << expected->height;
    EXPECT_LE(found.most, form.most);
    EXPECT_LE(found.mean, form.mean);
}

const std::vector<Form> forms{
    {"plain.png", "", ""},
    {"deep.png", "-depth 16", "png48:"},
    {"grey-deep.png", "-colorspace gray -depth 16", "", 1, 0.5},
    {"palette.png", "-colors 50", "png8:"},
    {"clear.png", "-alpha set -channel A -evaluate set 60%", "png32:", 1, 0.5},
    {"plain.gif", "", ""},
    {"interlaced.gif", "-interlace GIF", ""},
    {"clear.gif", "-transparent yellow", ""},
    {"bits.gif", "-monochrome", ""},
    {"moves.gif", "-delay 10 -size 131x77 plasma:", ""},
    {"plain.bmp", "", ""},
    {"old.bmp", "", "bmp2:"},
    {"third.bmp", "", "bmp3:"},
    {"palette.bmp", "-colors 200", "bmp3:"},
    {"sixteen.bmp", "-colors 16 -type palette", "bmp3:"},
    {"bits.bmp", "-monochrome", "bmp3:"},
    {"runs.bmp", "-colors 200 -compress RLE", "bmp3:"},
    {"565.bmp", "-define bmp:subtype=RGB565", ""},
    {"clear.bmp", "-alpha set -channel A -evaluate set 60%", "", 1, 0.5},
    {"plain.ppm", "", ""},
    {"text.ppm", "-compress none", ""},
    {"deep.ppm", "-depth 16", ""},
    {"plain.pgm", "-colorspace gray", ""},
    {"text.pgm", "-colorspace gray -compress none", ""},
    {"plain.pbm", "-monochrome", ""},
    {"text.pbm", "-monochrome -compress none", ""},
    {"plain.tiff", "", ""},
    {"deep.tiff", "-depth 16", ""},
    {"zip.tiff", "-compress zip", ""},
    {"fax.tiff", "-monochrome -compress group4", ""},
    {"bits.tiff", "-monochrome", ""},
    {"palette.tiff", "-colors 50 -type palette", "", 1, 0.5},
    {"tiles.tiff", "-define tiff:tile-geometry=32x48", ""},
    {"strips.tiff", "-define tiff:rows-per-strip=3 -compress lzw", ""},
    {"planes.tiff", "-interlace plane", ""},
    {"first-is-last.tiff", "-define tiff:fill-order=lsb -monochrome -compress group4", ""},
    {"big-endian.tiff", "-define tiff:endian=msb -depth 16", ""},
    {"floating.tiff", "-depth 32 -define quantum:format=floating-point -compress zip", "", 1, 0.5},
    {"double.tiff", "-depth 64 -define quantum:format=floating-point -compress zip", "", 1, 0.5},
    {"half.tiff", "-depth 16 -define quantum:format=floating-point -compress zip", "", 1, 0.5},
    {"inks.tiff", "-colorspace CMYK", "", 1, 0.5},
    {"deep-inks.tiff", "-colorspace CMYK -depth 16", "", 1, 0.5},
    {"clear.tiff", "-alpha set -channel A -evaluate set 60%", "", 1, 0.5},
    {"jpeg.tiff", "-compress jpeg -quality 90", "", most_of_lossy, mean_of_lossy},
    {"interlaced.png", "-interlace PNG", ""},
    {"plain.jpg", "-quality 90", "", most_of_lossy, mean_of_lossy},
    {"grey.jpg", "-colorspace gray", "", most_of_lossy, mean_of_lossy},
    {"progressive.jpg", "-interlace plane", "", most_of_lossy, mean_of_lossy},
    {"plain.webp", "", "", most_of_lossy, mean_of_lossy},
    {"lossless.webp", "-define webp:lossless=true", ""},
    {"plain.heic", "", "", most_of_lossy, mean_of_lossy},
    {"plain.avif", "", "", most_of_lossy, mean_of_lossy},
};

INSTANTIATE_TEST_SUITE_P(Forms, Reference, testing::ValuesIn(forms), [](const auto& tested) {
    std::string name = tested.param.name;
    for (char& c : name)
        if (c == '.' || c == '-') c = '_';
    return name;
});

}  // namespace
}  // namespace touchline
