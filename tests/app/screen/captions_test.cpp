// Tests VI-5: everything spoken has a caption, and every short sound a sign.
#include "app/screen/captions.h"

#include "app/screen/canvas.h"
#include "audio-cues/words/language.h"
#include "tests/app/screen/every_screen.h"
#include "tests/app/screen/probes.h"
#include "tests/app/screen/sample_screens.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(Captions, VI5_EverySoundHasASignInEveryLanguageAtEverySize) {
    const Canvas probe(1, 1);
    for (const Language& language : every_language()) {
        for (std::size_t cue = 0; cue < cue_count; ++cue) {
            const std::string words = words_of(static_cast<Cue>(cue), language);
            ASSERT_FALSE(words.empty());
            for (const TextSize size : {TextSize::normal, TextSize::largest}) {
                for (const auto& [w, h] : {std::pair{1280, 800}, {1080, 1920}, {800, 600}}) {
                    const TextSizes sizes = text_sizes(size, usual_cap_px, w, h);
                    const Rect band = arrange(w, h, sizes, {}).captions;
                    const CaptionLayout layout =
                        lay_out_caption(probe.context(), "One word.", band, sizes, language);
                    const SignLine line = sign_line(probe.context(), layout, stretched(words));
                    EXPECT_GE(line.style.cap_px, sizes.normal_px - 1e-9) << words << ' ' << w;
                    EXPECT_LE(line.at.x + line.width_px, layout.foot.x + layout.foot.width);
                }
            }
        }
    }
}

TEST(Captions, VI5_EverythingSpokenStandsOnSomePage) {
    const Canvas probe(1, 1);
    for (const Language& language : every_language()) {
        for (const NamedScreen& each : sample_screens(language)) {
            const std::string spoken = spoken_screen(each.screen, language);
            const TextSizes sizes = text_sizes(TextSize::largest, usual_cap_px, 800, 600);
            const CaptionLayout layout = lay_out_caption(
                probe.context(), spoken, arrange(800, 600, sizes, {}).captions, sizes, language);
            const LineStyle style = layout.text.style;
            EXPECT_GE(style.cap_px, sizes.normal_px);
            std::string words;
            for (const SheetPage& page : layout.text.pages) {
                for (const PlacedPhrase& placed : page.phrases) {
                    words += placed.phrase.text;
                    EXPECT_LE(line_width_px(probe.context(), style, placed.phrase.text),
                              layout.text.rect.width);
                    EXPECT_LE(placed.at.y + line_height_px(style.cap_px),
                              layout.text.rect.height + 0.5);
                }
            }
            EXPECT_EQ(without_spaces(words), without_spaces(spoken));
        }
    }
}

TEST(Captions, ASettingThatIsSaidKeepsItsEndAtTheLargestSize) {
    const Canvas probe(1, 1);
    const TextSizes sizes = text_sizes(TextSize::largest, usual_cap_px, 1280, 720);
    const CaptionLayout layout =
        lay_out_caption(probe.context(), "Size of letters, largest, setting, 7 of 12",
                        arrange(1280, 720, sizes, {}).captions, sizes, {});
    EXPECT_EQ(layout.text.pages.size(), 1U);
}

/// A second page or line with nothing but "5" tells nobody what there are five of.
TEST(Captions, APlaceInAListIsNotTornApart) {
    const Canvas probe(1, 1);
    for (const Language& language : every_language()) {
        for (const auto& [w, h] : {std::pair{1280, 720}, {1920, 1080}}) {
            const TextSizes sizes = text_sizes(TextSize::normal, usual_cap_px, w, h);
            const Rect band = arrange(w, h, sizes, {}).captions;
            for (const NamedScreen& each : every_screen(language)) {
                if (!each.screen.focus) continue;
                const std::string spoken = spoken_screen(each.screen, language);
                const std::string place =
                    without_spaces(told_place(each.screen, *each.screen.focus, language));
                const CaptionLayout layout =
                    lay_out_caption(probe.context(), spoken, band, sizes, language);
                const std::string& last = layout.text.pages.back().phrases.back().phrase.text;
                EXPECT_TRUE(without_spaces(last).ends_with(place)) << spoken;
            }
        }
    }
}

TEST(KeyLegend, ShowsTheKeysThatDoSomething) {
    SpokenScreen screen{"A title", "", {}, {}, ScreenView::none};
    const auto roles = [&](SwitchUse switches) {
        std::vector<std::optional<KeyRole>> shown;
        for (const LegendKey& key : legend_of(screen, switches, {})) shown.push_back(key.role);
        return shown;
    };
    using Roles = std::vector<std::optional<KeyRole>>;
    EXPECT_EQ(roles(SwitchUse::none), (Roles{KeyRole::back, KeyRole::repeat, KeyRole::help}));
    screen.items.push_back({0, ItemRole::choice, "One", "", ""});
    screen.focus = 0;
    EXPECT_EQ(roles(SwitchUse::none),
              (Roles{KeyRole::back, KeyRole::repeat, KeyRole::select, KeyRole::help}));
    screen.items.push_back(screen.items.front());
    EXPECT_EQ(roles(SwitchUse::none), (Roles{KeyRole::up, KeyRole::down, KeyRole::back,
                                             KeyRole::repeat, KeyRole::select, KeyRole::help}));
    EXPECT_EQ(roles(SwitchUse::move_and_select), (Roles{KeyRole::down, KeyRole::select}));
    EXPECT_EQ(roles(SwitchUse::by_itself), (Roles{KeyRole::select}));
    screen.takes_any_key = true;
    EXPECT_EQ(roles(SwitchUse::none), (Roles{std::nullopt}));
    EXPECT_EQ(legend_of(screen, SwitchUse::none, {}).front().name, "Any key");
}

TEST(KeyLegend, FitsBesideTheSignInEveryLanguage) {
    const Canvas probe(1, 1);
    for (const Language& language : every_language()) {
        for (const auto& [w, h] : {std::pair{1280, 720}, {1920, 1080}}) {
            const TextSizes sizes = text_sizes(TextSize::largest, usual_cap_px, w, h);
            const CaptionLayout layout = lay_out_caption(
                probe.context(), "One word.", arrange(w, h, sizes, {}).captions, sizes, language);
            const bool has_names = layout.has_key_names;
            const double legend_px =
                legend_width_px(probe.context(), whole_legend(language), sizes);
            EXPECT_TRUE(!has_names || legend_px < layout.foot.width) << language.code() << w;
        }
    }
}

}  // namespace
}  // namespace touchline
