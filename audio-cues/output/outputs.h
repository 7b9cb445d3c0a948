// The outputs, headset and speaker: which one is heard, by whether headphones are in and who tells
// so (here also the sound cards' controls for their sockets), and how loud: the volume steps
// between the levels that an operator set (config/settings/sound.h), and what they mean for the
// mixer. Threads: values and pure functions; a source belongs to one thread.
#pragma once

#include "audio-cues/synth/mixer.h"
#include "config/settings/sound.h"
#include "config/types/pinned.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// The sources, the surest first: a key of the keypad that has the socket, a sound chip's switch as
/// an input device, and the same as a control of the sound card.
enum class HeadphoneSource : std::uint8_t { keypad, input_switch, jack_control };

inline constexpr std::size_t headphone_source_count = 3;

/// One source. A kiosk may have none of them.
class HeadphonePresence : public Interface {
  public:
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

/// A switch of a card that reports rather than sets.
struct CardSwitch {
    std::string name;
    bool is_on = false;
};

/// True for "Headphone Jack", "Front Headphone Jack", "Headphone Mic Jack", "Headset Jack"; not for
/// the phantom jacks of cards that cannot tell, nor for a microphone's.
[[nodiscard]] bool is_headphone_jack(std::string_view control);

/// Returns whether one of the headphone jacks is on; nothing if there are none.
[[nodiscard]] std::optional<bool> are_headphones_in(const std::vector<CardSwitch>& switches);

/// Returns the switches of every card's jacks, as ALSA reports them; a card that cannot be asked
/// has none. Takes a millisecond.
[[nodiscard]] std::vector<CardSwitch> card_switches();

/// Asks the cards every `period_s`, because they may come and go with a USB headset.
class JackControl final : public HeadphonePresence {
  public:
    using Ask = std::function<std::vector<CardSwitch>()>;

    explicit JackControl(Ask ask = card_switches) : ask_(std::move(ask)) {}

    [[nodiscard]] std::optional<bool> are_in(double now_s) override;

    static constexpr double period_s = 0.25;

  private:
    Ask ask_;
    double asked_s_ = -period_s;
    std::optional<bool> are_in_;
};

/// The engine's speech is this much below a full sine.
inline constexpr double speech_below_full_dB = 18.8;

/// Returns the number of steps, at least 1.
[[nodiscard]] std::size_t volume_steps(const OutputProfile& profile);

[[nodiscard]] std::size_t default_volume(const OutputProfile& profile);

/// Returns the level of speech at that step, clamped to the existing ones.
[[nodiscard]] double level_dB_of(const OutputProfile& profile, std::size_t step);

struct VolumeChange {
    std::size_t step = 0;
    bool is_at_end = false;  // nothing changed: this is the loudest or softest step
};

/// Goes one step up (`change` > 0) or down.
[[nodiscard]] VolumeChange change_volume(const OutputProfile& profile, std::size_t step,
                                         int change);

/// Returns the mixer's setting.
[[nodiscard]] SetOutput output_of(const OutputProfile& profile, std::size_t step);

}  // namespace touchline
