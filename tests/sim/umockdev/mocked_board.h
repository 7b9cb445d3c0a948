// The emulated board behind libusb: umockdev shows this process a USB device whose system calls end
// here. The process must run under umockdev-wrapper. Real time drives the emulator.
#pragma once

#include "tests/sim/board/board_emulator.h"
#include "tests/sim/umockdev/usb_requests.h"

#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include <umockdev.h>

namespace touchline {

/// All of the mocked USB of this process. Threads: calls from one; umockdev's own thread answers.
class MockedUsb {
  public:
    MockedUsb();
    ~MockedUsb();
    MockedUsb(const MockedUsb&) = delete;
    MockedUsb(MockedUsb&&) = delete;
    MockedUsb& operator=(const MockedUsb&) = delete;
    MockedUsb& operator=(MockedUsb&&) = delete;

    [[nodiscard]] UMockdevTestbed* testbed() { return testbed_; }

    /// Where its files really are.
    [[nodiscard]] std::string folder() const;

    /// A device's node for programs, as they see it.
    [[nodiscard]] static std::string node_of(int device_number);

    /// What udev says about the board, with its descriptors, from now on. port: of the only hub, 1
    /// to 9.
    void show(const BoardEmulator& board, int port, int device_number);

  private:
    UMockdevTestbed* testbed_;
};

/// One board on it, plugged in at once. Threads: as MockedUsb.
class MockedBoard {
  public:
    /// port: of the only hub, 1 to 9. path: of the hand; none: it rests at home.
    MockedBoard(MockedUsb& usb, const BoardTruth& truth, int port = 1,
                std::shared_ptr<const IntendedPath> path = nullptr);
    ~MockedBoard();
    MockedBoard(const MockedBoard&) = delete;
    MockedBoard(MockedBoard&&) = delete;
    MockedBoard& operator=(const MockedBoard&) = delete;
    MockedBoard& operator=(MockedBoard&&) = delete;

    void unplug();
    /// Under another device number.
    void plug();

    /// The device number that it has now.
    [[nodiscard]] int device_number() const { return device_number_; }

    /// Its node for programs, as they see it.
    [[nodiscard]] std::string node() const;

    /// With the board at rest and its clock at now.
    void with(const std::function<void(BoardEmulator&, UsbFaults&)>& look);

  private:
    static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer board);
    void show();

    MockedUsb& usb_;
    int port_;
    int device_number_ = 1;
    std::string path_;  // in sysfs, while plugged in
    std::mutex mutex_;  // board_, requests_
    BoardEmulator board_;
    UsbRequests requests_;
    double start_s_;
    UMockdevIoctlBase* handler_ = nullptr;
};

}  // namespace touchline
