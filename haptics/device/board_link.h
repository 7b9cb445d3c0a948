// One opened board, whatever carries the bytes. A command is one transfer, a reply is one packet.
// send() and receive() never block: the driver submits at the end of a tick and looks for the
// answer at the next one. Nothing here waits but rest() and set_lines().
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace touchline {

/// done. under_way: not ended yet, or nothing has come. timed_out: given up, or called back. gone:
/// the board is unplugged. stalled: the endpoint is halted until clear_stall(). failed: anything
/// else.
enum class LinkStatus : std::uint8_t { done, under_way, timed_out, gone, stalled, failed };

/// How the newest send() ended.
struct Sent {
    LinkStatus status = LinkStatus::done;  // done when nothing was ever sent
    std::size_t bytes = 0;                 // that the board took
};

/// A packet from the board; 64 bytes are the largest there are.
struct Received {
    LinkStatus status = LinkStatus::under_way;
    std::array<std::uint8_t, 64> data{};
    std::size_t size = 0;

    [[nodiscard]] std::span<const std::uint8_t> packet() const { return {data.data(), size}; }
};

/// Threads: one at a time. No call logs; send(), sent() and receive() allocate and lock nothing of
/// their own (usb_link.h says what libusb does). Destroying it gives the board back: transfers
/// cancelled, lines low.
class BoardLink {
  public:
    BoardLink() = default;
    virtual ~BoardLink() = default;
    BoardLink(const BoardLink&) = delete;
    BoardLink(BoardLink&&) = delete;
    BoardLink& operator=(const BoardLink&) = delete;
    BoardLink& operator=(BoardLink&&) = delete;

    /// Starts one transfer with the whole command, at most 64 bytes. The status is done when it is
    /// on its way, under_way when the one before has not ended: then nothing was started.
    [[nodiscard]] virtual LinkStatus send(std::span<const std::uint8_t> command) = 0;

    /// Ends as timed_out after the link's own time-out at the latest.
    [[nodiscard]] virtual Sent sent() = 0;

    /// Calls the newest send back: it ends as timed_out as soon as it can, with the bytes that the
    /// board took, which may be all. Nothing where none is under way.
    virtual void cancel_send() = 0;

    /// The oldest packet not taken yet, which may be empty; under_way: there is none.
    [[nodiscard]] virtual Received receive() = 0;

    /// DTR and RTS, 115200 baud 8N1: never 1200, at which the board erases its firmware. Waits.
    [[nodiscard]] virtual LinkStatus set_lines(bool are_high) = 0;

    /// Has both endpoints work again, in the background: under_way until they do, or cannot. Each
    /// call looks what became of it; the first one after an end begins anew.
    [[nodiscard]] virtual LinkStatus clear_stall() = 0;

    /// Lets span_s pass.
    virtual void rest(double span_s) = 0;
};

}  // namespace touchline
