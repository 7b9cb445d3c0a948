// Tests that a PDF's pictures and words are where they are drawn, for any boxes, turns and units of
// a page.
#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/pdf_writer.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

struct Spot {
    double x = 0.0;
    double y = 0.0;
};

struct Box {
    double left = 0.0;
    double bottom = 0.0;
    double right = 0.0;
    double top = 0.0;
};

/// A turned page with its own units whose crop box is part of its media box.
struct Frame {
    Box media;
    Box crop;
    int turn = 0;  // quarter turns, clockwise
    std::string unit;
};

/// Where a point in page space is drawn, from the upper left corner, 0 ... 1 in each direction.
Spot drawn_at(const Frame& frame, Spot p) {
    const double x = (p.x - frame.crop.left) / (frame.crop.right - frame.crop.left);
    const double y = (frame.crop.top - p.y) / (frame.crop.top - frame.crop.bottom);
    switch (frame.turn) {
        case 1:
            return {1.0 - y, x};
        case 2:
            return {1.0 - x, 1.0 - y};
        case 3:
            return {y, 1.0 - x};
        default:
            return {x, y};
    }
}

Spot pixel_of(const Frame& frame, const Picture& picture, Spot p) {
    const Spot part = drawn_at(frame, p);
    return {part.x * picture.width, part.y * picture.height};
}

int whole(int least, int most) {
    return *rc::gen::inRange(least, most + 1);
}

Frame some_frame() {
    Frame frame;
    frame.media.left = whole(-300, 300);
    frame.media.bottom = whole(-300, 300);
    frame.media.right = frame.media.left + whole(500, 800);
    frame.media.top = frame.media.bottom + whole(500, 800);
    frame.crop = {frame.media.left + whole(0, 60), frame.media.bottom + whole(0, 60),
                  frame.media.right - whole(0, 60), frame.media.top - whole(0, 60)};
    frame.turn = whole(0, 3);
    frame.unit =
        *rc::gen::element<std::string>("", "/UserUnit 2.5", "/UserUnit 0.5", "/UserUnit 20");
    return frame;
}

std::string text_of(const Frame& frame) {
    const auto box = [](const char* name, const Box& b) {
        return fmt::format("/{} [{} {} {} {}]", name, b.left, b.bottom, b.right, b.top);
    };
    return fmt::format("{} {} /Rotate {} {}", box("MediaBox", frame.media),
                       box("CropBox", frame.crop), 90 * (frame.turn - (whole(0, 1) == 0 ? 4 : 0)),
                       frame.unit);
}

using Colour = std::array<int, 3>;  // blue, green, red

Colour at(const Picture& picture, Spot p) {
    const auto x = std::min(static_cast<int>(p.x), picture.width - 1);
    const auto y = std::min(static_cast<int>(p.y), picture.height - 1);
    const std::size_t i =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
             static_cast<std::size_t>(x));
    return {picture.bgr[i], picture.bgr[i + 1], picture.bgr[i + 2]};
}

bool is_near(const Colour& a, const Colour& b) {
    return std::abs(a[0] - b[0]) < 60 && std::abs(a[1] - b[1]) < 60 && std::abs(a[2] - b[2]) < 60;
}

/// Bounds all pixels that are nearer to a colour than to white and to the other colours.
WordBox bounds_of(const Picture& picture, bool (*is_it)(const Colour&)) {
    WordBox box{65535, 65535, 0, 0};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            if (!is_it(at(picture, {x + 0.5, y + 0.5}))) continue;
            box.left = std::min(box.left, static_cast<std::uint16_t>(x));
            box.top = std::min(box.top, static_cast<std::uint16_t>(y));
            box.right = std::max(box.right, static_cast<std::uint16_t>(x + 1));
            box.bottom = std::max(box.bottom, static_cast<std::uint16_t>(y + 1));
        }
    return box;
}

void expect_near(const WordBox& box, const WordBox& right, int slack_px) {
    RC_ASSERT(std::abs(box.left - right.left) <= slack_px);
    RC_ASSERT(std::abs(box.top - right.top) <= slack_px);
    RC_ASSERT(std::abs(box.right - right.right) <= slack_px);
    RC_ASSERT(std::abs(box.bottom - right.bottom) <= slack_px);
}

/// Four pixels from the upper left: red, green, blue, black; turned by quarters on the page.
std::string four_colours(Spot corner, double width, double height, int turn) {
    const std::array<std::string, 4> matrices{
        fmt::format("{} 0 0 {} {} {}", width, height, corner.x, corner.y),
        fmt::format("0 {} {} 0 {} {}", height, -width, corner.x + width, corner.y),
        fmt::format("{} 0 0 {} {} {}", -width, -height, corner.x + width, corner.y + height),
        fmt::format("0 {} {} 0 {} {}", -height, width, corner.x, corner.y + height)};
    return fmt::format(
        "q {} cm BI /W 2 /H 2 /CS /RGB /BPC 8 /F /AHx ID FF000000FF000000FF000000> EI Q\n",
        matrices.at(static_cast<std::size_t>(turn)));
}

RC_GTEST_PROP(PdfPage, PicturesAndWordsAreWhereTheyAreDrawn, ()) {
    const Frame frame = some_frame();
    const Box& crop = frame.crop;
    const double wide = crop.right - crop.left;
    const double high = crop.top - crop.bottom;
    // The picture at the top, a line below it, words at the bottom.
    const double picture_width = whole(60, 300);
    const double picture_height = whole(60, 150);
    const Spot corner{crop.left + whole(5, static_cast<int>(wide - picture_width) - 5),
                      crop.top - picture_height - whole(5, 30)};
    const int turn = whole(0, 3);
    const Spot words{crop.left + whole(5, 100), crop.bottom + whole(10, 100)};
    const int words_turn = whole(0, 1);
    const std::string matrix = words_turn == 0 ? "1 0 0 1" : "0 1 -1 0";
    const double line_y = crop.bottom + 0.6 * high;
    const std::string content =
        four_colours(corner, picture_width, picture_height, turn) +
        fmt::format("0.8 0 0.8 RG 4 w {} {} m {} {} l S\n", crop.left + 20.0, line_y,
                    crop.left + 200.0, line_y) +
        fmt::format("0 0.6 0.6 rg BT /F 30 Tf {} {} {} Tm (Some words) Tj ET\n", matrix,
                    words.x + 40.0, words.y);
    const auto page = decode_page(written_pdf({{content, text_of(frame)}}), {1, 90});
    RC_ASSERT(page.has_value());
    const Picture& picture = page->picture;

    RC_ASSERT(page->figures.size() == 1U);
    const Spot a = pixel_of(frame, picture, corner);
    const Spot b = pixel_of(frame, picture, {corner.x + picture_width, corner.y + picture_height});
    const auto px = [](double value) { return static_cast<std::uint16_t>(std::lround(value)); };
    expect_near(page->figures[0].box,
                {px(std::min(a.x, b.x)), px(std::min(a.y, b.y)), px(std::max(a.x, b.x)),
                 px(std::max(a.y, b.y))},
                2);
    // Each quarter of the box shows the colour that is drawn there.
    const std::array<Colour, 4> colours{{{0, 0, 255}, {0, 255, 0}, {255, 0, 0}, {0, 0, 0}}};
    const std::array<Spot, 4> centres{{{0.25, 0.75}, {0.75, 0.75}, {0.25, 0.25}, {0.75, 0.25}}};
    for (std::size_t i = 0; i < colours.size(); ++i) {
        Spot c = centres.at(i);
        for (int k = 0; k < turn; ++k) c = {1.0 - c.y, c.x};
        const Spot where = pixel_of(
            frame, picture, {corner.x + c.x * picture_width, corner.y + c.y * picture_height});
        RC_ASSERT(is_near(at(picture, where), colours.at(i)));
    }

    RC_ASSERT(page->told.labels.size() == 1U);
    RC_ASSERT(page->told.labels[0].text == "Some words");
    RC_ASSERT(page->words.size() == 2U);
    WordBox both = page->words[0];
    both = {std::min(both.left, page->words[1].left), std::min(both.top, page->words[1].top),
            std::max(both.right, page->words[1].right),
            std::max(both.bottom, page->words[1].bottom)};
    const WordBox painted =
        bounds_of(picture, [](const Colour& c) { return c[2] < 120 && c[1] > 120 && c[0] > 120; });
    expect_near(both, painted, 3);
    const Position label = page->told.labels[0].place;
    const double label_x = label.x / page->told.area.width_m * picture.width + picture.width / 2.0;
    const double label_y =
        picture.height / 2.0 - label.y / page->told.area.height_m * picture.height;
    RC_ASSERT(label_x > painted.left && label_x < painted.right);
    RC_ASSERT(label_y > painted.top && label_y < painted.bottom);
}

TEST(PdfPage, AnImageThatIsTurnedByAnyAngleIsInItsBox) {
    // 100 by 50 points, turned by 30 degrees about the lower left corner.
    const auto page = decode_page(
        written_pdf(
            {{"q 86.6 50 -25 43.3 200 300 cm BI /W 1 /H 1 /CS /G /BPC 8 /F /AHx ID 40> EI Q"}}),
        {1, 72});
    ASSERT_TRUE(page.has_value());
    ASSERT_EQ(page->figures.size(), 1U);
    const WordBox& box = page->figures[0].box;
    EXPECT_NEAR(box.left, 175, 2);
    EXPECT_NEAR(box.right, 286.6, 2);
    EXPECT_NEAR(box.top, 800 - 393.3, 2);
    EXPECT_NEAR(box.bottom, 500, 2);
}

TEST(PdfPage, OfAnImageThatIsClippedOnlyWhatShowsIsThePicture) {
    const auto page = decode_page(
        written_pdf({{"q 100 300 80 60 re W n q 300 0 0 300 50 200 cm BI /W 1 /H 1 /CS /G /BPC 8 "
                      "/F /AHx ID 40> EI Q Q"}}),
        {1, 72});
    ASSERT_TRUE(page.has_value());
    ASSERT_EQ(page->figures.size(), 1U);
    const WordBox box{100, 440, 180, 500};
    EXPECT_NEAR(page->figures[0].box.left, box.left, 1);
    EXPECT_NEAR(page->figures[0].box.top, box.top, 1);
    EXPECT_NEAR(page->figures[0].box.right, box.right, 1);
    EXPECT_NEAR(page->figures[0].box.bottom, box.bottom, 1);
}

TEST(PdfPage, EverySizeOfPageServesTheHand) {
    struct Row {
        const char* box;
        int least_px;
        int most_px;
    };

    for (const Row& row :
         {Row{"/MediaBox [0 0 40 30]", 1190, 1210}, Row{"/MediaBox [0 0 595 842]", 1740, 1770},
          Row{"/MediaBox [0 0 2384 3370]", 3590, 3610},
          Row{"/MediaBox [0 0 100 100] /UserUnit 8.42", 1740, 1770},
          Row{"/MediaBox [0 0 14400 14400]", 3590, 3610}}) {
        const auto page = decode_page(written_pdf({{"1 1 10 10 re S", row.box}}));
        ASSERT_TRUE(page.has_value()) << row.box;
        const int longer = std::max(page->picture.width, page->picture.height);
        EXPECT_GE(longer, row.least_px) << row.box;
        EXPECT_LE(longer, row.most_px) << row.box;
        EXPECT_EQ(page->dpi, 150) << "as ordered, so that a finer order is finer";
    }
}

}  // namespace
}  // namespace touchline
