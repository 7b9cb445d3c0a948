// What a controller and the kernel do with transfers to and from the emulated board: submitted,
// completed, reaped, discarded; with faults. For every way in which a program gets at it.
// Threads: as BoardEmulator.
#pragma once

#include "tests/sim/board/board_emulator.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>

namespace touchline {

/// What the next transfers run into, in the order of their kind.
struct UsbFaults {
    bool is_held = false;  // claiming fails: another program has the interface
    int stalls_out = 0;    // OUT transfers that halt the endpoint
    int drops_out = 0;     // OUT transfers that hang until they are given up
    int short_out = 0;     // OUT transfers of which only 4 bytes get through
    int lost_in = 0;       // packets that never come
    int late_in = 0;       // packets that come late_s later, and all after them
    double late_s = 0.0;
    int garbled_in = 0;  // packets with flipped bits
    int doubled_in = 0;
    int empty_in = 0;  // empty packets before the real one
    int stalls_in = 0;
    int unplug_after_out = 0;  // the plug goes with the n-th OUT transfer from now
};

class UsbTransfers {
  public:
    /// A transfer that has ended. status: 0 or an error number, negative. sent: its bytes that got
    /// through, of an OUT transfer.
    struct Ended {
        std::uint64_t id = 0;
        int status = 0;
        PacketBytes received;
        std::size_t sent = 0;
    };

    explicit UsbTransfers(BoardEmulator& board) : board_(board) {}

    void send(std::uint64_t id, std::span<const std::uint8_t> bytes);
    /// What send() would come to, at once and not to be reaped; nothing: it hangs.
    [[nodiscard]] std::optional<Ended> sent(std::uint64_t id, std::span<const std::uint8_t> bytes);
    void listen(std::uint64_t id, std::uint8_t endpoint);
    /// The eight bytes of the request, and data after them.
    void control(std::uint64_t id, std::span<const std::uint8_t> bytes);

    /// False: no such transfer is under way.
    bool discard(std::uint64_t id);

    /// All that are under way end so.
    void end_all(int status);

    /// Nobody is there any more to reap what has ended.
    void forget_all();

    void clear_halts() { is_out_halted_ = is_in_halted_ = false; }

    /// Packets that have come go to those who listen. The board's clock is at now.
    void deliver();

    [[nodiscard]] bool has_ended() const { return !ended_.empty(); }

    [[nodiscard]] std::optional<Ended> reap();

    [[nodiscard]] bool is_plugged() const { return board_.is_plugged(); }

    UsbFaults faults;

  private:
    void spoil(PacketBytes packet);

    BoardEmulator& board_;
    std::map<std::uint64_t, std::uint8_t> under_way_;  // to the endpoint that it waits at
    std::deque<std::uint64_t> listening_;              // to the board's packets
    std::deque<PacketBytes> ready_;                    // packets that nobody waits for
    std::deque<Ended> ended_;
    std::deque<PacketBytes> held_back_;  // until held_until_s_
    double held_until_s_ = 0.0;
    bool is_out_halted_ = false, is_in_halted_ = false;
};

}  // namespace touchline
