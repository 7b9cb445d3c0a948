// The emulated board as a USB file that programs open, pass on and close like the real one. FUSE
// brings their requests here, so that they may be killed in the middle of one. It covers what
// umockdev cannot: descriptors that two processes share, and processes that die.
#pragma once

#include "config/types/pinned.h"
#include "tests/machines/sim/board/usb_function.h"
#include "tests/machines/sim/hardware_thread.h"

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

/// Real time drives the board.
/// Threads: calls from one; two own threads answer and deliver like hardware, which is never busy.
class UsbNodeServer : private Pinned {
  public:
    /// `path`: an existing file that the board replaces. Fails without the right to mount.
    static std::unique_ptr<UsbNodeServer> create(const std::string& path, const BoardTruth& truth);
    ~UsbNodeServer();

    /// Calls `look` while the board is at rest and its clock is at now.
    void with(const std::function<void(BoardEmulator&, UsbFaults&)>& look);

  private:
    friend struct NodeOperations;

    explicit UsbNodeServer(const BoardTruth& truth);

    void advance();
    /// Returns an error number or 0; `answer` gets the answer's bytes, if any.
    int request(pid_t caller, std::uint64_t file, unsigned command, void* arg,
                std::string_view given, std::string& answer);
    int claim(std::uint64_t file, unsigned interface);
    int submit(pid_t caller, void* arg);
    int reap(pid_t caller, void* arg);
    int bulk(pid_t caller, std::uint64_t file, std::string_view given, int& sent);
    void release(std::uint64_t file);
    void wake();
    void deliver_all_the_time();

    std::mutex mutex_;  // guards all but the session
    BoardEmulator board_;
    UsbTransfers transfers_;
    double start_s_;
    PacketBytes descriptors_;
    std::uint64_t files_ = 0;                   // opened so far
    std::map<unsigned, std::uint64_t> claims_;  // files by interface
    /// Where in the program's memory a transfer's bytes go, by the address of the program's urb.
    std::map<std::uint64_t, char*> buffers_;
    fuse_pollhandle* waiting_ = nullptr;
    fuse_session* session_ = nullptr;
    std::atomic<bool> is_ending_{false};
    std::thread answering_, delivering_;
};

}  // namespace touchline
