#include "app/visit/keys/operator_keyboard.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr int calls_between_looks = 60;
constexpr std::uint32_t scancode_of_code = 8;  // the window system's offset

struct NamedCode {
    std::uint16_t code;
    Key key;
};

constexpr auto named_codes = std::to_array<NamedCode>({{KEY_UP, Key::up},
                                                       {KEY_DOWN, Key::down},
                                                       {KEY_LEFT, Key::left},
                                                       {KEY_RIGHT, Key::right},
                                                       {KEY_ENTER, Key::enter},
                                                       {KEY_KPENTER, Key::enter},
                                                       {KEY_ESC, Key::escape},
                                                       {KEY_PAGEUP, Key::page_up},
                                                       {KEY_PAGEDOWN, Key::page_down},
                                                       {KEY_SPACE, Key{' '}},
                                                       {KEY_H, Key{'H'}},
                                                       {KEY_MINUS, Key{'-'}},
                                                       {KEY_EQUAL, Key{'='}}});

Key function_key(int number) {
    return Key{static_cast<std::uint32_t>(Key::f1) + static_cast<std::uint32_t>(number - 1)};
}

PhysicalKey named(Key key) {
    return {KeySource::key, static_cast<std::uint32_t>(key)};
}

}  // namespace

PhysicalKey key_of_code(std::uint16_t code) {
    for (const NamedCode& row : named_codes)
        if (row.code == code) return named(row.key);
    if (code >= KEY_F1 && code <= KEY_F10) return named(function_key(code - KEY_F1 + 1));
    if (code == KEY_F11 || code == KEY_F12) return named(function_key(code - KEY_F11 + 11));
    if (code >= KEY_F13 && code <= KEY_F24) return named(function_key(code - KEY_F13 + 13));
    return {KeySource::scancode, code + scancode_of_code};
}

OperatorKeyboard::OperatorKeyboard(std::string path) : path_(std::move(path)) {
    open_again();
}

void OperatorKeyboard::open_again() {
    waited_ = 0;
    if (path_.empty() || descriptor_.is_open()) return;
    descriptor_ = Descriptor(open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    error_ = descriptor_.is_open() ? 0 : errno;
    // Only this program gets its keys. If it cannot be grabbed, it still reports them.
    if (descriptor_.is_open()) (void)ioctl(descriptor_.number(), EVIOCGRAB, 1);
}

std::vector<PhysicalKey> OperatorKeyboard::take_presses() {
    std::vector<PhysicalKey> presses;
    if (!descriptor_.is_open() && ++waited_ >= calls_between_looks) open_again();
    if (!descriptor_.is_open()) return presses;
    input_event event{};
    ssize_t got = 0;
    while ((got = read(descriptor_.number(), &event, sizeof event)) == ssize_t{sizeof event})
        if (event.type == EV_KEY && event.value == 1) presses.push_back(key_of_code(event.code));
    if (got == 0 || (got < 0 && errno != EAGAIN && errno != EINTR))
        descriptor_ = Descriptor();  // it was pulled out
    return presses;
}

std::string OperatorKeyboard::problem() const {
    if (path_.empty() || descriptor_.is_open()) return {};
    return "the operator's keyboard " + path_ + " cannot be read (" + std::strerror(error_) +
           "); nobody can enter until it is plugged in, or another one is set";
}

}  // namespace touchline
