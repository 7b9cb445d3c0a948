// Clears halted endpoints of a USB board on a thread of its own: libusb can only do so with a
// control transfer that it waits for, and a tick must not wait. Only for usb_link.cpp.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <semaphore>
#include <thread>

#include <libusb.h>

namespace touchline {

/// Threads: step() one at a time, and it neither waits nor allocates. The destructor waits for a
/// transfer that is under way; the system may take some seconds to give it up.
class StallClearer {
  public:
    /// `handle` must outlive it.
    StallClearer(libusb_device_handle* handle, std::array<std::uint8_t, 2> endpoints);
    ~StallClearer();
    StallClearer(const StallClearer&) = delete;
    StallClearer(StallClearer&&) = delete;
    StallClearer& operator=(const StallClearer&) = delete;
    StallClearer& operator=(StallClearer&&) = delete;

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

}  // namespace touchline
