// What is said, for ears and for fingers; and what a reader does on the braille line.
#include "app/kiosk/kiosk.h"

#include <string>

namespace touchline {

/// One hand feels and the other reads, so what the hand is on does not wait on the line.
void Kiosk::say(const Utterance& utterance) {
    sound_->say(utterance);
    const bool waits = utterance.priority == SpeechPriority::hint && !utterance.is_of_hand;
    braille_->say({utterance.language, utterance.text}, waits ? LineUse::after : LineUse::now);
}

void Kiosk::follow_braille() {
    while (const auto event = braille_->next_event()) take_line_event(*event);
    if (const std::string line = braille_->take_report(); !line.empty()) report(line);
    if (!braille_->is_there()) return;
    const SpokenScreen now = screen();
    if (!now.focus) return braille_->rest({});
    const Language& its =
        is_operator_in() ? language() : language_of_item(visit_, now.items[*now.focus], world());
    braille_->rest({its.code(), spoken_item(now, *now.focus, its)});
}

/// The operator reads pages too, but is no visitor.
void Kiosk::take_line_event(const LineEvent& event) {
    if (const auto* const role = std::get_if<KeyRole>(&event)) return press(*role);
    if (is_operator_in()) return;
    if (const auto* const turned = std::get_if<LineTurned>(&event))
        return apply(LineRead{turned->is_at_end});
    apply(DeadKeyPressed{});
}

/// Goodbye is said after everything was forgotten, and is the last visitor's all the same.
void Kiosk::forget_words_between_visits(VisitScreen before) {
    const bool was_idle = before == VisitScreen::attract || before == VisitScreen::closed;
    const bool is_over = before == VisitScreen::goodbye && open_screen(visit_) != before;
    if (is_over || (was_idle && is_visit_on(visit_))) braille_->forget();
}

}  // namespace touchline
