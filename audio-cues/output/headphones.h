// Whether headphones are in: what is known of it, from whom, and which output that makes.
// Threads: values and pure functions; a source belongs to one thread.
#pragma once

#include "config/settings/sound.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace touchline {

/// Who tells, the surest first: a key of the keypad that has the socket, the switch of a sound chip
/// as an input device, the same as a control of the sound card.
enum class HeadphoneSource : std::uint8_t { keypad, input_switch, jack_control };

inline constexpr std::size_t headphone_source_count = 3;

/// One of them. None of them need be there.
class HeadphonePresence {
  public:
    virtual ~HeadphonePresence() = default;
    HeadphonePresence() = default;
    HeadphonePresence(const HeadphonePresence&) = delete;
    HeadphonePresence(HeadphonePresence&&) = delete;
    HeadphonePresence& operator=(const HeadphonePresence&) = delete;
    HeadphonePresence& operator=(HeadphonePresence&&) = delete;

    /// Often, 60 times a second say; never waits. Nothing: this source does not know.
    [[nodiscard]] virtual std::optional<bool> are_in(double now_s) = 0;
};

/// What each source said last, in the order of HeadphoneSource.
using HeadphoneReports = std::array<std::optional<bool>, headphone_source_count>;

/// By the surest source that knows; nothing where none does.
[[nodiscard]] std::optional<bool> are_headphones_in(const HeadphoneReports& reports);

/// The output that is heard: the headset while headphones are in, the speaker while they are not,
/// and what the operator assumes where nobody knows.
[[nodiscard]] OutputKind output_kind(std::optional<bool> are_in, const SoundSettings& settings);

[[nodiscard]] const OutputProfile& profile_of(OutputKind kind, const SoundSettings& settings);

}  // namespace touchline
