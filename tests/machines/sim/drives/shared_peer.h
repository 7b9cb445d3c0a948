// A device at the other end of a serial line that a test looks at while a host serves it. Threads:
// any.
#pragma once

#include "tests/machines/sim/drives/serial_peer.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

namespace touchline {

/// Its clock goes on only while it is served.
class SharedPeer final : public SerialPeer {
  public:
    explicit SharedPeer(SerialPeer& peer) : peer_(peer) {}

    void advance_to(double t_s) override {
        const std::lock_guard lock(mutex_);
        now_s_ += std::min(t_s - std::exchange(last_s_, t_s), longest_turn_s);
        peer_.advance_to(now_s_);
    }

    void take(std::span<const std::uint8_t> bytes) override {
        const std::lock_guard lock(mutex_);
        peer_.take(bytes);
    }

    [[nodiscard]] std::optional<SentBytes> leave() override {
        const std::lock_guard lock(mutex_);
        if (!due_) due_ = peer_.leave();
        if (!due_ || due_->at_s > now_s_) return std::nullopt;
        SentBytes sent = *std::exchange(due_, std::nullopt);
        sent.at_s = 0.0;  // the host's clock is another one
        return sent;
    }

    /// Runs `look` on the controllers' time, which stands still meanwhile.
    template <class Look>
    auto with(Look look) {
        const std::lock_guard lock(mutex_);
        return look(now_s_);
    }

    static constexpr double longest_turn_s = 0.001;  // at once; more was the machine's

  private:
    SerialPeer& peer_;
    std::mutex mutex_;
    double now_s_ = 0.0, last_s_ = 0.0;
    std::optional<SentBytes> due_;
};

}  // namespace touchline
