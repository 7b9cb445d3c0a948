#include "app/kiosk/kiosk_keys.h"

#include "app/kiosk/kiosk.h"

#include <utility>

namespace touchline {

void Kiosk::change_key(const KeyChange& change) {
    if (!keys_.filter.takes(change)) return hold_key(change);
    keys_.held_since_s = change.time_s;
    const auto [role, action] = keys_.meaning_of(change.key);
    if (!role && action == Action::emergency_stop) return act(*action);
    const bool was_in = is_operator_in();
    // If the operator has a keyboard of their own, no other one opens the way in.
    strike_key(KeyStruck{change.key, role, settings_.operator_device.empty()});
    if (was_in || is_operator_in()) return;
    if (role) return press_for_visit(*role);
    if (!action) return apply(DeadKeyPressed{});
    if (!is_for_operator(*action) || are_keys_free()) return act(*action);
    answer_staff("This key is the operator’s. Enter the PIN first.");
}

void Kiosk::answer_staff(const std::string& english) {
    say_of_key(language().text("operator", english));
}

void Kiosk::say_of_key(const std::string& text) {
    key_caption_ = text;
    say({language().code(), text, SpeechPriority::text});
}

/// The window system tells of a held key many times a second.
void Kiosk::hold_key(const KeyChange& change) {
    constexpr double jump_s = 1.0;  // time to hear where one is
    const bool is_due = change.time_s - keys_.held_since_s >= jump_s;
    if (!change.is_repeat || !is_due || is_operator_in()) return;
    keys_.held_since_s = change.time_s;
    const auto role = keys_.meaning_of(change.key).role;
    if (role && settings_.two_switches == SwitchUse::none) apply(KeyHeld{*role});
}

/// True while there is no PIN, and where nobody could give one.
bool Kiosk::are_keys_free() const {
    return keys_.are_free || !operator_ || !operator_->has_pin();
}

/// True once the PIN was given, but not while a key is being learned.
bool Kiosk::takes_operator_keys() const {
    return operator_ && operator_->is_inside() && !operator_->is_learning_keys();
}

/// The site's table need not have a key for louder and softer, which a braille display may have.
void Kiosk::press(KeyRole role) {
    const std::vector<PhysicalKey> keys = keys_of(keys_.table, role);
    if (keys.empty() && !is_operator_in()) return press_for_visit(role);
    if (keys.empty()) return;
    change_key({keys.front(), true, false, now_s_});
    change_key({keys.front(), false, false, now_s_});
}

void Kiosk::strike_operator_key(const PhysicalKey& key) {
    const auto [role, action] = keys_.meaning_of(key);
    if (action == Action::emergency_stop) return act(*action);
    if (action && is_for_operator(*action) && !role && !is_operator_in()) return act(*action);
    strike_key(KeyStruck{key, role, true});
}

/// R saves a recording for an operator who gave the PIN, at a keyboard that is allowed. For
/// everybody else act() holds it in memory.
void Kiosk::strike_key(const KeyStruck& struck) {
    const auto action = keys_.meaning_of(struck.key).action;
    const bool is_order = action && is_for_operator(*action) && !struck.role && struck.is_allowed &&
                          takes_operator_keys();
    if (!is_order) return tell_operator(struck);
    if (*action == Action::hold_recording) return handle_.keep_recording();
    act(*action);
}

/// With two switches a key either selects or moves on.
void Kiosk::press_for_visit(KeyRole role) {
    if (settings_.two_switches == SwitchUse::none) return apply(KeyPressed{role});
    press_switch(role == KeyRole::select ? SwitchEvent::select : SwitchEvent::move);
}

void Kiosk::press_switch(SwitchEvent event) {
    const double pace_s = settings_.two_switches == SwitchUse::by_itself ? settings_.scan_s : 0.0;
    SwitchStep step = step_switches(keys_.scan, event, screen(), pace_s, now_s_, language());
    keys_.scan = step.scan;
    if (!step.said.empty()) say_of_key(step.said);
    if (step.press) apply(KeyPressed{*step.press});
}

/// Items come by themselves for one switch, each once the words before it have been heard.
void Kiosk::scan_by_itself() {
    if (settings_.two_switches != SwitchUse::by_itself || is_operator_in()) return;
    if (sound_->is_speaking() && sound_->problem().empty())
        keys_.scan.since_s = now_s_;
    else
        press_switch(SwitchEvent::tick);
}

void Kiosk::act(Action action) {
    switch (action) {
        case Action::repeat_speech:
            return apply(SpeechKeyPressed{SpeechKey::repeat});
        case Action::pause_speech:
            return apply(SpeechKeyPressed{SpeechKey::pause});
        case Action::slower_speech:
            return apply(SpeechKeyPressed{SpeechKey::slower});
        case Action::faster_speech:
            return apply(SpeechKeyPressed{SpeechKey::faster});
        case Action::emergency_stop:
            return handle_.stop_at_once();
        case Action::clear_fault:
            return handle_.clear_fault();
        case Action::hold_recording:
            handle_.servo().hold_recording();
            return answer_staff("The last minute of the handle is held in memory.");
        case Action::home_again:
            return handle_.servo().home_again();
        case Action::toggle_live_view:
            window_wishes_.shows_live_view = !window_wishes_.shows_live_view;
            return;
        case Action::toggle_boxes:
            window_wishes_.shows_boxes = !window_wishes_.shows_boxes;
            return;
        case Action::erase_line:
            return apply(DrawerKeyPressed{DrawerKey::erase});
        case Action::undo_line:
            return apply(DrawerKeyPressed{DrawerKey::undo});
        case Action::redo_line:
            return apply(DrawerKeyPressed{DrawerKey::redo});
        case Action::headphones_in:
        case Action::headphones_out:
            return sound_->tell_headphones(action == Action::headphones_in);
        case Action::quit:
            // The operator's screens cover the question, and whoever is inside has the PIN.
            if (!is_operator_in()) return apply(QuitAsked{});
            window_wishes_.is_quitting = true;
            return;
    }
}

}  // namespace touchline
