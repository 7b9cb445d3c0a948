// Writes every screen in every language as one picture, for viewing; or the stored pictures: all
// golden sheets, and the key screens of app/screen/README.md.
#include "app/documents/decode/picture.h"
#include "audio-cues/words/language.h"
#include "tests/app/screen/contact_sheet.h"
#include "tests/app/screen/golden_sheet.h"
#include "tests/app/screen/sample_screens.h"

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

int told(const Result<void>& done) {
    if (done) return 0;
    fmt::print(stderr, "{}\n", done.error().line);
    return 1;
}

int write_sheet(const SheetOrder& order) {
    std::vector<Thumbnail> thumbnails;
    constexpr int columns = 8;
    for (const Language& language : every_language())
        for (const auto& [name, content] : every_content(language, order.look))
            thumbnails.push_back(
                {fmt::format("{}, {}", name, language.code()), drawn_screen(content, order.look)});
    constexpr int thumbnail_px = 480;
    return told(
        write_png(order.file, picture_of(contact_sheet(thumbnails, columns, thumbnail_px))));
}

int write_golden_sheets(const std::string& source) {
    for (const GoldenLook& look : golden_looks()) {
        const GreyPicture sheet = golden_sheet(look).picture;
        const auto done = write_png(source + "/tests/app/screen/golden/" + golden_file(look),
                                    GreyView{sheet.width, sheet.height, sheet.grey});
        if (!done) return told(done);
    }
    return told(write_png(source + "/app/screen/key-screens.png", picture_of(key_screens())));
}

}  // namespace
}  // namespace touchline

/// Usage: screen_sheet OUT.png [WIDTH HEIGHT [SIZE 0 ... 3 [PALETTE 0 ... 3]]]
///        screen_sheet --golden SOURCE
int main(int count, char** words) {
    using namespace touchline;
    if (count < 2) {
        fmt::print(stderr,
                   "usage: screen_sheet OUT.png [WIDTH HEIGHT [SIZE [PALETTE]]]\n"
                   "       screen_sheet --golden SOURCE\n");
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
