#include "tests/app/screen/golden_sheet.h"

#include "app/visit/proxy_radius.h"
#include "audio-cues/words/language.h"
#include "tests/app/documents/gallery/pictures.h"
#include "tests/app/screen/contact_sheet.h"
#include "tests/app/screen/every_screen.h"
#include "tests/app/screen/probes.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

namespace touchline {
namespace {

const TactileMap& map_of(const std::string& name) {
    static const std::vector<ShippedPicture> pictures = shipped_pictures();
    const auto at = std::ranges::find(pictures, name, &ShippedPicture::name);
    if (at == pictures.end()) throw std::runtime_error("no picture " + name);
    return at->map;
}

ShownScene fish() {
    auto scene = build_scene(map_of("06-fish"), CurveOptions{}, proxy_radius_m);
    if (!scene) throw std::runtime_error(scene.error().line);
    return {std::make_shared<const Scene>(std::move(*scene)), nullptr};
}

/// Grey steps, which show where the camera's picture lies.
std::shared_ptr<const Canvas> grey_steps() {
    constexpr int width = 320;
    constexpr int height = 240;
    std::vector<std::uint8_t> bgr(3 * width * height);
    for (std::size_t i = 0; i < bgr.size(); ++i)
        bgr[i] = static_cast<std::uint8_t>(i / 3 % width / 40 * 36);
    return std::make_shared<const Canvas>(canvas_of_frame(bgr, width, height, 3 * width));
}

LiveContent live_content() {
    LiveFacts facts;
    facts.title = "A fish";
    facts.coarsest_level = 6;
    facts.hand_words = "mouse, no device";
    LatenessBars bars;
    bars.ticks = {287'439, 405'188, 62'033, 27'620, 2'888, 543};
    return {describe(facts, HandState{}, ForceStatus{}, Language()), true, bars};
}

/// A gallery with a small picture of each.
ScreenContent gallery_content(const GoldenLook& look) {
    SpokenScreen screen{"Gallery", "", {}, 2, ScreenView::none, {"What to feel"}};
    std::vector<LineDrawingPtr> pictures;
    for (const char* name : {"02-star", "05-key", "06-fish", "07-house", "11-cat", "13-boat"}) {
        const TactileMap& map = map_of(name);
        screen.items.push_back({0, ItemRole::choice, map.title, "easy", ""});
        pictures.push_back(std::make_shared<const LineDrawing>(line_drawing(map)));
    }
    screen.items.push_back({0, ItemRole::choice, "Back", "", ""});
    pictures.emplace_back();
    ScreenContent content = drawn_content(screen, Language(), look);
    content.pictures = std::move(pictures);
    return content;
}

ScreenContent live_screen(const GoldenLook& look) {
    ScreenContent content =
        drawn_content(sample_screens(Language()).at(2).screen, Language(), look);
    content.live = live_content();
    return content;
}

ScreenContent curtain(const GoldenLook& look) {
    ScreenContent content =
        drawn_content(sample_screens(Language()).front().screen, Language(), look);
    content.is_curtain = true;
    return content;
}

std::vector<std::pair<std::string, ScreenContent>> golden_screens(const GoldenLook& look) {
    std::vector<std::pair<std::string, ScreenContent>> screens{
        {"gallery with pictures", gallery_content(look)},
        {"live view", live_screen(look)},
        {"screen off", curtain(look)}};
    for (const NamedScreen& each : every_screen(Language()))
        screens.emplace_back(each.name, drawn_content(each.screen, Language(), look));
    return screens;
}

}  // namespace

ScreenContent drawn_content(const SpokenScreen& screen, const Language& language,
                            const GoldenLook& look) {
    static const ShownScene shown = fish();
    static const std::shared_ptr<const Canvas> preview = grey_steps();
    ScreenContent content;
    content.screen = screen;
    content.language = language;
    content.caption = spoken_screen(screen, language);
    content.sound_sign = words_of(Cue::area_entered, language);
    content.text_size = look.size;
    content.palette = look.palette;
    content.shown = shown;
    content.preview = preview;
    return content;
}

std::string golden_file(const GoldenLook& look) {
    constexpr std::array palettes{"white-on-black", "black-on-white", "yellow-on-black",
                                  "low-glare-grey"};
    constexpr std::array sizes{"normal", "large", "larger", "largest"};
    return std::string(palettes.at(static_cast<std::size_t>(look.palette))) + '-' +
           sizes.at(static_cast<std::size_t>(look.size)) + ".png";
}

Canvas golden_sheet(const GoldenLook& look) {
    std::vector<Thumbnail> screens;
    for (const auto& [name, content] : golden_screens(look)) {
        ScreenLayers layers(usual_cap_px);
        layers.update(content, look.width_px, look.height_px, 0);
        screens.push_back({name, composed(layers, look.width_px, look.height_px)});
    }
    return contact_sheet(screens, golden_columns, golden_width_px);
}

}  // namespace touchline
