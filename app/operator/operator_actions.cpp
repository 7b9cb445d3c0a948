// What the operator's actions and questions do.
#include "app/operator/operator_turn.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

template <class Order>
void give(OperatorTurn& turn) {
    turn.order(Order{});
}

template <Question question>
void ask(OperatorTurn& turn) {
    turn.ask(question);
}

void learn_keys(OperatorTurn& turn) {
    turn.state().wizard = start_key_wizard(turn.world.now_s);
    turn.go(OperatorPlace::key_wizard);
}

void find_home(OperatorTurn& turn) {
    if (turn.world.kiosk.kind == std::string()) return turn.go(OperatorPlace::kind);
    turn.order(FindHome{});
}

void clear_fault(OperatorTurn& turn) {
    turn.order(ClearFault{});
    turn.say(turn.words("Any force fault has been cleared."));
}

void run_all_tests(OperatorTurn& turn) {
    begin_tests(turn, TestStep::device, true);
}

void begin_cleaning(OperatorTurn& turn) {
    turn.state().lock_until_s = turn.world.now_s + turn.world.settings.cleaning_s;
    turn.order(LockHandle{true});
    turn.go(OperatorPlace::cleaning_lock);
}

void confirm_key(OperatorTurn& turn) {
    turn.state().pin = {};
    turn.go(OperatorPlace::key_pin);
}

void choose_new_pin(OperatorTurn& turn) {
    turn.go(OperatorPlace::new_pin);
}

void leave(OperatorTurn& turn) {
    turn.leave();
}

using P = OperatorPlace;
using A = OperatorAction;
using Q = Question;

constexpr auto actions = std::to_array<ActionRow>({
    {P::keys, A::learn_keys, "Assign the keys", "You press the key for each role twice.",
     learn_keys},
    {P::device, A::clear_fault, "Reset the force fault", "Only when all is safe.", clear_fault},
    {P::homing, A::find_home, "Begin", "", find_home},
    {P::self_test, A::run_all_tests, "All steps", "One after the other.", run_all_tests},
    {P::cleaning, A::begin_cleaning, "Begin", "", begin_cleaning},
    {P::several, A::make_bundle, "Make a bundle of this kiosk",
     "The file lies beside the settings.", give<MakeBundle>},
    {P::several, A::show_house_key, "House key of this kiosk",
     "It is made the first time. Its file lies beside the settings.", give<ShowHouseKey>},
    {P::several, A::find_way_back, "Back to before the bundle",
     "You hear what would change before anything does.", give<LookAtWayBack>},
    {P::bundle, A::apply_bundle, "Apply the bundle", "All of it is changed, or nothing.",
     ask<Q::apply_bundle>},
    {P::way_back, A::go_back, "Go back", "", ask<Q::go_back>},
    {P::house_key, A::trust_key, "Trust this house key",
     "Only if the digits are the same. The PIN is asked for.", confirm_key},
    {P::counters, A::export_counters, "Copy the days as a table",
     "The file lies beside the settings. A spreadsheet reads it.", give<ExportCounters>},
    {P::counters, A::zero_counters, "Begin again from zero", "", ask<Q::zero_counters>},
    {P::log, A::export_log, "Copy the log", "", give<ExportLog>},
    {P::log, A::save_recording, "Save what was felt in the last minute",
     "The file tells where the hand was. Ask the visitor first.", give<SaveRecording>},
    {P::backup, A::back_up, "Copy the settings", "", give<BackUp>},
    {P::backup, A::restore, "Bring the settings back from the copy",
     "They are checked first; wrong ones change nothing.", ask<Q::restore>},
    {P::backup, A::first_settings, "Factory settings",
     "All settings become what they were when the kiosk was new.", ask<Q::first_settings>},
    {P::upkeep, A::keep_drawing, "Keep the drawing",
     "What somebody draws for a visitor now is kept as a picture.", give<KeepDrawing>},
    {P::upkeep, A::new_pin, "Change the PIN", "", choose_new_pin},
    {P::close, A::close, "Shut down", "", ask<Q::close>},
    {P::home, A::leave, "Leave", "The kiosk is open to visitors again.", leave},
});

void write_settings(OperatorTurn& turn) {
    turn.order(WriteSettings{turn.state().settings});
}

void write_first_settings(OperatorTurn& turn) {
    turn.state().settings = Settings{};
    turn.order(WriteSettings{turn.state().settings, true});
}

void measure_kind(OperatorTurn& turn) {
    turn.order(ChooseKind{std::string(kind_rows()[turn.state().kind].profile)});
}

constexpr auto questions = std::to_array<QuestionRow>({
    {Q::ceiling, P::feel, "Lines may then push harder than before.", write_settings},
    {Q::restore, P::backup, "The settings of the copy replace those of the kiosk.", give<Restore>},
    {Q::close, P::close, "The program ends, and the screen is empty.", give<CloseKiosk>},
    {Q::zero_counters, P::counters, "All counts begin again from zero.", give<ZeroCounters>},
    {Q::first_settings, P::backup, "All that was set is lost.", write_first_settings},
    {Q::file_systems, P::sticks,
     "A hostile USB stick may then take the machine over. Allow it for a while only.",
     write_settings},
    {Q::kind, P::kind, "The handle is measured anew. What was measured before is lost.",
     measure_kind},
    {Q::apply_bundle, P::several, "All that you heard is changed.", give<ApplyBundle>},
    {Q::go_back, P::several, "All is then as before the bundle.", give<GoBackToBefore>},
});

static_assert(questions.size() == question_count);

}  // namespace

std::span<const ActionRow> action_rows() {
    return actions;
}

const QuestionRow& row_of(Question question) {
    return *std::ranges::find(questions, question, &QuestionRow::question);
}

void do_action(OperatorTurn& turn, std::size_t action) {
    const auto* const row =
        std::ranges::find(actions, static_cast<OperatorAction>(action), &ActionRow::action);
    if (row != actions.end()) row->act(turn);
}

/// Asks first if a handle was measured before.
void choose_kind(OperatorTurn& turn, std::size_t kind) {
    const std::string profile(kind_rows()[kind].profile);
    if (turn.world.kiosk.kind == profile)
        return turn.say(turn.words("It is of this kind already."));
    turn.state().kind = kind;
    if (turn.world.kiosk.kind != std::string()) return turn.ask(Question::kind);
    measure_kind(turn);
    turn.go(OperatorPlace::homing);
}

void answer(OperatorTurn& turn, bool is_yes) {
    const QuestionRow& asked = row_of(turn.state().question);
    if (is_yes)
        asked.yes(turn);
    else
        turn.state().settings = turn.world.settings;
    constexpr std::array told_later{Question::restore, Question::apply_bundle, Question::go_back};
    const bool tells_later = is_yes && std::ranges::count(told_later, asked.question) > 0;
    // A kind that was chosen is measured next.
    const bool is_measured = is_yes && asked.question == Question::kind;
    turn.go(is_measured ? OperatorPlace::homing : asked.place,
            tells_later ? "" : turn.words(is_yes ? "Done." : "Nothing was changed."));
}

}  // namespace touchline
