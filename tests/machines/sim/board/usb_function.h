// The emulated board on the USB, the same for every way to reach it: what it says about itself, how
// it answers control requests, and what a controller and the kernel do with transfers. Threads: as
// BoardEmulator.
#pragma once

#include "tests/machines/sim/board/board_emulator.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>

namespace touchline {

inline constexpr std::uint8_t board_out_endpoint = 0x02;
inline constexpr std::uint8_t board_in_endpoint = 0x83;

/// The eight bytes of a control request.
struct UsbRequest {
    std::uint8_t type = 0;
    std::uint8_t request = 0;
    std::uint16_t value = 0;
    std::uint16_t index = 0;
    std::uint16_t length = 0;
};

/// Parses the wire form of at least 8 bytes.
[[nodiscard]] UsbRequest request_of(std::span<const std::uint8_t> bytes);

[[nodiscard]] PacketBytes device_descriptor(const BoardEmulator& board);
[[nodiscard]] PacketBytes configuration_descriptor(const BoardEmulator& board);

/// Returns the board's answer, cut to the requested length; nothing if it stalls. `data`: sent with
/// a request to the board.
[[nodiscard]] std::optional<PacketBytes> answer(BoardEmulator& board, const UsbRequest& request,
                                                std::span<const std::uint8_t> data);

/// Faults of the next transfers of each kind, in order.
struct UsbFaults {
    bool is_held = false;  // claiming fails: another program has the interface
    int stalls_out = 0;    // OUT transfers that halt the endpoint
    int drops_out = 0;     // OUT transfers that hang until they are given up
    int short_out = 0;     // OUT transfers that get only 4 bytes through
    int lost_in = 0;       // packets that never come
    int late_in = 0;       // packets that come late_s later, and delay all after them
    double late_s = 0.0;
    int garbled_in = 0;  // packets with flipped bits
    int doubled_in = 0;
    int empty_in = 0;  // empty packets before the real one
    int stalls_in = 0;
    int unplug_after_out = 0;  // the n-th OUT transfer from now pulls the plug
};

/// What a controller and the kernel do with transfers to and from the emulated board: submit,
/// complete, reap, discard; with faults.
class UsbTransfers {
  public:
    /// A transfer that has ended. status: 0 or a negative error number. sent: bytes of an OUT
    /// transfer that got through.
    struct Ended {
        std::uint64_t id = 0;
        int status = 0;
        PacketBytes received;
        std::size_t sent = 0;
    };

    explicit UsbTransfers(BoardEmulator& board) : board_(board) {}

    void send(std::uint64_t id, std::span<const std::uint8_t> bytes);
    /// Returns how send() would end, at once and without reaping; nothing if it hangs.
    [[nodiscard]] std::optional<Ended> sent(std::uint64_t id, std::span<const std::uint8_t> bytes);
    void listen(std::uint64_t id, std::uint8_t endpoint);
    /// Takes the eight bytes of the request, followed by its data.
    void control(std::uint64_t id, std::span<const std::uint8_t> bytes);

    /// Returns false if no such transfer is under way.
    bool discard(std::uint64_t id);

    /// Ends all transfers that are under way with this status.
    void end_all(int status);

    /// Drops transfers that have ended, as nobody is left to reap them.
    void forget_all();

    void clear_halts() { is_out_halted_ = is_in_halted_ = false; }

    /// Gives arrived packets to waiting transfers. The board's clock must be at now.
    void deliver();

    [[nodiscard]] bool has_ended() const { return !ended_.empty(); }

    [[nodiscard]] std::optional<Ended> reap();

    [[nodiscard]] bool is_plugged() const { return board_.is_plugged(); }

    UsbFaults faults;

  private:
    void spoil(PacketBytes packet);

    BoardEmulator& board_;
    std::map<std::uint64_t, std::uint8_t> under_way_;  // the endpoint where each waits
    std::deque<std::uint64_t> listening_;              // transfers that wait for the board's
                                                       // packets
    std::deque<PacketBytes> ready_;                    // packets that no transfer waits for
    std::deque<Ended> ended_;
    std::deque<PacketBytes> held_back_;  // until held_until_s_
    double held_until_s_ = 0.0;
    bool is_out_halted_ = false, is_in_halted_ = false;
};

}  // namespace touchline
