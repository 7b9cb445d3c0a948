// Tests VI-6: nothing is cut off in any language, at any size, on any screen.
#include "app/screen/sheet.h"

#include "app/screen/captions.h"
#include "audio-cues/words/language.h"
#include "tests/app/screen/every_screen.h"
#include "tests/app/screen/probes.h"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr std::array<std::array<int, 2>, 4> screen_sizes{
    {{1280, 720}, {1920, 1080}, {1080, 1920}, {800, 600}}};
constexpr std::array text_size_list{TextSize::normal, TextSize::large, TextSize::larger,
                                    TextSize::largest};

bool is_inside(const Rect& inner, const Rect& outer) {
    constexpr double tolerance_px = 0.5;
    return inner.x >= outer.x - tolerance_px && inner.y >= outer.y - tolerance_px &&
           inner.x + inner.width <= outer.x + outer.width + tolerance_px &&
           inner.y + inner.height <= outer.y + outer.height + tolerance_px;
}

/// Returns the line's box, including its mark.
Rect box_of(const FaceLine& line) {
    const double mark_px = mark_room_px(line.mark, line.style.cap_px);
    return {line.at.x - mark_px, line.at.y, line.width_px + 2.0 * mark_px,
            line_height_px(line.style.cap_px)};
}

/// Joins all words of the pages.
std::string words_of(const std::vector<SheetPage>& pages) {
    std::string words;
    for (const SheetPage& page : pages) {
        for (const PlacedPhrase& placed : page.phrases) words += placed.phrase.text;
    }
    return without_spaces(words);
}

std::string words_of_items(const SpokenScreen& screen) {
    std::string words;
    for (const ScreenItem& item : screen.items) words += item.name + item.value;
    return without_spaces(words);
}

struct Case {
    std::string name;
    SpokenScreen screen;
    Language language;
};

/// Returns every screen in every language, plain and stretched by two fifths.
std::vector<Case> all_cases() {
    std::vector<Case> cases;
    for (const Language& language : every_language()) {
        for (const NamedScreen& each : sample_screens(language)) {
            if (each.screen.items.size() > 100 && language.code() != "de") continue;  // for speed
            cases.push_back({each.name + ' ' + language.code(), each.screen, language});
            cases.push_back(
                {each.name + " stretched " + language.code(), stretched(each.screen), language});
        }
    }
    return cases;
}

/// Expects every line, picture and frame of a pair of pages to lie where it belongs.
void expect_face_inside(const SheetFace& face, const SheetLayout& layout, const std::string& name) {
    for (const FaceLine& line : face.lines) {
        ASSERT_TRUE(is_inside(box_of(line), line.part)) << name << ": " << line.text;
        ASSERT_TRUE(is_inside(line.part, layout.rect)) << name << ": " << line.text;
    }
    for (const FacePicture& picture : face.pictures)
        ASSERT_TRUE(is_inside(picture.rect, layout.list.rect)) << name;
    if (!face.focus) return;
    ASSERT_TRUE(is_inside(*face.focus, layout.list.rect)) << name;
}

void expect_all_pages_inside(const SheetLayout& layout, const Case& each) {
    const std::size_t pages = std::max(layout.text.pages.size(), layout.list.pages.size());
    for (std::size_t i = 0; i < pages; ++i) {
        const SheetPages shown{std::min(i, layout.text.pages.size() - 1),
                               std::min(i, layout.list.pages.size() - 1)};
        const SheetFace face = face_of(layout, each.screen, shown);
        expect_face_inside(face, layout, each.name);
        if (testing::Test::HasFatalFailure()) return;
    }
}

bool do_overlap(const Rect& a, const Rect& b) {
    constexpr double tolerance_px = 0.5;
    return a.x + tolerance_px < b.x + b.width && b.x + tolerance_px < a.x + a.width &&
           a.y + tolerance_px < b.y + b.height && b.y + tolerance_px < a.y + a.height;
}

void expect_parts_apart(const SheetLayout& layout, const std::string& name) {
    const std::array parts{layout.text.rect, layout.text.bar, layout.list.rect, layout.list.bar};
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = i + 1; j < parts.size(); ++j)
            EXPECT_FALSE(do_overlap(parts[i], parts[j])) << name << ' ' << i << ' ' << j;
}

template <class Check>
void for_each_layout(const Check& check, const std::vector<Case>& cases = all_cases(),
                     std::span<const TextSize> sizes_tried = text_size_list) {
    const Canvas canvas(1, 1);
    for (const auto& [width, height] : screen_sizes) {
        for (const TextSize size : sizes_tried) {
            const TextSizes sizes = text_sizes(size, usual_cap_px, width, height);
            for (const Case& each : cases) {
                const Beside beside{each.screen.view != ScreenView::none, false};
                const bool has_pictures = each.screen.items.size() % 2 == 0;
                check(
                    lay_out_sheet(canvas.context(), each.screen,
                                  arrange(width, height, sizes, beside).sheet, sizes, has_pictures),
                    each);
                if (testing::Test::HasFatalFailure()) return;
            }
        }
    }
}

TEST(Sheet, VI6_NothingIsCutOffInAnyLanguageAtAnySizeOnAnyScreen) {
    for_each_layout([](const SheetLayout& layout, const Case& each) {
        expect_all_pages_inside(layout, each);
        expect_parts_apart(layout, each.name);
    });
}

/// Returns every screen as the kiosk itself makes it.
std::vector<Case> cases_of_the_kiosk() {
    std::vector<Case> cases;
    for (const Language& language : every_language())
        for (const NamedScreen& each : every_screen(language))
            cases.push_back({each.name + ' ' + language.code(), each.screen, language});
    return cases;
}

TEST(Sheet, VI6_NoScreenOfVisitorOrOperatorIsCutOffAtTheLargestSize) {
    const std::vector<Case> cases = cases_of_the_kiosk();
    EXPECT_GT(cases.size(), 4U * 50U);
    for_each_layout(
        [](const SheetLayout& layout, const Case& each) {
            expect_all_pages_inside(layout, each);
            expect_parts_apart(layout, each.name);
        },
        cases, std::array{TextSize::largest});
}

TEST(Sheet, VI6_EveryWordStandsOnSomePage) {
    for_each_layout([](const SheetLayout& layout, const Case& each) {
        EXPECT_EQ(words_of(layout.text.pages), without_spaces(each.screen.text)) << each.name;
        EXPECT_EQ(words_of(layout.list.pages), words_of_items(each.screen)) << each.name;
    });
}

TEST(Sheet, TheFocusIsAlwaysOnThePageShown) {
    for_each_layout([](const SheetLayout& layout, const Case& each) {
        SpokenScreen screen = each.screen;
        for (std::size_t i = 0; i < screen.items.size(); i += 1 + screen.items.size() / 10) {
            screen.focus = i;
            for (const std::int64_t time_ns :
                 {std::int64_t{0}, 3 * one_second_ns, 60 * one_second_ns}) {
                const SheetPages shown = sheet_pages(layout, i, time_ns, time_ns);
                EXPECT_TRUE(face_of(layout, screen, shown).focus) << each.name;
            }
        }
    });
}

/// Expects the box of a line to hold all its ink.
void expect_ink_inside(const Canvas& canvas, const std::string& text, double cap_px) {
    constexpr double rim_px = 6.0;
    const double width_px = line_width_px(canvas.context(), {cap_px, true}, text);
    const Canvas around(static_cast<int>(width_px + 2.0 * rim_px),
                        static_cast<int>(line_height_px(cap_px) + 2.0 * rim_px));
    paint_line(around.context(), {rim_px, rim_px}, {cap_px, true}, {1.0, 1.0, 1.0}, text);
    const Rect ink = ink_of(around);
    EXPECT_TRUE(ink.width == 0.0 ||
                is_inside(ink, {rim_px - 2.0, rim_px, width_px + 4.0, line_height_px(cap_px)}))
        << text << ": " << ink.y << " to " << ink.y + ink.height;
}

TEST(Sheet, InkStaysInTheBoxOfItsLine) {
    const Canvas canvas(1, 1);
    std::set<std::string> texts{"\xC3\x84\xC3\x89\xC3\x91\xC3\x85gjpqy|/()"};
    for (const Case& each : all_cases()) {
        texts.insert(each.screen.title);
        for (const ScreenItem& item : each.screen.items) texts.insert(item.name);
        if (texts.size() > 150) break;
    }
    for (const std::string& text : texts) expect_ink_inside(canvas, text, 20.0);
}

/// What a visitor can feel, as the kiosk offers it: seven things.
SpokenScreen choices() {
    SpokenScreen screen{
        "What to feel",
        "Hold the handle lightly. Begin with a practice shape, or choose a picture.",
        {},
        0,
        ScreenView::none};
    for (const char* name : {"Practice shape", "Gallery", "Your USB stick", "Camera", "Settings",
                             "Call staff", "Finish"})
        screen.items.push_back({0, ItemRole::choice, name, "", ""});
    return screen;
}

TEST(Sheet, SevenItemsFitOnePageOfTheSmallScreenWithAndWithoutPictures) {
    const Canvas canvas(1, 1);
    const TextSizes sizes = text_sizes(TextSize::normal, usual_cap_px, 1280, 720);
    for (const bool has_pictures : {false, true}) {
        const SheetLayout layout = lay_out_sheet(
            canvas.context(), choices(), arrange(1280, 720, sizes, {}).sheet, sizes, has_pictures);
        EXPECT_EQ(layout.text.pages.size(), 1U);
        EXPECT_EQ(layout.list.pages.size(), 1U);
    }
}

/// The frame of the focus hides no letter, and values stand in one column.
TEST(Sheet, AnItemsWordsEndBeforeItsFrame) {
    for_each_layout(
        [](const SheetLayout& layout, const Case& each) {
            const PagedPart& list = layout.list;
            const double least_px = 0.5 * layout.sizes.cap_px;
            for (std::size_t page = 0; page < list.pages.size(); ++page) {
                for (const FaceLine& line : face_of(layout, each.screen, {0, page}).lines) {
                    if (line.part != list.rect) continue;
                    const double end_px = line.at.x + line.width_px;
                    EXPECT_LE(end_px, list.rect.x + list.rect.width - list.inset_px - least_px)
                        << each.name << ": " << line.text;
                }
            }
        },
        cases_of_the_kiosk(), std::array{TextSize::normal, TextSize::largest});
}

TEST(Sheet, TrianglesStandOnlyWhereUpAndDownChangeTheValue) {
    SpokenScreen screen{"Settings", "", {}, 0, ScreenView::none};
    screen.items.push_back({0, ItemRole::setting, "Volume", "4 of 7", ""});
    const Canvas probe(1, 1);
    const TextSizes sizes;
    const Rect rect{0.0, 0.0, 800.0, 200.0};
    const SheetLayout layout = lay_out_sheet(probe.context(), screen, rect, sizes, false);
    const auto ink_after_value = [&] {
        const SheetFace face = face_of(layout, screen, {});
        const FaceLine& value = face.lines.back();
        const Canvas canvas(800, 200);
        paint_sheet(canvas.context(), layout, face, {}, white_on_black);
        const double middle_px = value.at.y + line_height_px(sizes.cap_px) / 2.0;
        const PixelPoint in_triangle{value.at.x + value.width_px + 0.35 * sizes.cap_px,
                                     middle_px - 0.3 * sizes.cap_px};
        return !is_black(colour_at(canvas, in_triangle));
    };
    EXPECT_FALSE(ink_after_value());
    screen.is_turning = true;
    EXPECT_TRUE(ink_after_value());
}

TEST(Sheet, TheLinesOfAPictureStandBeforeItsName) {
    const SpokenScreen screen = choices();
    const Canvas canvas(1280, 720);
    const TextSizes sizes = text_sizes(TextSize::normal, usual_cap_px, 1280, 720);
    const SheetLayout layout =
        lay_out_sheet(canvas.context(), screen, arrange(1280, 720, sizes, {}).sheet, sizes, true);
    const SheetFace face = face_of(layout, screen, {});
    ASSERT_EQ(face.pictures.size(), 7U);
    const auto drawing =
        std::make_shared<const LineDrawing>(LineDrawing{Area{}, {{{-0.05, 0.0}, {0.05, 0.0}}}});
    paint_sheet(canvas.context(), layout, face, {nullptr, drawing}, white_on_black);
    const auto middle = [&](std::size_t item) {
        const Rect& rect = face.pictures[item].rect;
        return colour_at(canvas, {rect.x + rect.width / 2.0, rect.y + rect.height / 2.0});
    };
    EXPECT_TRUE(is_black(middle(0)));
    EXPECT_FALSE(is_black(middle(1)));
}

TEST(LineDrawing, KeepsTheShapeWithFewPoints) {
    TactileMap map;
    Outline circle;
    circle.is_closed = true;
    for (int i = 0; i < 5000; ++i) {
        const double angle_rad = 2.0 * std::numbers::pi * i / 5000;
        circle.points.push_back({0.03 * std::cos(angle_rad), 0.03 * std::sin(angle_rad)});
    }
    map.outlines = {circle};
    const LineDrawing drawing = line_drawing(map);
    ASSERT_EQ(drawing.lines.size(), 1U);
    EXPECT_LT(drawing.lines.front().size(), 310U);
    EXPECT_GT(drawing.lines.front().size(), 200U);
    EXPECT_EQ(drawing.lines.front().front(), drawing.lines.front().back());
}

}  // namespace
}  // namespace touchline
