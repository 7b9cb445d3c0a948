// Tests pictures without any writing: no label, nothing masked.
#include "app/documents/decode/opening.h"
#include "app/documents/gallery/gallery.h"
#include "tests/app/documents/decode/encoders.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::string labels_in(const Picture& picture, const ReadingOrder& order = {}) {
    const auto found = read_words(picture, order);
    if (!found) return found.error().line;
    EXPECT_EQ(found->boxes.empty(), found->labels.empty());
    std::string texts;
    for (const Label& label : found->labels) texts += label.text + '\n';
    return texts;
}

/// Expects each word of the labels to begin a written word: a line beside it may hide its end.
void expect_written(const std::string& labels, const TactileMap& map, const std::string& path) {
    std::istringstream read(labels);
    for (std::string word; read >> word;) {
        const bool is_there = std::ranges::any_of(map.labels, [&word](const Label& label) {
            return (' ' + label.text).find(' ' + word) != std::string::npos;
        });
        EXPECT_TRUE(is_there) << path << ": " << word;
    }
}

TEST(ReadingNothing, InTheGalleryNothingButWhatIsWrittenOnIt) {
    const auto entries = list_gallery(TOUCHLINE_SOURCE_DIR "/app/documents/gallery/pictures");
    ASSERT_TRUE(entries && entries->size() >= 16);
    int written = 0;
    for (const auto& entry : *entries) {
        const auto page = open_page_of(entry.path);
        ASSERT_TRUE(page.has_value()) << page.error().line;
        const std::string labels = labels_in(page->picture);
        expect_written(labels, page->told, entry.path);
        written += labels.empty() ? 0 : 1;
    }
    EXPECT_GE(written, 5) << "the pictures with words on them";
}

/// Strokes, rings, hatchings and boxes, as drawn by hand.
std::string drawing(unsigned seed) {
    std::mt19937 random(seed);
    const auto any = [&random](int most) {
        return static_cast<int>(random() % static_cast<unsigned>(most));
    };
    std::ostringstream svg;
    svg << R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1600 1200">)"
        << R"(<rect width="1600" height="1200" fill="white"/>)"
        << R"(<g fill="none" stroke="black">)";
    for (int i = 0; i < 60; ++i) {
        const int x = any(1600);
        const int y = any(1200);
        const int size = 8 + any(i % 3 == 0 ? 300 : 40);
        svg << R"(<g stroke-width=")" << 1 + any(5) << R"(">)";
        switch (any(4)) {
            case 0:
                svg << "<circle cx='" << x << "' cy='" << y << "' r='" << size << "'/>";
                break;
            case 1:
                svg << "<path d='M" << x << ' ' << y << 'C' << x + any(size) << ' ' << y - any(size)
                    << ' ' << x - any(size) << ' ' << y + any(size) << ' ' << x + size << ' '
                    << y + any(size) << "'/>";
                break;
            case 2:
                svg << "<rect x='" << x << "' y='" << y << "' width='" << size << "' height='"
                    << 5 + any(size) << "'/>";
                break;
            default:
                for (int line = 0; line < 6; ++line)
                    svg << "<path d='M" << x + 7 * line << ' ' << y << 'l' << any(10) << ' ' << size
                        << "'/>";
        }
        svg << "</g>";
    }
    svg << "</g></svg>";
    return svg.str();
}

TEST(ReadingNothing, InDrawings) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const auto page = open_page(encoders::bytes_of(drawing(seed)));
        ASSERT_TRUE(page.has_value()) << page.error().line;
        EXPECT_EQ(labels_in(page->picture), "") << seed;
    }
}

/// Noise of several grain sizes, like a photo of grass, hair or gravel.
Picture noise(unsigned seed, int grain_px) {
    std::mt19937 random(seed);
    constexpr int width = 640;
    constexpr int height = 480;
    std::vector<int> grains(static_cast<std::size_t>(width * height));
    for (int& grain : grains) grain = static_cast<int>(random() % 256);
    Picture picture{width, height, {}, 1.0};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int grain = grains[static_cast<std::size_t>(y / grain_px * width + x / grain_px)];
            const double light = 0.5 + 0.5 * std::sin(0.01 * (x + 2 * y));
            picture.bgr.insert(picture.bgr.end(), 3, static_cast<std::uint8_t>(light * grain));
        }
    return picture;
}

TEST(ReadingNothing, InNoise) {
    for (const int grain_px : {1, 2, 3, 5, 8, 20})
        EXPECT_EQ(labels_in(noise(static_cast<unsigned>(grain_px), grain_px)), "") << grain_px;
}

TEST(ReadingNothing, InPicturesOfAnyShape) {
    for (const auto& [width, height] :
         {std::pair{1, 1}, {1, 5000}, {5000, 1}, {10'000, 3}, {3, 10'000}, {40, 30}, {2500, 2500}})
        EXPECT_EQ(labels_in(encoders::test_picture(width, height)), "") << width << " x " << height;
}

TEST(ReadingNothing, InSeveralLanguages) {
    const auto page = open_page(encoders::bytes_of(drawing(99)));
    EXPECT_EQ(labels_in(page->picture, {{WrittenLanguage::english, WrittenLanguage::german,
                                         WrittenLanguage::french, WrittenLanguage::spanish,
                                         WrittenLanguage::italian}}),
              "");
}

}  // namespace
}  // namespace touchline
