// Writes every screen in every language as one picture, for viewing, or all golden sheets.
#include "app/documents/decode/picture.h"
#include "audio-cues/words/language.h"
#include "tests/app/screen/contact_sheet.h"
#include "tests/app/screen/every_screen.h"
#include "tests/app/screen/golden_sheet.h"
#include "tests/app/screen/probes.h"

#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace touchline {
namespace {

struct SheetOrder {
    std::string file;
    GoldenLook look{TextSize::largest, PaletteName::white_on_black, 1920, 1080};
};

/// Adds `screens` in one language.
void add_screens(std::vector<Thumbnail>& thumbnails, const std::vector<NamedScreen>& screens,
                 const Language& language, const SheetOrder& order) {
    for (const NamedScreen& each : screens) {
        ScreenLayers layers(usual_cap_px);
        const GoldenLook& look = order.look;
        layers.update(drawn_content(each.screen, language, look), look.width_px, look.height_px, 0);
        thumbnails.push_back({fmt::format("{}, {}", each.name, language.code()),
                              composed(layers, look.width_px, look.height_px)});
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

int write_golden_sheets(const std::string& folder) {
    for (std::size_t i = 0; i < palette_count * text_size_count; ++i) {
        const GoldenLook look{static_cast<TextSize>(i % text_size_count),
                              static_cast<PaletteName>(i / text_size_count)};
        const auto done =
            write_png(folder + '/' + golden_file(look), picture_of(golden_sheet(look)));
        if (done) continue;
        fmt::print(stderr, "{}\n", done.error().line);
        return 1;
    }
    return 0;
}

}  // namespace
}  // namespace touchline

/// Usage: screen_sheet OUT.png [WIDTH HEIGHT [SIZE 0 ... 3 [PALETTE 0 ... 3]]]
///        screen_sheet --golden FOLDER
int main(int count, char** words) {
    using namespace touchline;
    if (count < 2) {
        fmt::print(stderr,
                   "usage: screen_sheet OUT.png [WIDTH HEIGHT [SIZE [PALETTE]]]\n"
                   "       screen_sheet --golden FOLDER\n");
        return 2;
    }
    if (count == 3 && words[1] == std::string("--golden")) return write_golden_sheets(words[2]);
    SheetOrder order;
    order.file = words[1];
    if (count > 3) {
        order.look.width_px = std::atoi(words[2]);
        order.look.height_px = std::atoi(words[3]);
    }
    if (count > 4) order.look.size = static_cast<TextSize>(std::atoi(words[4]) % 4);
    if (count > 5) order.look.palette = static_cast<PaletteName>(std::atoi(words[5]) % 4);
    return write_sheet(order);
}
