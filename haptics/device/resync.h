// Finds the way back to a board that answers one write with one reply. Attempts form a ladder, each
// slower and surer than the one before. Time and events go in, what to send comes out.
// Threads: a plain value. No allocation, clock or log. O(1).
#pragma once

#include <cstdint>

namespace touchline {

/// Where to start: settle if only an answer went astray; opening and set_up_again if the board must
/// be told everything; flush if it may wait for the rest of a command.
enum class Rung : std::uint8_t {
    settle,
    set_up_again,
    opening,
    flush,
    wait_out,
    wait_again,
    wait_last,
    lost
};

/// What the driver must send now.
enum class ResyncAction : std::uint8_t { none, flush, set_up, write_zero };

enum class ResyncState : std::uint8_t { under_way, in_step, lost };

/// What came since the last step.
struct ResyncEvents {
    double elapsed_s = 0.0;
    int good_replies = 0;  // angles
    int bad_packets = 0;   // any other that is not empty
    bool is_send_free = true;
    bool has_send_failed = false;
};

class Resync {
  public:
    /// Starts in step, with nothing to do.
    Resync() = default;

    /// owed >= 0 is the number of replies to earlier writes that may still come.
    Resync(Rung first, int owed) : owed_(owed) { enter(first); }

    /// Call it until state() is no longer under_way, at least every few ms. Send the action at
    /// once; is_send_free says that this is possible.
    [[nodiscard]] ResyncAction step(const ResyncEvents& events);

    /// Notes that one more write was sent whose reply does not matter.
    void owe_one() { ++owed_; }

    [[nodiscard]] ResyncState state() const { return state_; }

  private:
    enum class Stage : std::uint8_t { flush, quiet, set_up, prime, reply, proof };

    void enter(Rung rung);
    void go(Stage stage);
    void climb();
    [[nodiscard]] bool is_quiet() const;
    [[nodiscard]] ResyncAction listen(const ResyncEvents& events);

    ResyncState state_ = ResyncState::in_step;
    Rung rung_ = Rung::settle;
    Stage stage_ = Stage::quiet;
    double in_stage_s_ = 0.0;
    int owed_ = 0;
};

}  // namespace touchline
