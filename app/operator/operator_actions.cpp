#include "app/operator/kinds.h"
#include "app/operator/operator_places.h"
#include "app/operator/operator_turn.h"

namespace touchline {
namespace {

void begin_wizard(OperatorTurn& turn) {
    turn.state().wizard = start_key_wizard(turn.world.now_s);
    turn.go(OperatorPlace::key_wizard);
}

void run_all_tests(OperatorTurn& turn) {
    const SelfTestStep begun = begin_test(turn.state().test, TestStep::device, true,
                                          turn.world.now_s, turn.world.language);
    turn.state().test = begun.test;
    turn.state().place = OperatorPlace::test_step;
    turn.say(begun.said);
    if (begun.run) turn.order(RunTest{*begun.run});
}

void begin_cleaning(OperatorTurn& turn) {
    turn.state().lock_until_s = turn.world.now_s + turn.world.settings.cleaning_s;
    turn.order(LockHandle{true});
    turn.go(OperatorPlace::cleaning_lock);
}

void carry_out(OperatorTurn& turn, Question question) {
    switch (question) {
        case Question::ceiling:
        case Question::file_systems:
            return turn.order(WriteSettings{turn.state().settings});
        case Question::restore:
            return turn.order(Restore{});
        case Question::close:
            return turn.order(CloseKiosk{});
        case Question::zero_counters:
            return turn.order(ZeroCounters{});
        case Question::first_settings:
            turn.state().settings = Settings{};
            return turn.order(WriteSettings{Settings{}});
        case Question::kind:
            return turn.order(ChooseKind{std::string(kind_rows()[turn.state().kind].profile)});
    }
}

/// The place where the question came from. A kind that was chosen is measured next.
OperatorPlace place_after(Question question, bool is_yes) {
    switch (question) {
        case Question::ceiling:
            return OperatorPlace::feel;
        case Question::restore:
        case Question::first_settings:
            return OperatorPlace::backup;
        case Question::close:
            return OperatorPlace::close;
        case Question::zero_counters:
            return OperatorPlace::counters;
        case Question::file_systems:
            return OperatorPlace::sticks;
        case Question::kind:
            return is_yes ? OperatorPlace::homing : OperatorPlace::kind;
    }
    return OperatorPlace::home;
}

}  // namespace

void do_action(OperatorTurn& turn, std::size_t action) {
    switch (static_cast<OperatorAction>(action)) {
        case OperatorAction::learn_keys:
            return begin_wizard(turn);
        case OperatorAction::find_home:
            if (turn.world.kind == std::string()) return turn.go(OperatorPlace::kind);
            return turn.order(FindHome{});
        case OperatorAction::clear_fault:
            turn.order(ClearFault{});
            return turn.say(turn.words("The force fault is reset."));
        case OperatorAction::run_all_tests:
            return run_all_tests(turn);
        case OperatorAction::begin_cleaning:
            return begin_cleaning(turn);
        case OperatorAction::zero_counters:
            return turn.ask(Question::zero_counters);
        case OperatorAction::export_log:
            return turn.order(ExportLog{});
        case OperatorAction::save_recording:
            return turn.order(SaveRecording{});
        case OperatorAction::back_up:
            return turn.order(BackUp{});
        case OperatorAction::restore:
            return turn.ask(Question::restore);
        case OperatorAction::first_settings:
            return turn.ask(Question::first_settings);
        case OperatorAction::new_pin:
            return turn.go(OperatorPlace::new_pin);
        case OperatorAction::close:
            return turn.ask(Question::close);
        case OperatorAction::leave:
            return turn.leave();
    }
}

/// Asks first if a handle was measured before.
void choose_kind(OperatorTurn& turn, std::size_t kind) {
    const std::string profile(kind_rows()[kind].profile);
    if (turn.world.kind == profile) return turn.say(turn.words("It is of this kind already."));
    turn.state().kind = kind;
    if (turn.world.kind != std::string()) return turn.ask(Question::kind);
    turn.order(ChooseKind{profile});
    turn.go(OperatorPlace::homing);
}

void answer(OperatorTurn& turn, bool is_yes) {
    const Question question = turn.state().question;
    if (is_yes)
        carry_out(turn, question);
    else
        turn.state().settings = turn.world.settings;
    const bool tells_later = is_yes && question == Question::restore;  // the result is said later
    const std::string first =
        tells_later ? "" : turn.words(is_yes ? "Done." : "Nothing was changed.");
    turn.go(place_after(question, is_yes), first);
}

}  // namespace touchline
