// Events at the keys and on the screen that are worth a sound. Threads: a plain value.
#pragma once

#include <cstddef>
#include <cstdint>

namespace touchline {

enum class ScreenEvent : std::uint8_t {
    key_taken,
    key_refused,    // the key means nothing here
    list_end,       // the list starts again
    picture_ready,  // another picture is felt
    picture_failed,
    label_reached,  // the hand came to a named spot
    fault,          // force went off by itself
    progress,       // work is under way
    time_out,       // is anybody there?
    shutter,        // the camera took a picture
    news,           // a stick was plugged in, or words were found
};

inline constexpr std::size_t screen_event_count = 11;

}  // namespace touchline
