#include "app/sound/headphone_switch.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

using SwitchBits = std::array<unsigned char, SW_CNT / 8 + 1>;

bool has_headphones(const SwitchBits& bits) {
    return (bits[SW_HEADPHONE_INSERT / 8] & (1U << (SW_HEADPHONE_INSERT % 8U))) != 0;
}

/// Sorted by name, so that it is the same one every time.
std::vector<std::string> event_files(const std::string& folder) {
    std::vector<std::string> paths;
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
        if (it->path().filename().string().starts_with("event")) paths.push_back(it->path());
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace

void SwitchStream::take_event(std::span<const std::byte> bytes) {
    input_event event{};
    std::memcpy(&event, bytes.data(), sizeof event);
    if (event.type == EV_SYN && event.code == SYN_DROPPED) is_lost_ = true;
    if (event.type == EV_SW && event.code == SW_HEADPHONE_INSERT) are_in_ = event.value != 0;
}

void SwitchStream::add(std::span<const std::byte> bytes) {
    part_.insert(part_.end(), bytes.begin(), bytes.end());
    std::span<const std::byte> left = part_;
    for (; left.size() >= sizeof(input_event); left = left.subspan(sizeof(input_event)))
        take_event(left.first(sizeof(input_event)));
    part_.erase(part_.begin(), part_.end() - static_cast<std::ptrdiff_t>(left.size()));
}

std::optional<SwitchDevice> open_switch(const std::string& path) {
    Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    if (!file.is_open()) return std::nullopt;
    SwitchBits bits{};
    if (ioctl(file.number(), EVIOCGBIT(EV_SW, sizeof bits), bits.data()) < 0) return std::nullopt;
    if (!has_headphones(bits)) return std::nullopt;
    bits = {};
    const bool is_told = ioctl(file.number(), EVIOCGSW(sizeof bits), bits.data()) >= 0;
    return SwitchDevice{std::move(file),
                        is_told ? std::optional(has_headphones(bits)) : std::nullopt};
}

void HeadphoneSwitch::look_for_one(double now_s) {
    if (now_s - looked_s_ < retry_s) return;
    looked_s_ = now_s;
    for (const std::string& path : event_files(folder_)) {
        auto device = open_(path);
        if (!device) continue;
        path_ = path;
        file_ = std::move(device->file);
        stream_ = SwitchStream(device->are_in);
        return;
    }
}

/// False if the device is gone.
bool HeadphoneSwitch::read_events() {
    std::array<std::byte, 64 * sizeof(input_event)> bytes;
    for (;;) {
        const ssize_t got = ::read(file_.number(), bytes.data(), bytes.size());
        if (got < 0) return errno == EAGAIN || errno == EINTR;
        if (got == 0) return false;
        stream_.add(std::span(bytes).first(static_cast<std::size_t>(got)));
        if (!stream_.is_lost()) continue;
        auto again = open_(path_);
        if (!again) return false;
        file_ = std::move(again->file);
        stream_ = SwitchStream(again->are_in);
    }
}

std::optional<bool> HeadphoneSwitch::are_in(double now_s) {
    if (!file_.is_open()) look_for_one(now_s);
    if (!file_.is_open()) return std::nullopt;
    if (!read_events()) {
        file_ = Descriptor();
        stream_ = SwitchStream();
    }
    return stream_.are_in();
}

}  // namespace touchline
