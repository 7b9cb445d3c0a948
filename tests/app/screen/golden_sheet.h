// The screens of a visit and of the operator as the kiosk draws them: small and grey on one sheet
// for each size of letters, palette and resolution, to compare with; the key ones large, for
// people.
#pragma once

#include "app/documents/decode/picture.h"
#include "app/screen/canvas.h"
#include "app/screen/screen_content.h"

#include <string>
#include <vector>

namespace touchline {

// Each screen on a sheet.
inline constexpr int golden_columns = 8;
inline constexpr int golden_width_px = 64;
inline constexpr int golden_height_px = 36;

struct GoldenLook {
    TextSize size = TextSize::normal;
    PaletteName palette = PaletteName::white_on_black;
    int width_px = 1280;
    int height_px = 720;
};

/// Every size and palette on both screens.
[[nodiscard]] std::vector<GoldenLook> golden_looks();

/// "white-on-black-normal-1280x720.png".
[[nodiscard]] std::string golden_file(const GoldenLook& look);

/// The mean of red, green and blue.
[[nodiscard]] GreyPicture grey_of(const Canvas& canvas);

struct GoldenSheet {
    std::vector<std::string> names;  // of the screens, from the left and from the top
    GreyPicture picture;
};

/// Draws all English screens.
[[nodiscard]] GoldenSheet golden_sheet(const GoldenLook& look);

/// Six screens whose words can be read.
[[nodiscard]] Canvas key_screens();

struct NamedContent {
    std::string name;
    ScreenContent content;
};

/// Every screen as drawn_content(), and in English: small pictures, the staff's live view, and the
/// screen turned off.
[[nodiscard]] std::vector<NamedContent> every_content(const Language& language,
                                                      const GoldenLook& look);

/// The screen with its caption, a sound, the lines of a fish and a picture of the camera.
[[nodiscard]] ScreenContent drawn_content(const SpokenScreen& screen, const Language& language,
                                          const GoldenLook& look);

/// The screen as the kiosk shows it.
[[nodiscard]] Canvas drawn_screen(const ScreenContent& content, const GoldenLook& look);

}  // namespace touchline
