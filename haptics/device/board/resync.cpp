#include "haptics/device/board/pantograph_board.h"

#include <array>
#include <cstddef>

namespace touchline {
namespace {

struct Attempt {
    bool flushes = false;
    double quiet_s = 0.0;  // packets that come meanwhile are dropped
    bool sets_up = false;
    double reply_s = 0.0;  // longest wait for the reply to the zero write
    Rung next = Rung::lost;
};

// quiet: in 20 ms the board works off 32 zeros; 1.1 s outlasts its wait for the rest of a float.
// Setting up takes it 4 ms.
constexpr std::array<Attempt, 7> attempts{{
    {false, 0.005, false, 0.05, Rung::set_up_again},
    {false, 0.0, true, 0.02, Rung::flush},
    {false, 0.02, true, 0.1, Rung::flush},
    {true, 0.02, true, 0.1, Rung::wait_out},
    {false, 1.1, true, 0.1, Rung::wait_again},
    {false, 1.1, true, 0.1, Rung::wait_last},
    {false, 1.1, true, 0.1, Rung::lost},
}};

constexpr double set_up_s = 0.005;  // the board is busy; packets now belong to earlier writes
constexpr double late_s = 0.05;     // a reply that takes longer counts as lost
constexpr double proof_s = 0.003;   // no second reply may follow the first within it
constexpr double longest_end_of_send_s = 0.1;  // for the send before to end

const Attempt& attempt_of(Rung rung) {
    return attempts[static_cast<std::size_t>(rung)];
}

}  // namespace

void Resync::enter(Rung rung) {
    rung_ = rung;
    state_ = rung == Rung::lost ? ResyncState::lost : ResyncState::under_way;
    if (rung != Rung::lost) go(attempt_of(rung).flushes ? Stage::flush : Stage::quiet);
}

void Resync::go(Stage stage) {
    stage_ = stage;
    in_stage_s_ = 0.0;
}

void Resync::climb() {
    enter(attempt_of(rung_).next);
}

ResyncAction Resync::step(const ResyncEvents& events) {
    if (state_ != ResyncState::under_way) return ResyncAction::none;
    in_stage_s_ += events.elapsed_s;
    if (events.has_send_failed && stage_ > Stage::quiet) climb();
    if (state_ != ResyncState::under_way) return ResyncAction::none;
    if (stage_ == Stage::quiet) owed_ -= events.good_replies + events.bad_packets;
    if (stage_ == Stage::quiet && is_quiet())
        go(attempt_of(rung_).sets_up ? Stage::set_up : Stage::prime);
    const bool is_setting_up = stage_ == Stage::prime && attempt_of(rung_).sets_up;
    if (stage_ == Stage::quiet || (is_setting_up && in_stage_s_ < set_up_s))
        return ResyncAction::none;
    if (stage_ == Stage::reply || stage_ == Stage::proof) return listen(events);
    if (!events.is_send_free) {
        if (in_stage_s_ > longest_end_of_send_s) climb();
        return ResyncAction::none;
    }
    switch (stage_) {
        case Stage::flush:
            go(Stage::quiet);
            return ResyncAction::flush;
        case Stage::set_up:
            go(Stage::prime);
            return ResyncAction::set_up;
        default:
            go(Stage::reply);
            return ResyncAction::write_zero;
    }
}

// A late reply must not pass for the reply to the zero write.
bool Resync::is_quiet() const {
    const bool is_settling = rung_ == Rung::settle && owed_ > 0;
    return in_stage_s_ >= (is_settling ? late_s : attempt_of(rung_).quiet_s);
}

ResyncAction Resync::listen(const ResyncEvents& events) {
    const int allowed = stage_ == Stage::reply ? 1 : 0;
    if (events.bad_packets > 0 || events.good_replies > allowed) {
        climb();
    } else if (stage_ == Stage::reply && events.good_replies == 1) {
        go(Stage::proof);
    } else if (stage_ == Stage::proof && in_stage_s_ >= proof_s) {
        state_ = ResyncState::in_step;
    } else if (stage_ == Stage::reply && in_stage_s_ > attempt_of(rung_).reply_s) {
        climb();
    }
    return ResyncAction::none;
}

}  // namespace touchline
