// What the kernel does with the requests of usbfs, done by the emulated board: transfers submitted,
// completed, reaped, discarded. Threads: one at a time.
#pragma once

#include "tests/sim/board/board_emulator.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <umockdev.h>

namespace touchline {

/// What the next transfers run into, in the order of their kind.
struct UsbFaults {
    bool is_held = false;  // claiming fails: another program has the interface
    int stalls_out = 0;    // OUT transfers that halt the endpoint
    int drops_out = 0;     // OUT transfers that hang until they are given up
    int short_out = 0;     // OUT transfers of which only 4 bytes get through
    int lost_in = 0;       // packets that never come
    int late_in = 0;       // packets that come late_s later, and all after them
    double late_s = 0.0;
    int garbled_in = 0;  // packets with flipped bits
    int doubled_in = 0;
    int empty_in = 0;  // empty packets before the real one
    int stalls_in = 0;
    int unplug_after_out = 0;  // the plug goes with the n-th OUT transfer from now
};

class UsbRequests {
  public:
    explicit UsbRequests(BoardEmulator& board) : board_(board) {}

    /// Answers the request. The board's clock is at now.
    void handle(UMockdevIoctlClient* client);

    UsbFaults faults;

  private:
    struct Urb {
        UMockdevIoctlData* data = nullptr;
        UMockdevIoctlData* buffer = nullptr;
        std::uint8_t endpoint = 0;
    };

    void submit(UMockdevIoctlClient* client, UMockdevIoctlData* arg);
    void submit_control(std::uint64_t id, usbdevfs_urb& urb);
    void submit_out(std::uint64_t id, const usbdevfs_urb& urb);
    void reap(UMockdevIoctlClient* client, UMockdevIoctlData* arg);
    void discard(UMockdevIoctlClient* client, UMockdevIoctlData* arg);
    void deliver();
    void spoil(PacketBytes packet);
    void finish(std::uint64_t id, int status, const PacketBytes& data, std::size_t actual,
                std::size_t offset);
    void end_all(int status);
    [[nodiscard]] bool is_under_way(std::uint64_t id) const;

    BoardEmulator& board_;
    std::map<std::uint64_t, Urb> urbs_;    // by the program's address
    std::deque<std::uint64_t> listening_;  // IN transfers that wait
    std::deque<PacketBytes> ready_;        // packets that nobody waits for
    std::deque<std::uint64_t> done_;
    std::deque<PacketBytes> held_back_;  // until held_until_s_
    double held_until_s_ = 0.0;
    bool is_out_halted_ = false, is_in_halted_ = false;
};

}  // namespace touchline
