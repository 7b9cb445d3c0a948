// What the two generations of sdbus-c++ call by different names, said once: 1 is Debian 12's, 2 is
// Debian 13's. Handlers take `(auto&& message)` and `(auto&& reply, const auto& error)`, for the
// one hands them a reference and a pointer, the other a value and an optional. Threads: those of
// the library.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include <sdbus-c++/sdbus-c++.h>

namespace touchline {

#if __has_include(<sdbus-c++/VTableItems.h>)  // only generation 2 has it

using sdbus::InterfaceName;
using sdbus::MethodName;
using sdbus::ServiceName;
using sdbus::SignalName;

inline void finish_registration(sdbus::IProxy&) {}  // a handler holds once it is registered

template <class Handler>
[[nodiscard]] sdbus::Slot match(sdbus::IConnection& bus, const std::string& rule, Handler handler) {
    return bus.addMatch(rule, std::move(handler), sdbus::return_slot);
}

template <class Handler>
void call(sdbus::IProxy& proxy, const sdbus::MethodCall& message, Handler handler,
          std::uint64_t longest_us = 0) {
    proxy.callMethodAsync(message, std::move(handler), longest_us);
}

inline bool process_one(sdbus::IConnection& bus) {
    return bus.processPendingEvent();
}

#else

using InterfaceName = std::string;
using MethodName = std::string;
using ServiceName = std::string;
using SignalName = std::string;

/// After the handlers of all its signals are registered.
inline void finish_registration(sdbus::IProxy& proxy) {
    proxy.finishRegistration();
}

template <class Handler>
[[nodiscard]] sdbus::Slot match(sdbus::IConnection& bus, const std::string& rule, Handler handler) {
    return bus.addMatch(rule, std::move(handler));
}

/// `longest_us`: how long the answer is waited for; 0 is as long as the library does by itself.
template <class Handler>
void call(sdbus::IProxy& proxy, const sdbus::MethodCall& message, Handler handler,
          std::uint64_t longest_us = 0) {
    proxy.callMethod(message, std::move(handler), longest_us);
}

/// False where nothing was waiting.
inline bool process_one(sdbus::IConnection& bus) {
    return bus.processPendingRequest();
}

#endif

[[nodiscard]] inline std::unique_ptr<sdbus::IProxy> proxy_of(sdbus::IConnection& bus,
                                                             const char* service,
                                                             const std::string& object) {
    return sdbus::createProxy(bus, ServiceName(service), sdbus::ObjectPath(object));
}

}  // namespace touchline
