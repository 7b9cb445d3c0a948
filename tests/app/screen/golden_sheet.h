// The screens of a visit and of the operator as the kiosk draws them, on one sheet for each size of
// letters and each palette: pictures to compare with, and for people to look at.
#pragma once

#include "app/screen/canvas.h"
#include "app/screen/screen_content.h"

#include <string>

namespace touchline {

inline constexpr int golden_columns = 12;
inline constexpr int golden_width_px = 128;  // of each screen on the sheet

struct GoldenLook {
    TextSize size = TextSize::normal;
    PaletteName palette = PaletteName::white_on_black;
    int width_px = 1280;
    int height_px = 720;
};

/// The screen with its caption, a sound, the lines of a fish and a picture of the camera.
[[nodiscard]] ScreenContent drawn_content(const SpokenScreen& screen, const Language& language,
                                          const GoldenLook& look);

/// "white-on-black-normal.png".
[[nodiscard]] std::string golden_file(const GoldenLook& look);

/// Draws English screens, in rows of `golden_columns`.
[[nodiscard]] Canvas golden_sheet(const GoldenLook& look);

}  // namespace touchline
