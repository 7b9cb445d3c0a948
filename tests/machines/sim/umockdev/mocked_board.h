// The emulated board behind libusb: umockdev shows this process a USB device whose system calls end
// here. The process must run under umockdev-wrapper. Real time drives the emulator.
#pragma once

#include "config/types/pinned.h"
#include "tests/machines/sim/board/board_emulator.h"
#include "tests/machines/sim/board/usb_function.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <umockdev.h>

namespace touchline {

/// Handles usbfs requests as the kernel does, with the emulated board, for umockdev.
/// Threads: one at a time.
class UsbRequests {
  public:
    explicit UsbRequests(BoardEmulator& board) : transfers_(board) {}

    /// Answers the request. The board's clock must be at now.
    void handle(UMockdevIoctlClient* client);

    [[nodiscard]] UsbFaults& faults() { return transfers_.faults; }

  private:
    struct Urb {
        UMockdevIoctlData* data = nullptr;
        UMockdevIoctlData* buffer = nullptr;
    };

    void submit(UMockdevIoctlClient* client, UMockdevIoctlData* arg);
    void reap(UMockdevIoctlClient* client, UMockdevIoctlData* arg);

    UsbTransfers transfers_;
    std::map<std::uint64_t, Urb> urbs_;  // by the program's address
};

/// The whole mocked USB of this process. Threads: calls from one; umockdev's own thread answers.
class MockedUsb : private Pinned {
  public:
    MockedUsb();
    ~MockedUsb();

    [[nodiscard]] UMockdevTestbed* testbed() { return testbed_; }

    /// Returns where its files really are.
    [[nodiscard]] std::string folder() const;

    /// Returns a device's node, as programs see it.
    [[nodiscard]] static std::string node_of(int device_number);

    /// From now on udev shows the board, with its descriptors. port: of the only hub, 1 to 9.
    void show(const BoardEmulator& board, int port, int device_number);

  private:
    UMockdevTestbed* testbed_;
};

/// A board on the mocked USB, plugged in at once. Threads: as MockedUsb.
class MockedBoard : private Pinned {
  public:
    /// port: of the only hub, 1 to 9. path: the hand's; none: it rests at home.
    MockedBoard(MockedUsb& usb, const BoardTruth& truth, int port = 1,
                std::shared_ptr<const IntendedPath> path = nullptr);
    ~MockedBoard();

    void unplug();
    /// Plugs the board in under another device number.
    void plug();

    /// Returns the current device number.
    [[nodiscard]] int device_number() const { return device_number_; }

    /// Returns its node, as programs see it.
    [[nodiscard]] std::string node() const;

    /// Calls `look` while the board is at rest and its clock is at now.
    void with(const std::function<void(BoardEmulator&, UsbFaults&)>& look);

  private:
    static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer board);
    void show();

    MockedUsb& usb_;
    int port_;
    int device_number_ = 1;
    std::string path_;  // in sysfs, while plugged in
    std::mutex mutex_;  // guards board_, requests_
    BoardEmulator board_;
    UsbRequests requests_;
    double start_s_;
    UMockdevIoctlBase* handler_ = nullptr;
};

}  // namespace touchline
