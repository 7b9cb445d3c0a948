// The emulated board as a file of the USB that programs open, pass on and close as they do the real
// one: FUSE brings their requests here, so that they may be killed in the middle of one. For what
// umockdev cannot: descriptors that two processes share, and processes that die.
#pragma once

#include "tests/sim/board/usb_transfers.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include <sys/types.h>

struct fuse_session;
struct fuse_pollhandle;

namespace touchline {

/// Puts this thread before everything that is tested, where that is granted.
void become_hardware();

/// Real time drives the board. Threads: calls from one; two of its own answer and deliver as
/// hardware does, which is never busy.
class UsbNodeServer {
  public:
    /// `path`: an existing file, which the board takes the place of. Fails without the right to
    /// mount.
    static std::unique_ptr<UsbNodeServer> create(const std::string& path, const BoardTruth& truth);
    ~UsbNodeServer();
    UsbNodeServer(const UsbNodeServer&) = delete;
    UsbNodeServer(UsbNodeServer&&) = delete;
    UsbNodeServer& operator=(const UsbNodeServer&) = delete;
    UsbNodeServer& operator=(UsbNodeServer&&) = delete;

    /// With the board at rest and its clock at now.
    void with(const std::function<void(BoardEmulator&, UsbFaults&)>& look);

  private:
    friend struct NodeOperations;

    explicit UsbNodeServer(const BoardTruth& truth);

    void advance();
    /// An error number, or 0; the answer's bytes, if any, in `answer`.
    int request(pid_t caller, std::uint64_t file, unsigned command, void* arg,
                std::string_view given, std::string& answer);
    int claim(std::uint64_t file, unsigned interface);
    int submit(pid_t caller, void* arg);
    int reap(pid_t caller, void* arg);
    int bulk(pid_t caller, std::uint64_t file, std::string_view given, int& sent);
    void release(std::uint64_t file);
    void wake();
    void deliver_all_the_time();

    std::mutex mutex_;  // all but the session
    BoardEmulator board_;
    UsbTransfers transfers_;
    double start_s_;
    PacketBytes descriptors_;
    std::uint64_t files_ = 0;                   // opened ever
    std::map<unsigned, std::uint64_t> claims_;  // of interfaces, by files
    /// Where in the program's memory the bytes of a transfer go, by the address of its own words.
    std::map<std::uint64_t, char*> buffers_;
    fuse_pollhandle* waiting_ = nullptr;
    fuse_session* session_ = nullptr;
    std::atomic<bool> is_ending_{false};
    std::thread answering_, delivering_;
};

}  // namespace touchline
