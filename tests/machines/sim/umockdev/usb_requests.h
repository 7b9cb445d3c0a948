// Handles usbfs requests as the kernel does, with the emulated board, for umockdev.
// Threads: one at a time.
#pragma once

#include "tests/machines/sim/board/usb_transfers.h"

#include <cstdint>
#include <map>

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <umockdev.h>

namespace touchline {

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

}  // namespace touchline
