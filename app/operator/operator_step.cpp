#include "app/operator/operator_turn.h"

#include <algorithm>
#include <array>
#include <utility>

namespace touchline {
namespace {

constexpr std::array entry_keys{KeyRole::help, KeyRole::up,   KeyRole::up,
                                KeyRole::down, KeyRole::down, KeyRole::select};
constexpr double entry_s = 5.0;
constexpr double idle_s = 300.0;
constexpr std::size_t most_keys_a_role = 8;

void open(OperatorTurn& turn) {
    turn.state().settings = turn.world.settings;
    turn.state().sound = turn.world.sound;
    turn.state().last_key_s = turn.world.now_s;
    turn.go(turn.world.has_pin ? OperatorPlace::pin : OperatorPlace::new_pin);
}

/// The visitor gets these keys too. A wrong key restarts the sequence.
void press_closed_key(OperatorTurn& turn, const KeyStruck& key) {
    Operator& state = turn.state();
    const double now_s = turn.world.now_s;
    if (state.entered > 0 && now_s - state.entry_began_s > entry_s) state.entered = 0;
    const bool is_next = key.is_allowed && key.role == entry_keys[state.entered];
    const bool is_first = key.is_allowed && key.role == entry_keys.front();
    if (!is_next) state.entered = 0;
    if (!is_next && !is_first) return;
    if (state.entered == 0) state.entry_began_s = now_s;
    if (++state.entered < entry_keys.size()) return;
    state.entered = 0;
    open(turn);
}

/// Newly learnt keys come first; the others keep their roles.
KeyTable with_learnt(const KeyTable& old, const KeyTable& learnt) {
    KeyTable table = learnt;
    for (const KeyBinding& binding : old.bindings)
        if (!role_of(table, binding.key) && keys_of(table, binding.role).size() < most_keys_a_role)
            table.bindings.push_back(binding);
    std::stable_sort(table.bindings.begin(), table.bindings.end(),
                     [](const KeyBinding& a, const KeyBinding& b) { return a.role < b.role; });
    return table;
}

void follow_wizard(OperatorTurn& turn, const WizardStep& step) {
    turn.state().wizard = step.wizard;
    if (step.end == WizardEnd::none) return turn.say(step.said);
    if (step.end == WizardEnd::learnt)
        turn.order(WriteKeys{with_learnt(turn.world.keys, step.wizard.learnt)});
    turn.go(OperatorPlace::keys, step.said);
}

void select(OperatorTurn& turn, const ScreenItem& item) {
    const ItemMeaning meaning = meaning_of(item);
    switch (meaning.item) {
        case OperatorItem::place:
            return turn.go(static_cast<OperatorPlace>(meaning.index));
        case OperatorItem::action:
            return do_action(turn, meaning.index);
        case OperatorItem::test:
            return begin_tests(turn, static_cast<TestStep>(meaning.index), false);
        case OperatorItem::on_stick:
            return turn.order(ImportFromStick{meaning.index});
        case OperatorItem::house_file:
            turn.say(turn.words("The file is being checked."));
            return turn.order(LookAtHouseFile{meaning.index});
        case OperatorItem::kind:
            return choose_kind(turn, meaning.index);
        case OperatorItem::no:
        case OperatorItem::yes:
            return answer(turn, meaning.item == OperatorItem::yes);
        default:
            if (!select_value(turn, meaning))
                turn.say(spoken_item(turn.screen(), turn.state().focus, turn.world.language));
    }
}

void go_back(OperatorTurn& turn) {
    const OperatorPlace place = turn.state().place;
    if (place == OperatorPlace::question) return answer(turn, false);
    const OperatorPlace parent = row_of(place).parent;
    parent == OperatorPlace::closed ? turn.leave() : turn.go(parent);
}

void move(OperatorTurn& turn, bool is_down) {
    const auto moved = move_focus(turn.screen(), is_down);
    if (!moved) return turn.say(spoken_screen(turn.screen(), turn.world.language));
    turn.state().focus = moved->focus;
    turn.say_item();
}

void help(OperatorTurn& turn) {
    std::string text = spoken_screen(turn.screen(), turn.world.language);
    add_sentence(text, turn.words("Press Up or Down to move, Select to choose. Press Repeat for an "
                                  "explanation, Back to leave, Help to hear this."));
    turn.say(text);
}

void press_held_key(OperatorTurn& turn, KeyRole role, const ScreenItem& item) {
    if (role == KeyRole::up || role == KeyRole::down)
        return turn_value(turn, meaning_of(item), role == KeyRole::up);
    if (role == KeyRole::repeat) return turn.say_item();
    if (!release_value(turn)) return;
    if (role == KeyRole::help) help(turn);
}

void press_list_key(OperatorTurn& turn, KeyRole role) {
    const auto items = operator_items(turn.state(), turn.world);
    const bool has_focus = turn.state().focus < items.size();
    if (turn.state().is_held && has_focus)
        return press_held_key(turn, role, items[turn.state().focus]);
    turn.state().is_held = false;
    if (role == KeyRole::up || role == KeyRole::down) return move(turn, role == KeyRole::down);
    if (role == KeyRole::back) return go_back(turn);
    if (role == KeyRole::help) return help(turn);
    if (!has_focus) return turn.say(spoken_screen(turn.screen(), turn.world.language));
    const ScreenItem& item = items[turn.state().focus];
    if (role == KeyRole::select) return select(turn, item);
    turn.say(item.hint.empty() ? spoken_item(turn.screen(), turn.state().focus, turn.world.language)
                               : item.hint);
}

bool is_listed(KeyRole role) {
    return static_cast<std::size_t>(role) < needed_role_count;
}

void take(OperatorTurn& turn, const KeyStruck& key) {
    Operator& state = turn.state();
    if (state.place == OperatorPlace::closed) return press_closed_key(turn, key);
    if (!key.is_allowed) return;
    state.last_key_s = turn.world.now_s;
    if (state.place == OperatorPlace::cleaning_lock) return;
    if (state.place == OperatorPlace::key_wizard)
        return follow_wizard(
            turn, press_wizard_key(state.wizard, key.key, turn.world.now_s, turn.world.language));
    if (!key.role || !is_listed(*key.role)) return;
    if (is_of_pin(state.place)) return press_pin_key(turn, *key.role);
    if (state.place == OperatorPlace::test_step)
        return follow_test(
            turn, press_test_key(state.test, *key.role, turn.world.now_s, turn.world.language));
    press_list_key(turn, *key.role);
}

void end_cleaning(OperatorTurn& turn) {
    if (turn.world.now_s < turn.state().lock_until_s) return;
    turn.order(LockHandle{false});
    turn.state().last_key_s = turn.world.now_s;
    turn.go(OperatorPlace::device, turn.words("The handle is ready again."));
}

/// Somebody who went away must not leave the screens open.
void leave_when_idle(OperatorTurn& turn) {
    if (turn.world.now_s - turn.state().last_key_s < idle_s) return;
    turn.order(SetSettings{turn.world.settings});
    turn.leave();
}

/// Says each new instruction for the handle, also during homing that began before.
void follow_homing(OperatorTurn& turn) {
    const std::string& words = turn.world.kiosk.device_words;
    if (std::exchange(turn.state().device_words, words) == words) return;
    turn.state().note = words.empty() ? turn.words("The handle is ready.") : words;
    turn.say(turn.state().note);
}

void take(OperatorTurn& turn, const MomentPassed& /*moment*/) {
    Operator& state = turn.state();
    switch (state.place) {
        case OperatorPlace::closed:
            return;
        case OperatorPlace::cleaning_lock:
            return end_cleaning(turn);
        case OperatorPlace::key_wizard: {
            const WizardStep step =
                wait_for_wizard_key(state.wizard, turn.world.now_s, turn.world.language);
            if (!step.said.empty()) follow_wizard(turn, step);
            return;
        }
        case OperatorPlace::test_step: {
            const SelfTestStep step =
                wait_for_test(state.test, turn.world.now_s, turn.world.language);
            if (!step.said.empty()) return follow_test(turn, step);
            return leave_when_idle(turn);
        }
        case OperatorPlace::homing:
            follow_homing(turn);
            return leave_when_idle(turn);
        default:
            return leave_when_idle(turn);
    }
}

/// Takes over what somebody else changed in the file, unless it is being edited now.
void take_over(OperatorTurn& turn) {
    Operator& state = turn.state();
    if (is_editing(state)) return;
    state.settings = turn.world.settings;
    state.sound = turn.world.sound;
}

void take(OperatorTurn& turn, const PinChecked& checked) {
    judge_pin(turn, checked);
}

void take(OperatorTurn& turn, const TestAnswered& answer) {
    const SelfTest& test = turn.state().test;
    const bool is_awaited = turn.state().place == OperatorPlace::test_step &&
                            test.phase == TestPhase::running && test.step == answer.step;
    if (!is_awaited) return;
    follow_test(turn, test_done(test, answer.step, answer.has_passed, answer.line, turn.world.now_s,
                                turn.world.language));
}

void take(OperatorTurn& turn, const OrderAnswered& answer) {
    if (turn.state().place == OperatorPlace::closed) return;
    turn.state().note = answer.line;
    turn.say(answer.line);
}

/// Whoever has gone elsewhere meanwhile is not called back.
void take(OperatorTurn& turn, const HouseLooked& looked) {
    if (turn.state().place == OperatorPlace::several) turn.go(looked.place);
}

}  // namespace

void follow_test(OperatorTurn& turn, const SelfTestStep& step) {
    turn.state().test = step.test;
    if (step.stop) turn.order(StopTest{});
    if (step.test.phase == TestPhase::idle)
        turn.go(turn.state().tested_from, step.said);
    else
        turn.say(step.said);
    if (step.run) turn.order(RunTest{*step.run});
}

void begin_tests(OperatorTurn& turn, TestStep first, bool is_all) {
    turn.state().tested_from = turn.state().place;
    turn.state().place = OperatorPlace::test_step;
    follow_test(
        turn, begin_test(turn.state().test, first, is_all, turn.world.now_s, turn.world.language));
}

OperatorStep step_operator(const Operator& state, const OperatorEvent& event,
                           const OperatorWorld& world) {
    OperatorTurn turn{{state, {}}, world};
    take_over(turn);
    std::visit([&turn](const auto& each) { take(turn, each); }, event);
    return std::move(turn.step);
}

}  // namespace touchline
