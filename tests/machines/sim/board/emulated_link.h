// The emulated board as a BoardLink in the same process, on a virtual clock that advances while
// somebody waits, with faults at chosen sends. Threads: one at a time.
#pragma once

#include "haptics/device/board/board_link.h"
#include "tests/machines/sim/board/board_emulator.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace touchline {

struct VirtualTime {
    double now_s = 0.0;
};

/// What goes wrong with one send or with the reply to it.
enum class LinkFault : std::uint8_t {
    none,
    short_send,        // only the first bytes get through, and the link says so
    late_send,         // hangs for a while, then gets through
    lost_send,         // never gets through: times out
    unconfirmed_send,  // gets through whole, but its end is never reported
    stalled_send,      // the OUT endpoint halts
    late_reply,
    lost_reply,
    garbled_reply,  // some bits flipped
    cut_reply,      // of the wrong length
    duplicate_reply,
    empty_packet,   // comes before the reply
    stalled_reply,  // the IN endpoint halts and loses the reply
    failed_reply,
    reset_board,  // the board forgets its set-up just before
    unplugged_before,
    unplugged_after,
    lost_counts,  // an encoder leaps
};

inline constexpr int link_faults = 18;

/// A fault at the send with this number, counted from 0.
struct PlannedFault {
    std::size_t at_send = 0;
    LinkFault fault = LinkFault::none;
    double span_s = 0.0;     // how late it is
    std::uint64_t seed = 0;  // for what is random
};

/// Gives the board back when destroyed: it stops listening and sets the lines low.
class EmulatedLink final : public BoardLink {
  public:
    /// Both must outlive it. It listens at once.
    EmulatedLink(BoardEmulator& board, VirtualTime& time, std::vector<PlannedFault> faults = {});
    ~EmulatedLink() override;

    [[nodiscard]] LinkStatus send(std::span<const std::uint8_t> command) override;
    [[nodiscard]] Sent sent() override;
    void cancel_send() override;
    [[nodiscard]] Received receive() override;
    [[nodiscard]] LinkStatus set_lines(bool are_high) override;
    [[nodiscard]] LinkStatus clear_stall() override;
    void rest(double span_s) override;

    /// Returns every command that was sent, whole; none while commands are only counted.
    [[nodiscard]] const std::vector<PacketBytes>& commands() const { return commands_; }

    /// From now on only counts commands, for runs of hours.
    void keep_no_commands() { keeps_commands_ = false; }

    /// Sets the fault of the next send and drops the planned ones. Ignores the fault's at_send.
    void spoil_next(PlannedFault fault) {
        fault.at_send = sends_;
        faults_ = {fault};
    }

    /// Each reply within span_s comes this much later.
    void slow(double late_s, double span_s) {
        slow_s_ = late_s;
        slow_until_s_ = time_.now_s + span_s;
    }

    /// Acts as if the process that holds the link was killed: its transfers are cancelled, nothing
    /// passes any more, and the board keeps what it was told last.
    void sever();

  private:
    struct Waiting {
        double at_s;
        LinkStatus status;
        PacketBytes bytes;
    };

    void catch_up();
    void hand_over(std::span<const std::uint8_t> command);
    void spoil(SentPacket packet);
    void arrive(double at_s, LinkStatus status, PacketBytes bytes);

    [[nodiscard]] bool is_gone() const { return is_severed_ || !board_.is_plugged(); }

    BoardEmulator& board_;
    VirtualTime& time_;
    std::vector<PlannedFault> faults_;
    std::vector<PacketBytes> commands_;
    std::size_t sends_ = 0;
    bool keeps_commands_ = true;
    bool is_severed_ = false;
    PlannedFault now_;  // of the newest send
    std::optional<PlannedFault> reply_fault_;
    double slow_s_ = 0.0, slow_until_s_ = 0.0;
    Sent sending_;
    double send_ends_s_ = 0.0;
    std::optional<PacketBytes> held_back_;  // command of a send that hangs
    std::deque<Waiting> waiting_;
    bool is_out_stalled_ = false, is_in_stalled_ = false;
    std::optional<double> stall_ends_s_;  // set once clearing was asked for
};

}  // namespace touchline
