#include "app/screen/staff_panel.h"

#include "app/screen/text.h"
#include "tests/app/screen/probes.h"

#include <array>

#include <gtest/gtest.h>

namespace touchline {
namespace {

Status full_status() {
    LiveFacts facts;
    facts.title = "A house with a garden";
    facts.coarsest_level = 6;
    facts.hand_words = "mouse, no device";
    return describe(facts, HandState{}, ForceStatus{}, Language());
}

TEST(Text, ACapitalIsAsHighAsAsked) {
    for (const double cap_px : {12.0, 27.0, 60.0}) {
        const Canvas canvas(400, 200);
        const std::array<TextRun, 1> runs{TextRun{"H"}};
        paint_text(canvas.context(), {10.0, 10.0}, 380.0, cap_px, runs);
        EXPECT_NEAR(ink_of(canvas).height, cap_px, 1.5) << cap_px;
    }
}

TEST(Text, LongTextIsWrappedNotCut) {
    const Canvas canvas(300, 1);
    const std::array<TextRun, 1> one{TextRun{"word"}};
    const std::array<TextRun, 1> many{TextRun{"word word word word word word word word word word"}};
    EXPECT_GT(text_height_px(canvas.context(), 280.0, 20.0, many),
              2.0 * text_height_px(canvas.context(), 280.0, 20.0, one));
}

TEST(Text, BytesThatAreNoTextAreDrawnAsReplacements) {
    const Canvas canvas(400, 100);
    const std::array<TextRun, 1> runs{TextRun{"\xff\xfe name.png", white_on_black.alert}};
    paint_text(canvas.context(), {10.0, 10.0}, 380.0, 20.0, runs);
    EXPECT_GT(ink_of(canvas).width, 20.0);
}

/// Expects ink to stay off the edge, so that nothing is cut off.
void expect_inside(const Canvas& canvas) {
    const Rect ink = ink_of(canvas);
    EXPECT_GT(ink.width, 0.0);
    EXPECT_GT(ink.x, 0.0);
    EXPECT_GT(ink.y, 0.0);
    EXPECT_LT(ink.x + ink.width, canvas.width());
    EXPECT_LT(ink.y + ink.height, canvas.height());
}

TEST(Panel, NothingIsCutOffOnAnyScreen) {
    constexpr std::array<std::array<int, 2>, 6> screens{
        {{1920, 1080}, {1280, 1024}, {1280, 720}, {1024, 768}, {800, 480}, {1080, 1920}}};
    for (const auto& [width, height] : screens) {
        const TextSizes sizes = text_sizes(TextSize::large, 27.0, width, height);
        const Rect panel = arrange(width, height, sizes, {true, true}).panel;
        const Canvas canvas(static_cast<int>(panel.width), static_cast<int>(panel.height));
        LiveContent live{full_status(), false, LatenessBars{}};
        live.status.message =
            "a-very-long-name-of-a-picture-on-a-stick.png: the file is cut short; copy it again";
        paint_live(canvas.context(), {0.0, 0.0, panel.width, panel.height}, live, sizes.cap_px,
                   white_on_black, {});
        expect_inside(canvas);
    }
}

TEST(Panel, HasTheSizeAskedForWhereThereIsRoom) {
    const Canvas canvas(614, 1080);
    const double used = paint_panel(canvas.context(), {0.0, 0.0, 614.0, 1080.0}, full_status(),
                                    26.5, black_on_white);
    EXPECT_EQ(used, 26.5);
}

}  // namespace
}  // namespace touchline
