// One name for what the two generations of sdbus-c++ name differently. Debian 12 has 1, Debian 13
// has 2. Handlers take `(auto&& message)` and `(auto&& reply, const auto& error)`, because
// generation 1 hands them a reference and a pointer, and 2 a value and an optional. Threads: those
// of the library.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include <sdbus-c++/sdbus-c++.h>

namespace touchline {

#if __has_include(<sdbus-c++/VTableItems.h>)  // exists only in generation 2

using sdbus::InterfaceName;
using sdbus::MethodName;
using sdbus::ServiceName;
using sdbus::SignalName;

inline void finish_registration(sdbus::IProxy&) {}  // a registered handler takes effect at once

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

/// Call it after the handlers of all its signals are registered.
inline void finish_registration(sdbus::IProxy& proxy) {
    proxy.finishRegistration();
}

template <class Handler>
[[nodiscard]] sdbus::Slot match(sdbus::IConnection& bus, const std::string& rule, Handler handler) {
    return bus.addMatch(rule, std::move(handler));
}

/// `longest_us`: how long to wait for the answer; 0 is the library's default.
template <class Handler>
void call(sdbus::IProxy& proxy, const sdbus::MethodCall& message, Handler handler,
          std::uint64_t longest_us = 0) {
    proxy.callMethod(message, std::move(handler), longest_us);
}

/// False if nothing was waiting.
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
