// One servo process at a simulated site, from its start to its end: what
// app/force/servo/servo_program.h does with the real driver, loop and messages, in the site's one
// thread and time. Threads: one.
#pragma once

#include "app/force/servo/messages.h"
#include "app/force/servo/watched_board.h"
#include "haptics/servo/servo_loop.h"
#include "tests/machines/sim/board/emulated_link.h"
#include "tests/machines/sim/kiosk/visitor_hand.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace touchline {

/// Breaks the product on purpose, to test that the checkers notice.
enum class Sabotage : std::uint8_t {
    none,
    doubled_torque,  // the driver gets twice what the servo tells
    held_torque,     // the driver never gets zero
    silent_sound,    // nothing that is said or given is heard
    deaf_guard,      // a silent servo is not killed
    lost_jobs,       // no picture ever comes
    kept_pages,      // what was printed stays in the printer's spool
    deaf_display,    // nothing that is said reaches the braille display
};

/// What the site gives a servo process. All must outlive it.
struct ServoPlace {
    BoardEmulator& board;
    VirtualTime& time;
    Clock& clock;
    VisitorHand& hand;
    Sabotage sabotage = Sabotage::none;
};

/// SIGKILL, thrown out of the loop's clock.
struct ServoKilled {};

class ServoLife {
  public:
    ServoLife(const ServoPlace& place, SharedRegion region, Descriptor socket)
        : place_(place), region_(std::move(region)), socket_(std::move(socket)) {}

    /// Opens and homes the board, then ticks until its end. Returns the exit status. Throws
    /// ServoKilled.
    [[nodiscard]] int run(const Calibration& stored);

    /// Does the main thread's work several times a second: reads messages, and checks that the
    /// device still answers.
    void serve();

    /// Kills the process: nothing of it reaches the board any more.
    void die();

    [[nodiscard]] bool is_ticking() const { return loop_start_s_.has_value(); }

    /// The board time at which the loop began.
    [[nodiscard]] double loop_start_s() const { return loop_start_s_.value_or(0.0); }

    /// Returns the newest tick; null before the first.
    [[nodiscard]] const TickRecord* newest() const { return recorder_.newest(); }

    /// Returns null once the board was given back.
    [[nodiscard]] EmulatedLink* link() { return link_; }

    void break_next_angle() { is_next_angle_broken_ = true; }

    /// The kiosk died: sends SIGHUP.
    void hang_up() { end_.is_cut = true; }

    [[nodiscard]] std::uint64_t dropped_events() const { return exchange_.dropped_events(); }

  private:
    class Device;

    void tell(MessageKind kind, const std::string& line) {
        (void)send(socket_, message_of(kind, line));
    }

    [[nodiscard]] int fail(const std::string& line) {
        tell(MessageKind::failed, line);
        return 1;
    }

    [[nodiscard]] Opening opening();
    void follow_hand();
    void end_homing();
    void feel(const Arrival& arrival);

    ServoPlace place_;
    SharedRegion region_;
    Descriptor socket_;
    std::unique_ptr<WatchedBoard> board_;
    EmulatedLink* link_ = nullptr;
    ServoExchange exchange_{region_.channel()};
    Recorder recorder_{1};
    LoopEnd end_;
    std::optional<double> loop_start_s_;
    double answered_s_ = 0.0;
    std::string lost_;  // why it ends
    bool is_next_angle_broken_ = false;
    bool is_held_ = true;  // while it is being homed
};

}  // namespace touchline
