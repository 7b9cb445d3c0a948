// What the keys do, the same on every screen.
#include "app/visit/visit_menu.h"
#include "audio-cues/speech/speech_input.h"

#include <array>
#include <string>

namespace touchline {
namespace {

/// Does what every key does before anything else. True if that was all.
bool is_taken_at_once(VisitWork& work, bool is_volume = false) {
    Visitor& visitor = work.visitor;
    visitor.active_s = visitor.key_s = work.site.now_s;
    visitor.pulled_s.reset();
    visitor.is_hint_due = false;  // until another item or screen gets the focus
    const bool was_leading = stop_leading(work);
    if (const VisitAct any_key = row_of(open_screen(work)).any_key; any_key != nullptr) {
        cue(work, ScreenEvent::key_taken);
        any_key(work);
        return true;
    }
    if (!was_leading || is_volume) return false;
    cue(work, ScreenEvent::key_taken);
    say(work, words(work, "Stopped."));
    return true;
}

template <bool is_down>
void move(VisitWork& work) {
    const auto moved = move_focus(screen_of(work), is_down);
    if (!moved) {
        refuse(work);
        return say_screen(work);
    }
    open_standing(work).focus = moved->focus;
    work.visitor.is_hint_due = true;
    cue(work, moved->has_wrapped ? ScreenEvent::list_end : ScreenEvent::key_taken);
    shake(work, moved->has_wrapped ? HandlePattern::edge : HandlePattern::focus);
    say_item(work);
}

/// Opens help; if speech is off, turns it on instead.
void open_help(VisitWork& work) {
    cue(work, ScreenEvent::key_taken);
    if (!work.visitor.sound.is_speech_on) {
        work.visitor.sound.is_speech_on = true;
        const std::string told = language_of(work).text("speech", "Speech is on.");
        const bool is_trouble = open_screen(work) == VisitScreen::trouble;
        return is_trouble ? say_screen(work, told) : say_return(work, told);
    }
    work.visitor.over = Standing{VisitScreen::help};
    work.visitor.helps = 0;
    say_screen(work);
}

/// Once says the last words; twice the whole screen.
void repeat(VisitWork& work) {
    Visitor& visitor = work.visitor;
    cue(work, ScreenEvent::key_taken);
    const int repeats = visitor.repeats + 1;
    if (repeats == 1 && !visitor.caption.text.empty()) {
        visitor.repeats = repeats;
        order(work,
              Utterance{visitor.caption.language, visitor.caption.text, SpeechPriority::text});
        return;
    }
    visitor.repeats = 0;
    say(work, spoken_screen(screen_of(work), language_of(work)));
}

void go_back(VisitWork& work) {
    cue(work, ScreenEvent::key_taken);
    row_of(open_screen(work)).back(work);
}

/// Goes one step up (1) or down (-1). False: there is none.
bool is_stepped(std::size_t& step, std::size_t last, int change) {
    if (change > 0 ? step >= last : step == 0) return false;
    step = change > 0 ? step + 1 : step - 1;
    return true;
}

void change_volume(VisitWork& work, int change) {
    const Language& language = language_of(work);
    std::size_t& volume = work.visitor.sound.volume;
    const std::size_t last = work.world.rules.volume_steps - 1;
    if (!is_stepped(volume, last, change)) {
        cue(work, ScreenEvent::list_end);
        shake(work, HandlePattern::edge);
        return say(work, language.text("speech", change > 0 ? "This is the loudest."
                                                            : "This is the softest."));
    }
    cue(work, ScreenEvent::key_taken);
    say(work, language.text("speech", "Volume {0} of {1}",
                            {std::to_string(volume + 1), std::to_string(last + 1)}));
}

void change_rate(VisitWork& work, int change) {
    const Language& language = language_of(work);
    std::size_t& rate = work.visitor.sound.rate;
    const std::size_t last = speech_rates_per_minute.size() - 1;
    if (!is_stepped(rate, last, change)) {
        cue(work, ScreenEvent::list_end);
        return say(work, language.text("speech", change > 0 ? "This is the fastest."
                                                            : "This is the slowest."));
    }
    cue(work, ScreenEvent::key_taken);
    say(work, language.text("speech", "Speaking speed {0} of {1}",
                            {std::to_string(rate + 1), std::to_string(last + 1)}));
}

struct RoleRow {
    const char* name;
    const char* use;
    VisitAct act;
    const char* switched_use = nullptr;  // if it is an item and no key; none: the same
};

// In the order of KeyRole.
constexpr std::array<RoleRow, key_role_count> roles{{
    {"Up", "Goes to the item before.", move<false>},
    {"Down", "Goes to the next item.", move<true>},
    {"Back", "Leaves this screen.", go_back},
    {"Repeat", "Repeats the last words. Press it twice for the whole screen.", repeat,
     "Repeats the last words. Choose it twice for the whole screen."},
    {"Select", "Chooses the item.", select},
    {"Help", "Explains the keys. Press it again to leave.", open_help,
     "Explains the keys. Choose it again to leave."},
    {"Louder", "Raises the volume.", [](VisitWork& work) { change_volume(work, +1); }},
    {"Softer", "Lowers the volume.", [](VisitWork& work) { change_volume(work, -1); }},
}};

/// In help a key only says what it is.
void explain(VisitWork& work, KeyRole role) {
    Visitor& visitor = work.visitor;
    visitor.helps = role == KeyRole::help ? visitor.helps + 1 : 0;
    cue(work, ScreenEvent::key_taken);
    if (visitor.helps < 2) {
        const RoleRow& row = roles[static_cast<std::size_t>(role)];
        std::string text = words(work, row.name);
        const bool is_switched = !has_keys(work.world) && row.switched_use != nullptr;
        add_sentence(text, words(work, is_switched ? row.switched_use : row.use));
        return say(work, text);
    }
    uncover(work);
}

}  // namespace

void take(VisitWork& work, const KeyPressed& key) {
    const KeyRole role = key.role;
    order(work, Hush{});
    work.visitor.dead_keys = 0;
    if (role != KeyRole::repeat) work.visitor.repeats = 0;
    const bool is_volume = role == KeyRole::louder || role == KeyRole::softer;
    if (is_taken_at_once(work, is_volume)) return;
    if (open_screen(work) == VisitScreen::help) return explain(work, role);
    roles[static_cast<std::size_t>(role)].act(work);
}

void take(VisitWork& work, const KeyHeld& held) {
    const bool is_down = held.role == KeyRole::down;
    const VisitScreen screen = open_screen(work);
    const bool does_other = row_of(screen).any_key != nullptr || screen == VisitScreen::help;
    if (does_other || work.visitor.leading || (!is_down && held.role != KeyRole::up)) return;
    order(work, Hush{});
    const auto to = jump_focus(screen_of(work), is_down);
    if (to) open_standing(work).focus = *to;
    work.visitor.key_s = work.site.now_s;
    work.visitor.is_hint_due = true;
    cue(work, to ? ScreenEvent::key_taken : ScreenEvent::list_end);
    shake(work, to ? HandlePattern::focus : HandlePattern::edge);
    say_item(work);
}

void take(VisitWork& work, const SpeechKeyPressed& pressed) {
    const SpeechKey key = pressed.key;
    if (key == SpeechKey::repeat) return take(work, KeyPressed{KeyRole::repeat});
    if (key == SpeechKey::pause && is_visit_on(visit_of(work))) {
        // Speech is neither hushed nor stopped: the next press goes on with the same words.
        work.visitor.active_s = work.visitor.key_s = work.site.now_s;
        if (stop_leading(work)) order(work, Hush{});
        if (work.visitor.over && work.visitor.over->screen == VisitScreen::question) {
            work.visitor.over.reset();
        }
        cue(work, ScreenEvent::key_taken);
        return order(work, HoldSpeech{});
    }
    order(work, Hush{});
    work.visitor.dead_keys = 0;
    if (is_taken_at_once(work, true)) return;
    change_rate(work, key == SpeechKey::faster ? +1 : -1);
}

void take(VisitWork& work, const DeadKeyPressed& /*key*/) {
    order(work, Hush{});
    if (is_taken_at_once(work)) return;
    refuse(work);
    work.visitor.repeats = 0;
    work.visitor.helps = 0;
    if (open_screen(work) == VisitScreen::help) {
        return say(work, words(work, "This key has no use."));
    }
    if (++work.visitor.dead_keys < 3) return;
    work.visitor.dead_keys = 0;
    say(work, words(work, "This key has no use. Press Help to try the keys."));
}

}  // namespace touchline
