// Writes every screen in every language as one picture, for viewing.
#include "app/documents/decode/picture.h"
#include "audio-cues/words/words_of.h"
#include "tests/app/screen/contact_sheet.h"
#include "tests/app/screen/every_screen.h"
#include "tests/app/screen/probes.h"

#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace touchline {
namespace {

struct SheetOrder {
    std::string file;
    int width_px = 1920;
    int height_px = 1080;
    TextSize size = TextSize::largest;
    PaletteName palette = PaletteName::white_on_black;
};

/// Grey steps, which show where a picture lies.
std::shared_ptr<const Canvas> grey_steps() {
    constexpr int width = 320;
    constexpr int height = 240;
    std::vector<std::uint8_t> bgr(3 * width * height);
    for (std::size_t i = 0; i < bgr.size(); ++i)
        bgr[i] = static_cast<std::uint8_t>(i / 3 % width / 40 * 36);
    return std::make_shared<const Canvas>(canvas_of_frame(bgr, width, height, 3 * width));
}

ScreenContent content_of(const SpokenScreen& screen, const Language& language,
                         const SheetOrder& order) {
    ScreenContent content;
    content.screen = screen;
    content.caption = spoken_screen(screen, language);
    content.sound_sign = words_of(Cue::area_entered, language);
    content.text_size = order.size;
    content.palette = order.palette;
    content.language = language;
    content.shown.picture = content.preview = grey_steps();
    return content;
}

/// Adds `screens` in one language.
void add_screens(std::vector<Thumbnail>& thumbnails, const std::vector<NamedScreen>& screens,
                 const Language& language, const SheetOrder& order) {
    for (const NamedScreen& each : screens) {
        ScreenLayers layers(usual_cap_px);
        layers.update(content_of(each.screen, language, order), order.width_px, order.height_px, 0);
        thumbnails.push_back({fmt::format("{}, {}", each.name, language.code()),
                              composed(layers, order.width_px, order.height_px)});
    }
}

int write_sheet(const SheetOrder& order) {
    std::vector<Thumbnail> thumbnails;
    constexpr int columns = 8;
    for (const Language& language : every_language()) {
        add_screens(thumbnails, every_screen(language), language, order);
    }
    constexpr int thumbnail_px = 480;
    const auto done =
        write_png(order.file, picture_of(contact_sheet(thumbnails, columns, thumbnail_px)));
    if (done) return 0;
    fmt::print(stderr, "{}\n", done.error().line);
    return 1;
}

}  // namespace
}  // namespace touchline

/// Usage: screen_sheet OUT.png [WIDTH HEIGHT [SIZE 0 ... 3 [PALETTE 0 ... 3]]]
int main(int count, char** words) {
    using namespace touchline;
    if (count < 2) {
        fmt::print(stderr, "usage: screen_sheet OUT.png [WIDTH HEIGHT [SIZE [PALETTE]]]\n");
        return 2;
    }
    SheetOrder order;
    order.file = words[1];
    if (count > 3) {
        order.width_px = std::atoi(words[2]);
        order.height_px = std::atoi(words[3]);
    }
    if (count > 4) order.size = static_cast<TextSize>(std::atoi(words[4]) % 4);
    if (count > 5) order.palette = static_cast<PaletteName>(std::atoi(words[5]) % 4);
    return write_sheet(order);
}
