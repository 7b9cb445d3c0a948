// An emulated device that speaks usbredir, the protocol of QEMU's usb-redir device: a virtual
// machine sees it on its own USB controller, and its kernel drives it like the real one.
#pragma once

#include "config/types/pinned.h"
#include "tests/machines/sim/board/usb_function.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>

#include <usbredirparser.h>

namespace touchline {

/// The emulated device. Bulk transfers go to one endpoint each way.
class RedirectedFunction : public Interface {
  public:
    [[nodiscard]] virtual std::uint8_t speed() const = 0;  // usb_redir_speed_...
    [[nodiscard]] virtual PacketBytes device() const = 0;
    [[nodiscard]] virtual PacketBytes configuration() const = 0;
    /// Returns the answer to a control request; nothing if it stalls. `data`: sent with a request
    /// to the device.
    [[nodiscard]] virtual std::optional<PacketBytes> control(
        const UsbRequest& request, std::span<const std::uint8_t> data) = 0;
    /// Tells whether the host has queued reads.
    virtual void listens(bool is_listening) = 0;
    /// The host writes.
    virtual void sends(std::span<const std::uint8_t> data) = 0;
    /// Returns what the device has for a read of at most this many bytes.
    [[nodiscard]] virtual std::optional<PacketBytes> take(std::size_t most_bytes) = 0;
    /// Real time passes.
    virtual void advance_to(double now_s) = 0;
    [[nodiscard]] virtual bool is_plugged() const = 0;
};

/// Opens a unix socket that QEMU may connect to; returns the descriptor, or -1.
[[nodiscard]] int listen_at(const char* path);

/// One connection. Threads: one.
class RedirectedDevice : private Pinned {
  public:
    /// Takes a connected socket and closes it at the end.
    RedirectedDevice(RedirectedFunction& function, int socket);
    ~RedirectedDevice();

    /// Serves in real time, until the other side or the plug has gone.
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

    RedirectedFunction& function_;
    int socket_;
    usbredirparser* parser_;
    std::deque<Listening> listening_;
};

}  // namespace touchline
