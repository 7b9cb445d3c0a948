// The emulated board spoken of in usbredir, the protocol of QEMU's usb-redir device: a virtual
// machine sees it on its own USB controller, and its kernel drives it as it would the real one.
#pragma once

#include "tests/sim/board/board_emulator.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include <usbredirparser.h>

namespace touchline {

/// One connection. Threads: one.
class RedirectedBoard {
  public:
    /// A connected socket; closes it. The plug goes with the n-th write from the host (0: never).
    RedirectedBoard(BoardEmulator& board, int socket, int unplug_after_writes);
    ~RedirectedBoard();
    RedirectedBoard(const RedirectedBoard&) = delete;
    RedirectedBoard(RedirectedBoard&&) = delete;
    RedirectedBoard& operator=(const RedirectedBoard&) = delete;
    RedirectedBoard& operator=(RedirectedBoard&&) = delete;

    /// In real time, until the other side or the plug has gone.
    void serve();

  private:
    struct Listening {
        std::uint64_t id;
        usb_redir_bulk_packet_header header;
    };

    void connect();
    void control(std::uint64_t id, const usb_redir_control_packet_header& header,
                 std::span<const std::uint8_t> data);
    void bulk(std::uint64_t id, const usb_redir_bulk_packet_header& header,
              std::span<const std::uint8_t> data);
    void cancel(std::uint64_t id);
    void deliver();
    void flush();
    void set_callbacks();

    BoardEmulator& board_;
    int socket_;
    int writes_until_unplugged_;
    usbredirparser* parser_;
    std::deque<Listening> listening_;
};

}  // namespace touchline
