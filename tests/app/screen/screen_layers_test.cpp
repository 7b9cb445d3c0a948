// Measures what a screen looks like from its pixels: VI-1, VI-2, VI-3, VI-7.
#include "app/screen/screen_layers.h"

#include "tests/app/screen/contact_sheet.h"
#include "tests/app/screen/probes.h"
#include "tests/app/screen/sample_screens.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr int screen_width = 1280;
constexpr int screen_height = 800;
constexpr std::array palette_list{PaletteName::white_on_black, PaletteName::black_on_white,
                                  PaletteName::yellow_on_black, PaletteName::low_glare_grey};

ScreenContent list_content(PaletteName palette = {}, TextSize size = {}) {
    ScreenContent content;
    content.screen = sample_screens(Language()).front().screen;
    content.palette = palette;
    content.text_size = size;
    return content;
}

Canvas drawn(const ScreenContent& content) {
    ScreenLayers layers(usual_cap_px);
    layers.update(content, screen_width, screen_height, 0);
    return composed(layers, screen_width, screen_height);
}

/// Returns the rows of a part of a canvas that hold a colour, as first and one past the last.
std::pair<int, int> rows_with(const Canvas& canvas, const Rect& rect, Colour colour) {
    int first = -1;
    int last = -1;
    for (int y = static_cast<int>(rect.y); y < rect.y + rect.height; ++y) {
        for (int x = static_cast<int>(rect.x); x < rect.x + rect.width; ++x) {
            if (!is_near(colour_at(canvas, {x + 0.5, y + 0.5}), colour)) continue;
            if (first < 0) first = y;
            last = y;
            break;
        }
    }
    return {first, last + 1};
}

TEST(ScreenPixels, VI1_ACapitalIsAsHighAsTheAngleAsks) {
    for (const TextSize size :
         {TextSize::normal, TextSize::large, TextSize::larger, TextSize::largest}) {
        ScreenContent content = list_content({}, size);
        content.screen = {"H", "", {}, {}, ScreenView::none};
        const Canvas canvas = drawn(content);
        const auto [top, bottom] =
            rows_with(canvas, {0.0, 0.0, screen_width, 250.0}, white_on_black.text);
        const double wanted_px = usual_cap_px * cap_angle_deg(size) / cap_angle_deg({});
        EXPECT_NEAR(bottom - top, wanted_px, 1.5) << static_cast<int>(size);
    }
}

/// The most frequent colours of the canvas, most frequent first.
std::vector<Colour> main_colours(const Canvas& canvas) {
    std::map<std::tuple<int, int, int>, int> counts;
    for (int y = 0; y < canvas.height(); ++y) {
        for (int x = 0; x < canvas.width(); ++x) {
            const Colour c = colour_at(canvas, {x + 0.5, y + 0.5});
            const auto byte = [](double share) { return static_cast<int>(share * 255.0 + 0.5); };
            ++counts[{byte(c.red), byte(c.green), byte(c.blue)}];
        }
    }
    std::vector<std::pair<int, Colour>> sorted;
    for (const auto& [c, count] : counts)
        sorted.push_back(
            {count, {std::get<0>(c) / 255.0, std::get<1>(c) / 255.0, std::get<2>(c) / 255.0}});
    std::sort(sorted.begin(), sorted.end(),
              [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<Colour> colours;
    for (const auto& [count, colour] : sorted) colours.push_back(colour);
    return colours;
}

TEST(ScreenPixels, VI2_LettersHaveTheContrastOfTheirPalette) {
    for (const PaletteName name : palette_list) {
        ScreenContent content = list_content(name);
        content.screen.focus.reset();  // only letters are left
        content.caption = "Something is said here, in quite a few words, so that they count.";
        const std::vector<Colour> colours = main_colours(drawn(content));
        const double measured = contrast(colours.at(0), colours.at(1));
        const bool is_high = name == PaletteName::white_on_black ||  // includes the default
                             name == PaletteName::black_on_white;
        EXPECT_GE(measured, is_high ? 20.0 : 7.0) << static_cast<int>(name);
    }
}

/// Returns the lengths of runs along a row of pixels that contrast with the ground at least 3:1.
std::vector<int> runs_standing_out(const Canvas& canvas, int y, int from_x, int to_x,
                                   Colour ground) {
    std::vector<int> runs;
    bool is_in_run = false;
    for (int x = from_x; x < to_x; ++x) {
        const bool stands_out = contrast(colour_at(canvas, {x + 0.5, y + 0.5}), ground) >= 3.0;
        if (stands_out && !is_in_run) runs.push_back(0);
        if (stands_out) ++runs.back();
        is_in_run = stands_out;
    }
    return runs;
}

TEST(ScreenPixels, VI3_TheFocusIsAThickFrameAndAPointerThatStandOut) {
    const Canvas probe(1, 1);
    for (const PaletteName name : palette_list) {
        const ScreenContent content = list_content(name);
        const TextSizes sizes = text_sizes({}, usual_cap_px, screen_width, screen_height);
        const SheetLayout layout =
            lay_out_sheet(probe.context(), content.screen,
                          arrange(screen_width, screen_height, sizes, {}).sheet, sizes, false);
        const SheetFace face = face_of(layout, content.screen, {});
        ASSERT_TRUE(face.focus);
        const Canvas canvas = drawn(content);
        const Colour ground = palette_of(name).background;
        const int left = static_cast<int>(face.focus->x);
        const int middle = static_cast<int>(face.focus->y + face.focus->height / 2.0);
        const auto letters_px = static_cast<int>(1.4 * sizes.cap_px);  // the letters do not reach
                                                                       // so far
        const auto with = runs_standing_out(canvas, middle, left, left + letters_px, ground);
        ASSERT_EQ(with.size(), 2U) << static_cast<int>(name);  // frame and pointer
        EXPECT_GE(with[0], 4);
        EXPECT_GE(with[1], 10);
        const int other = middle + static_cast<int>(face.focus->height);
        EXPECT_TRUE(runs_standing_out(canvas, other, left, left + letters_px, ground).empty());
    }
}

TEST(ScreenPixels, VI3_TheFocusShowsWithoutColour) {
    ScreenContent content = list_content();
    const Canvas one = drawn(content);
    content.screen.focus = 2;
    const Canvas two = drawn(content);
    int differing = 0;
    for (int y = 0; y < screen_height; ++y) {
        for (int x = 0; x < screen_width; ++x) {
            const PixelPoint p{x + 0.5, y + 0.5};
            if (contrast(colour_at(one, p), colour_at(two, p)) >= 3.0) ++differing;
        }
    }
    EXPECT_GT(differing, 10'000);
}

TEST(ScreenPixels, ASoundHasAShapeAndWords) {
    ScreenContent content = list_content();
    const Canvas silent = drawn(content);
    content.sound_sign = "i";
    const Canvas sounding = drawn(content);
    const TextSizes sizes = text_sizes({}, usual_cap_px, screen_width, screen_height);
    const Rect band = arrange(screen_width, screen_height, sizes, {}).captions;
    const auto first = [&](const Canvas& canvas) {
        const Rect corner{screen_width - 100.0, band.y + 4.0, 100.0, band.height - 4.0};
        return rows_with(canvas, corner, white_on_black.text).first;
    };
    EXPECT_LT(first(silent), 0);
    EXPECT_GT(first(sounding), band.y);
}

TEST(ScreenPixels, KeysStandThereWhileTheyDoSomething) {
    const auto has_keys = [](const ScreenContent& content) {
        const TextSizes sizes = text_sizes({}, usual_cap_px, screen_width, screen_height);
        const Rect band = arrange(screen_width, screen_height, sizes, {}).captions;
        const Rect below_the_rim{0.0, band.y + 4.0, 300.0, band.height - 4.0};
        return rows_with(drawn(content), below_the_rim, white_on_black.text).first >= 0;
    };
    ScreenContent content = list_content();
    EXPECT_TRUE(has_keys(content));
    content.has_ended = true;
    EXPECT_FALSE(has_keys(content));
}

bool is_same_everywhere(const Canvas& a, const Canvas& b) {
    for (int y = 0; y < screen_height; ++y)
        for (int x = 0; x < screen_width; ++x)
            if (!is_near(colour_at(a, {x + 0.5, y + 0.5}), colour_at(b, {x + 0.5, y + 0.5})))
                return false;
    return true;
}

TEST(Curtain, ShowsHowToComeBackAndNothingElseWhateverThereIsAndFallsAtOnce) {
    ScreenLayers layers(usual_cap_px);
    ScreenContent content = list_content(PaletteName::black_on_white);
    content.caption = "Something private";
    content.sound_sign = "corner";
    layers.update(content, screen_width, screen_height, 0);
    content.screen.focus = 0;
    layers.update(content, screen_width, screen_height, 1);
    content.is_curtain = true;
    layers.update(content, screen_width, screen_height, 2);  // a third change within one second
    const Canvas fallen = composed(layers, screen_width, screen_height);
    const Rect ink = ink_of(fallen);
    EXPECT_GT(ink.width, 200.0);
    EXPECT_LT(ink.height, 2.0 * usual_cap_px);  // one line
    EXPECT_GT(ink.x, 0.4 * usual_cap_px) << "a screen's rim may hide its first pixels";
    content.caption = "More of it";
    content.screen.title = "Another screen";
    for (int i = 0; i < 100; ++i)
        layers.update(content, screen_width, screen_height, i * one_second_ns / 10 + 3);
    EXPECT_TRUE(is_same_everywhere(fallen, composed(layers, screen_width, screen_height)));
    EXPECT_FALSE(layers.has_marks());
    content.is_curtain = false;
    layers.update(content, screen_width, screen_height, 20 * one_second_ns);
    EXPECT_GT(ink_of(composed(layers, screen_width, screen_height)).height, 300.0);
}

TEST(LiveView, LeavesMenuAndCaptionVisibleAndFollowsItsNumbers) {
    ScreenLayers layers(usual_cap_px);
    ScreenContent content = list_content();
    content.screen.view = ScreenView::picture;
    content.live = LiveContent{{"A fish", {{"Force", "0.6 N"}}, ""}, false, LatenessBars{}};
    layers.update(content, screen_width, screen_height, 0);
    EXPECT_GT(layers.panel().rect.width, 0.0);
    EXPECT_GT(layers.sheet().rect.width, 0.0);
    EXPECT_GT(layers.captions().rect.width, 0.0);
    EXPECT_TRUE(layers.has_marks());
    const std::uint64_t version = layers.panel().version;
    content.live->status.lines.front().value = "0.7 N";
    layers.update(content, screen_width, screen_height, one_second_ns);
    EXPECT_GT(layers.panel().version, version);
    content.live.reset();
    layers.update(content, screen_width, screen_height, 3 * one_second_ns);
    EXPECT_EQ(layers.panel().rect.width, 0.0);
}

}  // namespace
}  // namespace touchline
