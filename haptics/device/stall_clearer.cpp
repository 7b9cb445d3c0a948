#include "haptics/device/stall_clearer.h"

namespace touchline {

StallClearer::StallClearer(libusb_device_handle* handle, std::array<std::uint8_t, 2> endpoints)
    : handle_(handle), endpoints_(endpoints), thread_([this] { clear_when_asked(); }) {}

StallClearer::~StallClearer() {
    is_closing_ = true;
    asked_.release();
    thread_.join();
}

std::optional<int> StallClearer::step() {
    if (work_ == Work::ended) {
        work_ = Work::none;
        return error_;
    }
    if (work_ == Work::none) {
        work_ = Work::wanted;
        asked_.release();
    }
    return std::nullopt;
}

void StallClearer::clear_when_asked() {
    for (;;) {
        asked_.acquire();
        if (is_closing_) return;
        int error = 0;  // the first error
        for (const std::uint8_t endpoint : endpoints_)
            if (error == 0) error = libusb_clear_halt(handle_, endpoint);
        error_ = error;
        work_ = Work::ended;
    }
}

}  // namespace touchline
