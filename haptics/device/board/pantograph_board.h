// A pantograph behind a board: the driver over any BoardLink. It writes once at the end of a tick
// and reads the reply at the next. The board holds the last torque forever, so if anything goes
// wrong, a zero is sent first. While driver and board are out of step, no angles are given and no
// torque is passed on.
#pragma once

#include "config/types/calibration.h"
#include "config/types/result.h"
#include "haptics/device/asked_times.h"
#include "haptics/device/board/board_frame.h"
#include "haptics/device/board/board_link.h"
#include "haptics/device/joint_device.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace touchline {

// Finds the way back to a board that answers one write with one reply. Attempts form a ladder, each
// slower and surer than the one before. Time and events go in, what to send comes out. A plain
// value; no allocation, clock or log. O(1).

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

/// From good to bad. ready: one reply per write. resyncing: the driver finds its way back by
/// itself, and force is zero. jumped: the angles leapt, until accept_position(). lost: unplugged or
/// given up.
enum class BoardState : std::uint8_t { closed, ready, resyncing, jumped, lost };

/// What the driver saw, for the operator and the log. Counts start when it is made.
struct BoardReport {
    BoardState state = BoardState::closed;
    bool is_position_doubtful = false;  // counts may have been missed: go home again
    bool was_torque_not_finite = false;
    LinkStatus last_failure = LinkStatus::done;  // the link's
    std::uint64_t replies = 0;
    std::uint64_t late = 0;  // ticks that used the angles of the tick before
    std::uint64_t lost_replies = 0;
    std::uint64_t empty_packets = 0;
    std::uint64_t wrong_packets = 0;  // wrong length, address or count, or one too many
    std::uint64_t unconfigured = 0;
    std::uint64_t jumps = 0;  // to angles that no hand could reach
    std::uint64_t resyncs = 0;
};

/// Threads: as ForceDevice. Only open(), end_in_zero(), stop() and the destructor wait.
class PantographBoard final : public JointDevice {
  public:
    PantographBoard(std::unique_ptr<BoardLink> link, const DeviceProfile& profile,
                    const Calibration& calibration);
    /// Calls stop().
    ~PantographBoard() override;

    /// Call with the handle at home, unless set_calibration() will say where home was. Raises the
    /// lines, drains, sets the board up, writes zero and checks the replies exactly. Takes 30 ms,
    /// or up to 4 s before it fails.
    [[nodiscard]] Result<void> open();

    /// Goes on where another program, which set the board up and drove it with this calibration,
    /// saw the handle last, at `last`, `age_s` ago. Does what is done when a reply went astray:
    /// raises the lines, drains, writes zero and wants exactly one reply, with angles that a hand
    /// can have reached meanwhile. Returns false if there is any doubt that the board counted all
    /// the time: it was not set up, had to be set up, or the handle leapt. open() must come then.
    /// Not for a handle that turns. Takes 10 ms, or up to 4 s before it fails.
    [[nodiscard]] bool take_over(JointAngles last, double age_s);

    /// Returns the newest reply's angles, to half a count. Returns nothing while resyncing, jumped
    /// or lost, and at most 4 ms after the tick in which the reply came.
    [[nodiscard]] std::optional<JointAngles> read_angles(double now_s) override;

    /// Scales torques to the limit. For zero, returns true once the send of a zero has ended and
    /// only zeros were sent since, so at the call after the first at the earliest. For other
    /// torques, returns false if they could not be passed on. A torque that is not finite counts as
    /// zero and is reported.
    [[nodiscard]] bool write_torques(JointTorques torques) override;

    /// Writes zeros until write_torques({}) would return true, whatever is under way; a send that
    /// hangs is cancelled. Takes a millisecond or two, or 20 before it gives up. For callers that
    /// have no next tick.
    bool end_in_zero();

    [[nodiscard]] Freshness freshness() const override { return freshness_; }

    [[nodiscard]] std::optional<double> handle_angle_rad() const override;

    void turn_handle(double torque_Nm) override;

    /// Takes effect from the next call on. Call it only while no force acts. The position counts as
    /// known afterwards. The driver never forgets that a board has all counts, once an odd count
    /// has shown it.
    void set_calibration(const Calibration& calibration);

    /// After `jumped`, or in doubt: takes the angles as they are. Call it only with the force off.
    void accept_position();

    /// Writes zero torque, then a set-up if that is not answered, then lowers the lines and gives
    /// the board back. Also works for a board that was never opened here. Takes 10 ms, or up to 4 s
    /// before it gives up. Returns true if the board confirmed zero. Nothing is read or written
    /// afterwards.
    bool stop();

    [[nodiscard]] const BoardReport& report() const { return report_; }

    [[nodiscard]] const BoardFrame& frame() const { return frame_; }

  private:
    /// What the board reports of its encoders.
    struct Said {
        PortAngles joints;
        double handle_deg = 0.0;  // if the handle turns
    };

    struct Arrivals {
        int good = 0, bad = 0, unconfigured = 0;
        std::optional<Said> newest;
    };

    [[nodiscard]] Arrivals take_packets();
    void sort(const Received& received, Arrivals& arrivals);
    void judge_send();
    void clear_stall();
    void follow(const Arrivals& arrivals);
    void judge_age(double elapsed_s);
    void judge_position(const Said& raw);
    void start_resync(Rung first);
    void step_resync(const Arrivals& arrivals, double elapsed_s);
    void run_resync();
    [[nodiscard]] bool is_jump(const Said& raw) const;
    [[nodiscard]] Command zero_command() const;
    bool send(const Command& command);
    void note(LinkStatus status);
    void owe_a_reply();

    [[nodiscard]] bool is_send_free() const { return sending_.size == 0 && !is_stalled_; }

    /// A command whose end has not been seen yet.
    struct Sending {
        std::size_t size = 0;  // bytes; 0: none
        bool is_zero = false;  // a write of zero torque
        bool is_rest = false;  // completes a write that was cut off
        double age_s = 0.0;
    };

    std::unique_ptr<BoardLink> link_;
    BoardFrame frame_;
    Resync resync_;
    BoardReport report_;
    std::optional<Said> raw_;       // last accepted
    PortAngles steady_;             // follows it with half a count of play
    std::optional<Said> heard_;     // last one that came while resyncing
    double handle_Nm_ = 0.0;        // goes with the next write
    std::optional<double> last_s_;  // on the caller's clock
    double raw_age_s_ = 0.0;        // since raw_ came
    Freshness freshness_;           // of raw_
    AskedTimes asked_;              // a reply is to the oldest write that is owed one
    double owed_age_s_ = 0.0;       // since every reply was last in
    int owed_ = 0;                  // replies
    int jumps_in_a_row_ = 0;
    double jump_age_s_ = 0.0;  // raw_age_s_ at the first of them
    Sending sending_;
    bool holds_zero_ = false;        // the newest write that the board took is a zero
    int untaken_in_a_row_ = 0;       // sends of which the board took nothing
    bool is_stalled_ = false;        // until clear_stall() has ended
    bool is_zero_due_ = false;       // as soon as a send is free, before the resync's own
    bool is_old_send_open_ = false;  // sending_ began before the resync
    bool has_send_failed_ = false;   // since the last step of the resync
};

/// What a board that somebody else drove came to. kept: it holds zero torque, was set up all the
/// time and counts on. unknown: it holds zero torque, but had to be set up.
enum class ZeroedBoard : std::uint8_t { not_confirmed, unknown, kept };

/// Makes it hold zero torque, as stop() does.
[[nodiscard]] ZeroedBoard zero_board(std::unique_ptr<BoardLink> link, const DeviceProfile& profile);

/// Makes a board hold zero torque that somebody else drove, as stop() does. A board that does not
/// answer is set up again, which stops its motors but forgets where the handle is. Returns true if
/// the board confirmed zero. `profile` tells whether a motor at the handle must be stopped too.
bool zero_torque(std::unique_ptr<BoardLink> link, const DeviceProfile& profile = default_profile());

}  // namespace touchline
