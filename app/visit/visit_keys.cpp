// What the keys do, the same on every screen.
#include "app/visit/visit_menu.h"
#include "audio-cues/speech/speech_input.h"

#include <array>
#include <string>

namespace touchline {
namespace {

void note_presence(VisitWork& work) {
    Visitor& visitor = work.visitor;
    visitor.active_s = visitor.key_s = work.site.now_s;
    visitor.listens_until_s = 0.0;
    visitor.pulled_s.reset();
    visitor.is_hint_due = false;  // until another item or screen gets the focus
}

/// Does what every key does before anything else. True if that was all.
bool is_taken_at_once(VisitWork& work, bool is_volume = false) {
    note_presence(work);
    const bool was_leading = stop_leading(work);
    if (const VisitAct any_key = row_of(open_screen(work)).any_key; any_key != nullptr) {
        cue(work, ScreenEvent::key_taken);
        any_key(work);
        return true;
    }
    if (!was_leading || is_volume) return false;
    cue(work, ScreenEvent::key_taken);
    say(work, words(work, has_keys(work.world)
                              ? "You pressed a key. The handle has stopped guiding you."
                              : "You pressed a switch. The handle has stopped guiding you."));
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
    say_screen(work);
}

/// Once says the last words; twice the whole screen, with its hint.
void repeat(VisitWork& work) {
    Visitor& visitor = work.visitor;
    cue(work, ScreenEvent::key_taken);
    const int repeats = visitor.repeats + 1;
    if (repeats == 1 && !visitor.caption.text.empty()) {
        visitor.repeats = repeats;
        say_again(work);
        return;
    }
    visitor.repeats = 0;
    const SpokenScreen screen = screen_of(work);
    SpokenText text = told_screen(screen, language_of(work));
    add_sentence(text, untold_hint(screen));
    say(work, text);
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

/// `use` and `switched_use` are said in help: of a key, and of an item for two switches.
struct RoleRow {
    const char* name;
    const char* use;
    VisitAct act;
    const char* switched_use = nullptr;  // none: the same
};

// In the order of KeyRole.
constexpr std::array<RoleRow, key_role_count> roles{{
    {"Up", "Goes to the previous item. Hold it to skip several.", move<false>,
     "Goes to the previous item."},
    {"Down", "Goes to the next item. Hold it to skip several.", move<true>,
     "Goes to the next item."},
    {"Back", "Leaves a screen. Press it again to leave the help.", go_back,
     "Leaves a screen. Choose it again to leave the help."},
    {"Repeat", "Repeats the last words. Press it twice for the whole screen.", repeat,
     "Repeats the last words. Choose it twice for the whole screen."},
    {"Select", "Chooses the item.", select},
    {"Help", "Explains the keys. Press it again to call the staff.", open_help,
     "Explains the keys. Choose it again to call the staff."},
    {"Louder", "Raises the volume.", [](VisitWork& work) { change_volume(work, +1); }},
    {"Softer", "Lowers the volume.", [](VisitWork& work) { change_volume(work, -1); }},
}};

const char* use_of(KeyRole role, const VisitWorld& world) {
    if (role == KeyRole::help && !world.rules.offers_staff) return "Explains the keys.";
    const RoleRow& row = roles[static_cast<std::size_t>(role)];
    return has_keys(world) || row.switched_use == nullptr ? row.use : row.switched_use;
}

/// In help a key only says what it is.
void explain(VisitWork& work, KeyRole role) {
    cue(work, ScreenEvent::key_taken);
    std::string text = words(work, roles[static_cast<std::size_t>(role)].name);
    add_sentence(text, words(work, use_of(role, work.world)));
    say(work, text);
}

/// True if this key is also the one pressed last: just now, or in help, where one may take time.
bool is_pressed_twice(const VisitWork& work, KeyRole role) {
    constexpr double twice_s = 5.0;
    const bool is_soon = work.site.now_s - work.visitor.key_s <= twice_s;
    return work.visitor.last_key == role && (is_soon || open_screen(work) == VisitScreen::help);
}

/// Help twice, on any screen of a visit.
void call_staff_by_key(VisitWork& work) {
    note_presence(work);
    work.visitor.last_key.reset();  // a third Help explains the keys again
    stop_leading(work);
    cue(work, ScreenEvent::key_taken);
    call_staff(work);
}

}  // namespace

void write_keys(VisitSheet& sheet) {
    for (std::size_t role = 0; role < key_role_count; ++role) {
        const std::string use = sheet.words(use_of(static_cast<KeyRole>(role), sheet.world));
        sheet.screen.items.push_back(
            {static_cast<int>(role), ItemRole::text, sheet.words(roles[role].name), use, use});
    }
}

void take(VisitWork& work, const KeyPressed& key) {
    const KeyRole role = key.role;
    const bool is_twice = is_pressed_twice(work, role);
    work.visitor.last_key = role;
    order(work, Hush{});
    work.visitor.dead_keys = 0;
    if (role != KeyRole::repeat) work.visitor.repeats = 0;
    const bool is_volume = role == KeyRole::louder || role == KeyRole::softer;
    const bool may_call = work.world.rules.offers_staff && is_visit_on(visit_of(work));
    if (is_twice && role == KeyRole::help && may_call) return call_staff_by_key(work);
    if (is_taken_at_once(work, is_volume)) return;
    const bool is_help = open_screen(work) == VisitScreen::help;
    if (is_help && !(is_twice && role == KeyRole::back)) return explain(work, role);
    roles[static_cast<std::size_t>(role)].act(work);
}

void take(VisitWork& work, const KeyHeld& held) {
    const bool is_down = held.role == KeyRole::down;
    const VisitScreen screen = open_screen(work);
    const bool does_other = row_of(screen).any_key != nullptr || screen == VisitScreen::help;
    if (does_other || work.visitor.leading || (!is_down && held.role != KeyRole::up)) return;
    const auto to = jump_focus(screen_of(work), is_down);
    shake(work, to ? HandlePattern::focus : HandlePattern::edge);
    if (!to) return cue(work, ScreenEvent::list_end);
    order(work, Hush{});
    open_standing(work).focus = *to;
    work.visitor.key_s = work.site.now_s;
    work.visitor.is_hint_due = true;
    cue(work, ScreenEvent::key_taken);
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
    work.visitor.last_key.reset();
    work.visitor.dead_keys = 0;
    if (is_taken_at_once(work, true)) return;
    change_rate(work, key == SpeechKey::faster ? +1 : -1);
}

void take(VisitWork& work, const DeadKeyPressed& /*key*/) {
    order(work, Hush{});
    if (is_taken_at_once(work)) return;
    refuse(work);
    work.visitor.repeats = 0;
    work.visitor.last_key.reset();
    if (open_screen(work) == VisitScreen::help) {
        return say(work, words(work, "This key has no use."));
    }
    if (++work.visitor.dead_keys < 3) return;
    work.visitor.dead_keys = 0;
    say(work, words(work, "This key has no use. Press Help to try the keys."));
}

}  // namespace touchline
