#include "app/braille/brlapi_display.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include <arpa/inet.h>
#include <brlapi.h>
#include <fmt/format.h>
#include <unistd.h>

namespace touchline {
namespace {

/// What drivers tell brltty by way of its commands: that the display is gone or out of reach, or
/// nothing. Taken from brltty, it would never look for the display again.
constexpr std::array<brlapi_keyCode_t, 3> brlttys_own{
    BRLAPI_KEY_TYPE_CMD | BRLAPI_KEY_CMD_RESTARTBRL, BRLAPI_KEY_TYPE_CMD | BRLAPI_KEY_CMD_OFFLINE,
    BRLAPI_KEY_TYPE_CMD | BRLAPI_KEY_CMD_NOOP};

/// The library tells changes of a number in the order of the network, but what the number is at
/// first in that of the machine.
unsigned int machines_order(std::uint32_t told) {
    constexpr std::uint32_t most = 0xffff;
    return told > most ? ntohl(told) : told;
}

/// Nothing is asked of the library while there is no socket: it would look the host up.
bool is_anything_there() {
    return getenv("BRLAPI_HOST") != nullptr || access(BRLAPI_SOCKETPATH "/0", F_OK) == 0;
}

std::string error_words() {
    const char* const words = brlapi_strerror(&brlapi_error);
    return words != nullptr ? words : "unknown error";
}

brlapi_handle_t* handle_in(std::vector<std::max_align_t>& memory) {
    return reinterpret_cast<brlapi_handle_t*>(memory.data());
}

}  // namespace

/// The library's own handler of exceptions would end the process.
struct BrlapiDisplay::Calls {
    static void take_exception(brlapi_handle_t* handle, int /*error*/, brlapi_packetType_t /*type*/,
                               const void* /*packet*/, std::size_t /*size*/) {
        auto* const display = static_cast<BrlapiDisplay*>(brlapi__getClientData(handle));
        if (display != nullptr) display->is_lost_ = true;
    }

    static void take_change(brlapi_param_t parameter, brlapi_param_subparam_t /*subparam*/,
                            brlapi_param_flags_t /*flags*/, void* given, const void* data,
                            std::size_t size) {
        auto& display = *static_cast<BrlapiDisplay*>(given);
        if (parameter == BRLAPI_PARAM_DISPLAY_SIZE && size >= sizeof(brlapi_param_displaySize_t)) {
            brlapi_param_displaySize_t dimensions{};
            std::copy_n(static_cast<const std::uint8_t*>(data), sizeof dimensions,
                        reinterpret_cast<std::uint8_t*>(&dimensions));
            display.set_size(machines_order(dimensions.columns), machines_order(dimensions.rows));
        }
        if (parameter == BRLAPI_PARAM_DEVICE_ONLINE && size >= sizeof(brlapi_param_bool_t))
            display.is_online_ = *static_cast<const brlapi_param_bool_t*>(data) != 0;
    }
};

BrlapiDisplay::BrlapiDisplay() : handle_(brlapi_getHandleSize() / sizeof(std::max_align_t) + 1) {}

BrlapiDisplay::~BrlapiDisplay() {
    if (descriptor_ < 0) return;
    if (!is_lost_) (void)brlapi__leaveTtyMode(handle_in(handle_));
    brlapi__closeConnection(handle_in(handle_));
}

std::unique_ptr<BrlapiDisplay> BrlapiDisplay::open(std::string& problem) {
    problem.clear();
    if (!is_anything_there()) return nullptr;
    std::unique_ptr<BrlapiDisplay> display(new BrlapiDisplay);
    brlapi_handle_t* const handle = handle_in(display->handle_);
    display->descriptor_ = brlapi__openConnection(handle, nullptr, nullptr);
    if (display->descriptor_ < 0) {
        // Who has just ended leaves the socket there.
        if (brlapi_errno == BRLAPI_ERROR_AUTHENTICATION)
            problem =
                "brltty does not let the kiosk in: install the package touchline-braille, which "
                "puts the kiosk's user into the group brlapi.";
        return nullptr;
    }
    brlapi__setClientData(handle, display.get());
    (void)brlapi__setExceptionHandler(handle, Calls::take_exception);
    if (brlapi__enterTtyModeWithPath(handle, nullptr, 0, nullptr) < 0) {
        problem = fmt::format("brltty does not give its display to the kiosk: {}.", error_words());
        return nullptr;
    }
    (void)brlapi__acceptKeys(handle, brlapi_rangeType_all, nullptr, 0);
    (void)brlapi__ignoreKeys(handle, brlapi_rangeType_key, brlttys_own.data(),
                             static_cast<unsigned int>(brlttys_own.size()));
    display->look();
    for (const brlapi_param_t parameter : {BRLAPI_PARAM_DISPLAY_SIZE, BRLAPI_PARAM_DEVICE_ONLINE}) {
        (void)brlapi__watchParameter(handle, parameter, 0, BRLAPI_PARAMF_GLOBAL, Calls::take_change,
                                     display.get(), nullptr, 0);
    }
    return display;
}

void BrlapiDisplay::set_size(unsigned int columns, unsigned int rows) {
    // More than any display has: a number that is wrong must not cost the memory.
    constexpr unsigned int most = 512;
    columns_ = std::min(columns, most);
    rows_ = std::min(rows, most);
    if (rows_ == 0) columns_ = 0;
}

void BrlapiDisplay::look() {
    unsigned int columns = 0;
    unsigned int rows = 0;
    if (brlapi__getDisplaySize(handle_in(handle_), &columns, &rows) < 0) is_lost_ = true;
    set_size(columns, rows);
}

void BrlapiDisplay::show(std::span<const std::uint8_t> cells) {
    const std::size_t count = columns_ * rows_;
    if (is_lost_ || width() == 0) return;
    blank_.assign(count, 0);
    dots_.assign(count, 0);
    std::copy_n(cells.begin(), std::min(cells.size(), columns_), dots_.begin());
    brlapi_writeArguments_t arguments = BRLAPI_WRITEARGUMENTS_INITIALIZER;
    arguments.regionBegin = 1;
    arguments.regionSize = static_cast<int>(count);
    arguments.andMask = blank_.data();
    arguments.orMask = dots_.data();
    arguments.cursor = BRLAPI_CURSOR_OFF;
    if (brlapi__write(handle_in(handle_), &arguments) < 0) is_lost_ = true;
}

std::optional<std::uint64_t> BrlapiDisplay::next_key() {
    if (is_lost_) return std::nullopt;
    brlapi_keyCode_t code = 0;
    const int found = brlapi__readKey(handle_in(handle_), 0, &code);
    if (found < 0) is_lost_ = true;
    return found > 0 ? std::optional<std::uint64_t>(code) : std::nullopt;
}

}  // namespace touchline
