#include "app/kiosk/content_of.h"

namespace touchline {

ScreenContent content_of(const Kiosk& kiosk) {
    const Visitor& visitor = kiosk.visit().visitor;
    ScreenContent content;
    content.screen = kiosk.screen();
    content.caption = kiosk.caption();
    content.sound_sign = kiosk.sound_sign();
    content.text_size = static_cast<TextSize>(visitor.look.text_size);
    content.palette = static_cast<PaletteName>(visitor.look.palette);
    content.is_curtain = visitor.look.is_off && !kiosk.is_operator_in();
    content.preview = kiosk.preview();
    content.is_preview_on = content.preview != nullptr;
    content.hand = kiosk.hand();
    content.shown = kiosk.shown();
    content.language = kiosk.language();
    return content;
}

}  // namespace touchline
