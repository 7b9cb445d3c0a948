// One opened board, over any transport. A command is one transfer, a reply is one packet. send()
// and receive() never block: the driver submits at the end of a tick and looks for the answer at
// the next one. Only rest() and set_lines() wait.
#pragma once

#include "config/types/pinned.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace touchline {

/// done. under_way: not ended yet, or nothing has come. timed_out: given up, or cancelled. gone:
/// the board is unplugged. stalled: the endpoint is halted until clear_stall(). failed: anything
/// else.
enum class LinkStatus : std::uint8_t { done, under_way, timed_out, gone, stalled, failed };

/// How the newest send() ended.
struct Sent {
    LinkStatus status = LinkStatus::done;  // done if nothing was ever sent
    std::size_t bytes = 0;                 // taken by the board
};

/// A packet from the board, at most 64 bytes.
struct Received {
    LinkStatus status = LinkStatus::under_way;
    std::array<std::uint8_t, 64> data{};
    std::size_t size = 0;

    [[nodiscard]] std::span<const std::uint8_t> packet() const { return {data.data(), size}; }
};

/// Threads: one at a time. No call logs; send(), sent() and receive() allocate and lock nothing of
/// their own (usb_link.h says what libusb does). The destructor gives the board back, with
/// transfers cancelled and lines low.
class BoardLink : public Interface {
  public:
    /// Starts one transfer with the whole command, at most 64 bytes. Returns done if it is on its
    /// way. Returns under_way if the one before has not ended; then it starts nothing.
    [[nodiscard]] virtual LinkStatus send(std::span<const std::uint8_t> command) = 0;

    /// How the newest send() ended. It ends as timed_out after the link's own time-out at the
    /// latest.
    [[nodiscard]] virtual Sent sent() = 0;

    /// Cancels the newest send: it ends as timed_out as soon as it can, with the bytes that the
    /// board took, which may be all. Does nothing if none is under way.
    virtual void cancel_send() = 0;

    /// Returns the oldest packet not taken yet, which may be empty; under_way if there is none.
    [[nodiscard]] virtual Received receive() = 0;

    /// Sets DTR and RTS at 115200 baud 8N1, never at 1200, at which the board erases its firmware.
    /// Waits.
    [[nodiscard]] virtual LinkStatus set_lines(bool are_high) = 0;

    /// Makes both endpoints work again, in the background. Each call returns under_way until they
    /// do or cannot; the first call after an end begins anew.
    [[nodiscard]] virtual LinkStatus clear_stall() = 0;

    /// Waits for span_s.
    virtual void rest(double span_s) = 0;
};

}  // namespace touchline
