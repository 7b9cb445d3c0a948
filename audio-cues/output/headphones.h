// Whether headphones are plugged in: what is known, from which source, and which output that
// selects.
// Threads: values and pure functions; a source belongs to one thread.
#pragma once

#include "config/settings/sound.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace touchline {

/// The sources, the surest first: a key of the keypad that has the socket, a sound chip's switch as
/// an input device, and the same as a control of the sound card.
enum class HeadphoneSource : std::uint8_t { keypad, input_switch, jack_control };

inline constexpr std::size_t headphone_source_count = 3;

/// One source. A kiosk may have none of them.
class HeadphonePresence {
  public:
    virtual ~HeadphonePresence() = default;
    HeadphonePresence() = default;
    HeadphonePresence(const HeadphonePresence&) = delete;
    HeadphonePresence(HeadphonePresence&&) = delete;
    HeadphonePresence& operator=(const HeadphonePresence&) = delete;
    HeadphonePresence& operator=(HeadphonePresence&&) = delete;

    /// Call often, such as 60 times a second; never waits. Returns nothing if this source does not
    /// know.
    [[nodiscard]] virtual std::optional<bool> are_in(double now_s) = 0;
};

/// Each source's last report, in the order of HeadphoneSource.
using HeadphoneReports = std::array<std::optional<bool>, headphone_source_count>;

/// Returns the report of the surest source that knows; nothing if none does.
[[nodiscard]] std::optional<bool> are_headphones_in(const HeadphoneReports& reports);

/// Returns the output that is heard: the headset while headphones are in, the speaker while they
/// are not, and the operator's assumption if no source knows.
[[nodiscard]] OutputKind output_kind(std::optional<bool> are_in, const SoundSettings& settings);

[[nodiscard]] const OutputProfile& profile_of(OutputKind kind, const SoundSettings& settings);

}  // namespace touchline
