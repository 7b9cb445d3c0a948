// Tests VI-6: nothing is cut off in any language, at any size, on any screen.
#include "app/screen/sheet.h"

#include "app/screen/captions.h"
#include "audio-cues/words/language.h"
#include "tests/app/screen/every_screen.h"
#include "tests/app/screen/probes.h"

#include <array>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr std::array<std::array<int, 2>, 4> screen_sizes{
    {{1280, 800}, {1920, 1080}, {1080, 1920}, {800, 600}}};
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

/// Expects every line, mark and frame of a pair of pages to lie where it belongs.
void expect_face_inside(const SheetFace& face, const SheetLayout& layout, const std::string& name) {
    for (const FaceLine& line : face.lines) {
        ASSERT_TRUE(is_inside(box_of(line), line.part)) << name << ": " << line.text;
        ASSERT_TRUE(is_inside(line.part, layout.rect)) << name << ": " << line.text;
    }
    if (!face.focus) return;
    ASSERT_TRUE(is_inside(*face.focus, layout.list.rect)) << name;
}

void expect_all_pages_inside(cairo_t* cr, const SheetLayout& layout, const Case& each) {
    const std::size_t pages = std::max(layout.text.pages.size(), layout.list.pages.size());
    for (std::size_t i = 0; i < pages; ++i) {
        const SheetPages shown{std::min(i, layout.text.pages.size() - 1),
                               std::min(i, layout.list.pages.size() - 1)};
        const SheetFace face = face_of(cr, layout, each.screen, shown, each.language);
        expect_face_inside(face, layout, each.name);
        if (testing::Test::HasFatalFailure()) return;
    }
}

void expect_parts_apart(const SheetLayout& layout, const std::string& name) {
    const PagedPart& text = layout.text;
    const PagedPart& list = layout.list;
    EXPECT_GE(text.marks.y + 0.5, text.rect.y + text.rect.height) << name;
    if (list.rect.height <= 0.0) return;
    EXPECT_GE(list.rect.y + 0.5, text.marks.y + text.marks.height) << name;
    EXPECT_GE(list.marks.y + 0.5, list.rect.y + list.rect.height) << name;
}

template <class Check>
void for_each_layout(const Check& check, const std::vector<Case>& cases = all_cases(),
                     std::span<const TextSize> sizes_tried = text_size_list) {
    const Canvas canvas(1, 1);
    for (const auto& [width, height] : screen_sizes) {
        for (const TextSize size : sizes_tried) {
            const TextSizes sizes = text_sizes(size, usual_cap_px, width, height);
            for (const Case& each : cases) {
                const bool has_picture = each.screen.view != ScreenView::none;
                const Arrangement arrangement = arrange(width, height, sizes, has_picture);
                const SheetLayout layout = lay_out_sheet(canvas.context(), each.screen,
                                                         arrangement.sheet, sizes, each.language);
                check(canvas.context(), layout, each);
                if (testing::Test::HasFatalFailure()) return;
            }
        }
    }
}

TEST(Sheet, VI6_NothingIsCutOffInAnyLanguageAtAnySizeOnAnyScreen) {
    for_each_layout([](cairo_t* cr, const SheetLayout& layout, const Case& each) {
        expect_all_pages_inside(cr, layout, each);
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
        [](cairo_t* cr, const SheetLayout& layout, const Case& each) {
            expect_all_pages_inside(cr, layout, each);
            expect_parts_apart(layout, each.name);
        },
        cases, std::array{TextSize::largest});
}

TEST(Sheet, VI6_EveryWordStandsOnSomePage) {
    for_each_layout([](cairo_t*, const SheetLayout& layout, const Case& each) {
        EXPECT_EQ(words_of(layout.text.pages), without_spaces(each.screen.title + each.screen.text))
            << each.name;
        EXPECT_EQ(words_of(layout.list.pages), words_of_items(each.screen)) << each.name;
    });
}

TEST(Sheet, TheFocusIsAlwaysOnThePageShown) {
    for_each_layout([](cairo_t* cr, const SheetLayout& layout, const Case& each) {
        SpokenScreen screen = each.screen;
        for (std::size_t i = 0; i < screen.items.size(); i += 1 + screen.items.size() / 10) {
            screen.focus = i;
            for (const std::int64_t time_ns :
                 {std::int64_t{0}, 3 * one_second_ns, 60 * one_second_ns}) {
                const SheetPages shown = sheet_pages(layout, i, time_ns, time_ns);
                EXPECT_TRUE(face_of(cr, layout, screen, shown, each.language).focus) << each.name;
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

TEST(Sheet, AListFitsOnePageWhereThereIsRoom) {
    const Canvas canvas(1, 1);
    const Language english;
    const TextSizes sizes = text_sizes(TextSize::normal, usual_cap_px, 1920, 1080);
    const Arrangement arrangement = arrange(1920, 1080, sizes, false);
    const SheetLayout layout =
        lay_out_sheet(canvas.context(), sample_screens(english).front().screen, arrangement.sheet,
                      sizes, english);
    EXPECT_EQ(layout.text.pages.size(), 1U);
    EXPECT_EQ(layout.list.pages.size(), 1U);
}

}  // namespace
}  // namespace touchline
