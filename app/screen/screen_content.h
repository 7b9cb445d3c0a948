// The content of the visitor's or operator's screen in one frame.
// Threads: values that share what does not change.
#pragma once

#include "app/screen/canvas.h"
#include "app/screen/line_drawing.h"
#include "app/screen/staff_panel.h"
#include "app/screen/theme.h"
#include "app/visit/screen_model.h"
#include "audio-cues/words/language.h"
#include "config/types/choices.h"
#include "config/types/hand_state.h"
#include "haptics/collision/scene.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

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
    /// The visitor turned the screen off: it is black but for one line that says how to turn it on
    /// again, whatever else is here.
    bool is_curtain = false;
    /// With ScreenView::camera: shows `preview`. If false, the sheet fills the screen.
    bool is_preview_on = true;
    HandState hand;
    ShownScene shown;                       // with ScreenView::picture
    std::vector<Position> stroke;           // of the pen, in W, while it is down; may be empty
    std::shared_ptr<const Canvas> preview;  // null: no frame yet
    Language language;                      // the screen's
    SwitchUse switches = SwitchUse::none;   // instead of the keys
    std::vector<LineDrawingPtr> pictures;   // of each item, null where it has none; may be empty
    std::optional<LiveContent> live;        // the staff's view, beside all else
    bool has_ended = false;                 // no key does anything any more
};

}  // namespace touchline
