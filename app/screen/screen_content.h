// The content of the visitor's or operator's screen in one frame.
// Threads: values that share what does not change.
#pragma once

#include "app/screen/canvas.h"
#include "app/screen/theme.h"
#include "app/visit/screen_model.h"
#include "audio-cues/words/language.h"
#include "config/types/hand_state.h"
#include "haptics/collision/scene.h"

#include <memory>
#include <string>

namespace touchline {

/// Empty before the first picture.
struct ShownScene {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const Canvas> picture;
};

struct ScreenContent {
    SpokenScreen screen;
    /// What is being said, or was said last. Long captions have pages.
    std::string caption;
    /// The words of the sound cue that plays (words_of(Cue)). One frame is enough: they stay for at
    /// least a second.
    std::string sound_sign;
    TextSize text_size = TextSize::normal;
    PaletteName palette = PaletteName::white_on_black;
    /// The visitor turned the screen off: it is black, whatever else is here.
    bool is_curtain = false;
    /// With ScreenView::camera: shows `preview`. If false, the sheet fills the screen.
    bool is_preview_on = true;
    HandState hand;
    ShownScene shown;                       // with ScreenView::picture
    std::shared_ptr<const Canvas> preview;  // null: no frame yet
    /// The screen's language, for "Page 2 of 3".
    Language language;
};

}  // namespace touchline
