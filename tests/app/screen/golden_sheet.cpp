#include "tests/app/screen/golden_sheet.h"

#include "app/visit/proxy_radius.h"
#include "audio-cues/words/language.h"
#include "tests/app/documents/gallery/pictures.h"
#include "tests/app/screen/contact_sheet.h"
#include "tests/app/screen/every_screen.h"
#include "tests/app/screen/probes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace touchline {
namespace {

const TactileMap& map_of(std::string_view name) {
    static const std::vector<ShippedPicture> pictures = shipped_pictures();
    const auto at = std::ranges::find(pictures, name, &ShippedPicture::name);
    if (at == pictures.end()) throw std::runtime_error("no picture " + std::string(name));
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

ScreenContent visit_content(VisitScreen which, const GoldenLook& look) {
    return drawn_content(visit_screen(which, Language()).value(), Language(), look);
}

ScreenContent picture_content(const GoldenLook& look) {
    SpokenScreen screen = visit_screen(VisitScreen::picture, Language()).value();
    screen.title = "A fish";
    return drawn_content(screen, Language(), look);
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

std::vector<NamedContent> every_content(const Language& language, const GoldenLook& look) {
    std::vector<NamedContent> contents{{"gallery with pictures", gallery_content(look)},
                                       {"live view", live_screen(look)},
                                       {"screen off", curtain(look)}};
    for (const NamedScreen& each : every_screen(language))
        contents.push_back({each.name, drawn_content(each.screen, language, look)});
    return contents;
}

Canvas drawn_screen(const ScreenContent& content, const GoldenLook& look) {
    ScreenLayers layers(usual_cap_px);
    layers.update(content, look.width_px, look.height_px, 0);
    return composed(layers, look.width_px, look.height_px);
}

std::vector<GoldenLook> golden_looks() {
    std::vector<GoldenLook> looks;
    for (const auto& [width_px, height_px] : {std::pair{1280, 720}, {1920, 1080}})
        for (std::size_t palette = 0; palette < palette_count; ++palette)
            for (std::size_t size = 0; size < text_size_count; ++size)
                looks.push_back({static_cast<TextSize>(size), static_cast<PaletteName>(palette),
                                 width_px, height_px});
    return looks;
}

std::string golden_file(const GoldenLook& look) {
    constexpr std::array palettes{"white-on-black", "black-on-white", "yellow-on-black",
                                  "low-glare-grey"};
    constexpr std::array sizes{"normal", "large", "larger", "largest"};
    return fmt::format("{}-{}-{}x{}.png", palettes.at(static_cast<std::size_t>(look.palette)),
                       sizes.at(static_cast<std::size_t>(look.size)), look.width_px,
                       look.height_px);
}

GreyPicture grey_of(const Canvas& canvas) {
    const Picture picture = picture_of(canvas);
    GreyPicture grey{picture.width, picture.height, {}};
    for (std::size_t i = 0; i < picture.bgr.size(); i += 3) {
        const int sum = picture.bgr[i] + picture.bgr[i + 1] + picture.bgr[i + 2];
        grey.grey.push_back(static_cast<std::uint8_t>(sum / 3));
    }
    return grey;
}

GoldenSheet golden_sheet(const GoldenLook& look) {
    const std::vector<NamedContent> contents = every_content(Language(), look);
    const int rows = (static_cast<int>(contents.size()) + golden_columns - 1) / golden_columns;
    const Canvas sheet(golden_columns * golden_width_px, rows * golden_height_px);
    GoldenSheet golden;
    for (int i = 0; const auto& [name, content] : contents) {
        const PixelPoint at{1.0 * golden_width_px * (i % golden_columns),
                            1.0 * golden_height_px * (i / golden_columns)};
        const double scale = 1.0 * golden_width_px / look.width_px;
        paint_at(sheet, drawn_screen(content, look), at, scale);
        golden.names.push_back(name);
        ++i;
    }
    golden.picture = grey_of(sheet);
    return golden;
}

Canvas key_screens() {
    constexpr int columns = 2;
    constexpr int width_px = 480;
    const GoldenLook usual;
    const GoldenLook largest{TextSize::largest, PaletteName::yellow_on_black};
    std::vector<Thumbnail> screens;
    const auto add = [&screens](const char* name, const ScreenContent& content,
                                const GoldenLook& look) {
        screens.push_back({name, drawn_screen(content, look)});
    };
    add("Nobody is here", visit_content(VisitScreen::attract, usual), usual);
    add("What to feel", visit_content(VisitScreen::choose, usual), usual);
    add("A list of the gallery", gallery_content(usual), usual);
    add("A picture that is felt", picture_content(usual), usual);
    add("The largest letters, in yellow", visit_content(VisitScreen::choose, largest), largest);
    add("For the staff: the state of the kiosk",
        drawn_content(staff_screen(OperatorPlace::status, Language()), Language(), usual), usual);
    return contact_sheet(screens, columns, width_px);
}

}  // namespace touchline
