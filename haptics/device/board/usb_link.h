// An opened USB board as a BoardLink: asynchronous libusb transfers, one OUT and two IN under way.
// Only for usb_boards.cpp.
#pragma once

#include "config/types/pinned.h"
#include "haptics/device/board/board_link.h"
#include "haptics/device/board/usb_boards.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <semaphore>
#include <thread>

#include <libusb.h>

namespace touchline {

/// Clears halted endpoints on a thread of its own: libusb can only do so with a control transfer
/// that it waits for, and a tick must not wait. Threads: step() one at a time, and it neither waits
/// nor allocates. The destructor waits for a transfer that is under way; the system may take some
/// seconds to give it up.
class StallClearer : private Pinned {
  public:
    /// `handle` must outlive it.
    StallClearer(libusb_device_handle* handle, std::array<std::uint8_t, 2> endpoints);
    ~StallClearer();

    /// Starts, or looks at the result: returns nothing while it is under way, then once how it
    /// ended, a libusb_error or 0.
    [[nodiscard]] std::optional<int> step();

  private:
    enum class Work : std::uint8_t { none, wanted, ended };

    void clear_when_asked();

    libusb_device_handle* handle_;
    std::array<std::uint8_t, 2> endpoints_;
    std::atomic<Work> work_{Work::none};
    std::atomic<int> error_{0};  // from libusb, once the work has ended
    std::atomic<bool> is_closing_{false};
    std::binary_semaphore asked_{0};
    std::thread thread_;
};

/// send(), sent() and receive() make system calls but never wait. libusb itself allocates a small
/// block per transfer and takes its own locks, which nobody else holds.
class UsbLink final : public BoardLink {
  public:
    /// Both interfaces are claimed; `context` lives as long as the link. The destructor closes
    /// `handle`, and then the node that it was made from.
    UsbLink(std::shared_ptr<libusb_context> context, libusb_device_handle* handle, int node,
            const SerialPipes& pipes, unsigned send_time_out_ms);
    ~UsbLink() override;

    [[nodiscard]] LinkStatus send(std::span<const std::uint8_t> command) override;
    [[nodiscard]] Sent sent() override;
    void cancel_send() override;
    [[nodiscard]] Received receive() override;
    [[nodiscard]] LinkStatus set_lines(bool are_high) override;
    [[nodiscard]] LinkStatus clear_stall() override;
    void rest(double span_s) override;

  private:
    static constexpr std::size_t in_transfers = 2;
    static constexpr std::size_t most_waiting = 16;
    static constexpr std::size_t packet_bytes =
        512;  // of a high-speed board, the longest there are

    struct InTransfer {
        libusb_transfer* transfer = nullptr;
        std::array<std::uint8_t, packet_bytes> buffer{};
        bool is_under_way = false;
    };

    static void on_out(libusb_transfer* transfer);
    static void on_in(libusb_transfer* transfer);
    void end_in(InTransfer& in);
    void listen(InTransfer& in);
    void keep(const Received& received);
    void handle_events(double longest_s);
    [[nodiscard]] bool is_anything_under_way() const;
    void cancel_all();

    std::shared_ptr<libusb_context> context_;
    libusb_device_handle* handle_;
    int node_;
    SerialPipes pipes_;
    unsigned send_time_out_ms_;
    libusb_transfer* out_ = nullptr;
    std::array<std::uint8_t, 64> out_buffer_{};
    bool is_sending_ = false;
    Sent sent_;
    std::array<InTransfer, in_transfers> in_{};
    std::array<Received, most_waiting> waiting_{};  // by time; first_waiting_ is the oldest
    std::size_t first_waiting_ = 0;
    std::size_t waiting_count_ = 0;
    bool is_gone_ = false;
    bool is_closing_ = false;
    std::optional<StallClearer> stall_clearer_;  // ends before the handle is closed
};

}  // namespace touchline
