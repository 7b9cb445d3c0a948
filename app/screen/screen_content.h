// What the visitor's or operator's screen shows in a frame.
// Threads: a value that shares what does not change.
#pragma once

#include "app/screen/shown_scene.h"
#include "app/screen/theme.h"
#include "app/session/screen_model.h"
#include "audio-cues/words/language.h"
#include "config/types/hand_state.h"

#include <memory>
#include <string>

namespace touchline {

struct ScreenContent {
    SpokenScreen screen;
    /// What is being said, or was said last. Pages where it is long.
    std::string caption;
    /// Words of the sound cue that plays (words_of(Cue)). One frame is enough: it stays for a
    /// second at least.
    std::string sound_sign;
    TextSize text_size = TextSize::normal;
    PaletteName palette = PaletteName::white_on_black;
    /// The visitor turned the screen off: black whatever else is here.
    bool is_curtain = false;
    /// With ScreenView::camera: show `preview`. Off, the sheet has the screen to itself.
    bool is_preview_on = true;
    HandState hand;
    ShownScene shown;                       // with ScreenView::picture
    std::shared_ptr<const Canvas> preview;  // nothing: no frame yet
    /// Of the screen, for "Page 2 of 3".
    Language language;
};

}  // namespace touchline
