// Emulated devices in real time behind what a program opens: a terminal of the system, or a socket
// that carries CAN frames. Each has a thread of its own, which alone may touch the device.
#pragma once

#include "config/types/pinned.h"
#include "tests/machines/sim/drives/serial_peer.h"
#include "tests/machines/sim/moteus/moteus_bus.h"

#include <array>
#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace touchline {

/// Calls `step` with the time since the start, every 0.1 ms, until it ends.
class RealTimeThread : private Pinned {
  public:
    explicit RealTimeThread(std::function<void(double)> step);

    ~RealTimeThread() { stop(); }

    /// Afterwards the device may be looked at.
    void stop();

  private:
    std::function<void(double)> step_;
    std::atomic<bool> is_ending_{false};
    std::thread thread_;
};

/// A pseudo-terminal with a device at its other end.
class PtyHost : private Pinned {
  public:
    explicit PtyHost(SerialPeer& peer);
    ~PtyHost();

    /// What a program opens.
    [[nodiscard]] const std::string& path() const { return path_; }

    /// The plug is pulled; what was written before still arrives.
    void unplug();

    /// The device goes on without the line until `span_s` later, then stands still.
    void end_after(double span_s);

  private:
    void step(double now_s);

    SerialPeer& peer_;
    int master_ = -1;
    std::atomic<bool> is_unplugged_{false};
    std::string path_;
    std::optional<SentBytes> due_;
    RealTimeThread thread_;
};

/// A socket with a device at its other end. For a program that runs with the library
/// socket_terminal before all others, its path is a port like a terminal's; but the kernel carries
/// the bytes at once, where those of a pseudo-terminal wait for a worker that a busy machine holds
/// up.
class SocketHost : private Pinned {
  public:
    explicit SocketHost(SerialPeer& peer);
    ~SocketHost();

    /// What a program opens, below /dev as settings want it; the one that opens it last is served.
    [[nodiscard]] const std::string& path() const { return path_; }

  private:
    void step(double now_s);

    SerialPeer& peer_;
    std::string path_;
    int door_ = -1;
    int client_ = -1;
    std::optional<SentBytes> due_;
    RealTimeThread thread_;
};

/// One end of a pair of sockets, as a CAN bus with two controllers.
class CanHost : private Pinned {
  public:
    explicit CanHost(MoteusBus& bus);
    ~CanHost();

    /// The end for the program, which takes it over.
    [[nodiscard]] int take_socket() { return std::exchange(ends_[1], -1); }

    void end_after(double span_s);

  private:
    void step(double now_s);

    MoteusBus& bus_;
    std::array<int, 2> ends_;  // of the bus and of the program
    std::optional<SentFrame> due_;
    RealTimeThread thread_;
};

}  // namespace touchline
