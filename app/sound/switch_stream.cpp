#include "app/sound/switch_stream.h"

#include <cstring>

#include <linux/input.h>

namespace touchline {

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

}  // namespace touchline
