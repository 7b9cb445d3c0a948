// Tests VI-5: everything spoken has a caption, and every short sound a sign.
#include "app/screen/captions.h"

#include "app/screen/canvas.h"
#include "audio-cues/words/language.h"
#include "tests/app/screen/probes.h"
#include "tests/app/screen/sample_screens.h"

#include <utility>

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
                    const Rect band = arrange(w, h, sizes, false).captions;
                    const CaptionLayout layout =
                        lay_out_caption(probe.context(), "One word.", band, h, sizes);
                    const SignLine line =
                        sign_line(probe.context(), layout, stretched(words), language);
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
                probe.context(), spoken, arrange(800, 600, sizes, false).captions, 600, sizes);
            std::string words;
            for (const SheetPage& page : layout.pages) {
                for (const PlacedPhrase& placed : page.phrases) {
                    words += placed.phrase.text;
                    EXPECT_LE(line_width_px(probe.context(), {sizes.cap_px}, placed.phrase.text),
                              layout.text.width);
                    EXPECT_LE(placed.at.y + line_height_px(sizes.cap_px), layout.text.height + 0.5);
                }
            }
            EXPECT_EQ(without_spaces(words), without_spaces(spoken));
        }
    }
}

}  // namespace
}  // namespace touchline
