// The emulated service behind a WebSocket on the loopback, in real time, on a thread of its own.
// Threads: any.
#pragma once

#include "config/types/pinned.h"
#include "tests/machines/sim/inverse3/service_emulator.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace touchline {

class ServiceServer : private Pinned {
  public:
    /// On a port that is free.
    ServiceServer(const ServiceTruth& truth, std::shared_ptr<const IntendedPath> path);
    ~ServiceServer();

    [[nodiscard]] std::uint16_t port() const;

    /// Runs `look` on the emulator as it is now, and returns its result.
    template <class Look>
    auto with(Look look) {
        decltype(look(std::declval<ServiceEmulator&>())) result{};
        look_at([&](ServiceEmulator& service) { result = look(service); });
        return result;
    }

    /// While hushed it takes frames and keeps its answers.
    void hush(bool is_hushed);

    /// Closes every conversation without a word.
    void drop();

    /// Sends a frame that nobody asked for to every client.
    void say(const std::string& text);

  private:
    void look_at(const std::function<void(ServiceEmulator&)>& look);

    class Rooms;
    std::unique_ptr<Rooms> rooms_;
};

}  // namespace touchline
