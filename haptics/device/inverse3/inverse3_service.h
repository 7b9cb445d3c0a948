// The conversation with the maker's service through its WebSocket on this computer. A thread of its
// own sends and hears; the tick only leaves its newest force and takes the newest news.
#pragma once

#include "config/types/result.h"
#include "haptics/device/inverse3/inverse3_link.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace touchline {

inline constexpr std::uint16_t inverse3_port = 10001;  // of the loopback

/// Threads: as Inverse3Link; cut() from any.
class Inverse3Service final : public Inverse3Link {
  public:
    /// Waits 2 s at most for the service and until a device is chosen: the one of this name; empty:
    /// the only one. Asks `goes_on`, if there is one, every few milliseconds, and gives up if it is
    /// false. The error says what is missing. The device may still be unfit for force, which its
    /// news tell. The thread has the caller's scheduling. Allocates.
    [[nodiscard]] static Result<std::unique_ptr<Inverse3Service>> connect(
        std::string_view name, std::uint16_t port = inverse3_port,
        const std::function<bool()>& goes_on = {});

    /// Whether anything listens at the port.
    [[nodiscard]] static bool answers(std::uint16_t port = inverse3_port);

    /// Tells zero and closes the conversation. Waits 0.1 s at most.
    ~Inverse3Service() override;

    /// The device's, as it was chosen.
    [[nodiscard]] std::string name() const;

    [[nodiscard]] ArmNews news() override;

    /// Makes one call of the system, which wakes the thread.
    void tell(const WantedArmForce& wanted) override;

    void rest(double span_s) override;

    /// From now on only zero is told, whatever is wanted. Returns true once that was sent, which
    /// it waits for, for 5 ms at most. Also for a signal handler, as long as the thread is alive:
    /// it neither allocates nor locks.
    bool cut() noexcept;

  private:
    class Talk;

    explicit Inverse3Service(std::unique_ptr<Talk> talk);

    std::unique_ptr<Talk> talk_;
};

}  // namespace touchline
