#include "tests/machines/sim/drives/real_time_hosts.h"

#include "tests/machines/sim/hardware_thread.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include <fcntl.h>
#include <linux/can.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr auto real_time_step = std::chrono::microseconds(100);

int opened_master() {
    const int master = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    if (master < 0 || grantpt(master) != 0 || unlockpt(master) != 0)
        throw std::runtime_error("no pseudo-terminal");
    return master;
}

/// Carries what has come to the device, and what the device has said by now.
void carry(SerialPeer& peer, int descriptor, std::optional<SentBytes>& due, double now_s) {
    std::array<std::uint8_t, 512> got{};
    const ssize_t size = read(descriptor, got.data(), got.size());
    if (size > 0) peer.take({got.data(), static_cast<std::size_t>(size)});
    while (due || (due = peer.leave())) {
        if (due->at_s > now_s) return;
        (void)!write(descriptor, due->bytes.data(), due->bytes.size());
        due.reset();
    }
}

/// Listens at the path. A client that is gone must not end the test with SIGPIPE.
int opened_door(const std::string& path) {
    (void)std::signal(SIGPIPE, SIG_IGN);
    sockaddr_un place{};
    place.sun_family = AF_UNIX;
    path.copy(place.sun_path, sizeof place.sun_path - 1);
    const int door = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (door < 0 || bind(door, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0 ||
        listen(door, 8) != 0)
        throw std::runtime_error("no socket at " + path);
    return door;
}

std::array<int, 2> socket_pair() {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends.data()) != 0)
        throw std::runtime_error("no sockets");
    return ends;
}

}  // namespace

RealTimeThread::RealTimeThread(std::function<void(double)> step)
    : step_(std::move(step)), thread_([this] {
          become_hardware();
          const auto start = std::chrono::steady_clock::now();
          while (!is_ending_) {
              const auto now = std::chrono::steady_clock::now();
              step_(std::chrono::duration<double>(now - start).count());
              std::this_thread::sleep_for(real_time_step);
          }
      }) {}

void RealTimeThread::stop() {
    is_ending_ = true;
    if (thread_.joinable()) thread_.join();
}

PtyHost::PtyHost(SerialPeer& peer)
    : peer_(peer),
      master_(opened_master()),
      path_(ptsname(master_)),
      thread_([this](double now_s) { step(now_s); }) {}

PtyHost::~PtyHost() {
    thread_.stop();
    if (master_ >= 0) close(master_);
}

void PtyHost::step(double now_s) {
    peer_.advance_to(now_s);
    if (is_unplugged_) {
        if (master_ >= 0) close(std::exchange(master_, -1));
        return;
    }
    carry(peer_, master_, due_, now_s);
}

void PtyHost::unplug() {
    is_unplugged_ = true;
}

void PtyHost::end_after(double span_s) {
    std::this_thread::sleep_for(std::chrono::duration<double>(span_s));
    thread_.stop();
}

SocketHost::SocketHost(SerialPeer& peer)
    : peer_(peer),
      path_("/dev/shm/touchline-" + std::to_string(getpid()) + ".terminal"),
      door_(opened_door(path_)),
      thread_([this](double now_s) { step(now_s); }) {}

SocketHost::~SocketHost() {
    thread_.stop();
    if (client_ >= 0) close(client_);
    close(door_);
    std::filesystem::remove(path_);
}

void SocketHost::step(double now_s) {
    peer_.advance_to(now_s);
    if (const int next = accept4(door_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
        next >= 0) {
        if (client_ >= 0) close(client_);
        client_ = next;
    }
    carry(peer_, client_, due_, now_s);
}

CanHost::CanHost(MoteusBus& bus)
    : bus_(bus), ends_(socket_pair()), thread_([this](double now_s) { step(now_s); }) {}

CanHost::~CanHost() {
    thread_.stop();
    close(ends_[0]);
    if (ends_[1] >= 0) close(ends_[1]);
}

void CanHost::step(double now_s) {
    bus_.advance_to(now_s);
    canfd_frame got{};
    while (read(ends_[0], &got, sizeof got) == static_cast<ssize_t>(sizeof got)) {
        CanFrame frame;
        frame.id = got.can_id & CAN_EFF_MASK;
        frame.size = std::min<std::size_t>(got.len, frame.data.size());
        std::copy_n(got.data, frame.size, frame.data.begin());
        bus_.take(frame);
    }
    while (due_ || (due_ = bus_.leave())) {
        if (due_->at_s > now_s) return;
        canfd_frame sent{};
        sent.can_id = due_->frame.id | (due_->frame.id > CAN_SFF_MASK ? CAN_EFF_FLAG : 0U);
        sent.len = static_cast<std::uint8_t>(due_->frame.size);
        std::ranges::copy(due_->frame.bytes(), sent.data);
        (void)!write(ends_[0], &sent, sizeof sent);
        due_.reset();
    }
}

void CanHost::end_after(double span_s) {
    std::this_thread::sleep_for(std::chrono::duration<double>(span_s));
    thread_.stop();
}

}  // namespace touchline
