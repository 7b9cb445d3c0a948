// How loud the kiosk is, for the headset and for the speaker, as the operator measured it.
// The one table of these settings; the file is config/defaults/sound.toml.
// Threads: values and pure functions.
#pragma once

#include "config/types/result.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace touchline {

enum class OutputKind : std::uint8_t { headset, speaker };

/// Of one output at one place; all levels in dB SPL (dB(A) on a speaker) where the visitor's ear
/// is.
struct OutputProfile {
    OutputKind kind = OutputKind::headset;
    double full_scale_dB = 110.0;  // measured: a full sine in the middle
    double quietest_dB = 50.0;     // of speech
    double loudest_dB = 80.0;
    double step_dB = 5.0;
    double default_dB = 65.0;  // at the start of every session
    double cap_dB = 100.0;     // no peak is above
    double ambient_dB = 45.0;  // of the room, as the operator measured it
    bool is_mono = false;

    friend bool operator==(const OutputProfile&, const OutputProfile&) = default;
};

/// Before they are calibrated on site: cautious, for common hardware.
[[nodiscard]] OutputProfile default_output(OutputKind kind);

struct SoundSettings {
    OutputProfile headset = default_output(OutputKind::headset);
    OutputProfile speaker = default_output(OutputKind::speaker);
    /// What is assumed where nothing tells whether headphones are in.
    OutputKind assumed = OutputKind::headset;

    friend bool operator==(const SoundSettings&, const SoundSettings&) = default;
};

/// One level of an output: its key in the file, its bounds, and what it means.
struct LevelSetting {
    std::string_view key;
    double OutputProfile::*level_dB;
    double least_dB;
    double most_dB;
    std::string_view meaning;
};

[[nodiscard]] std::span<const LevelSetting> level_settings();

/// The rules between the levels: steps of 1 to 6 dB (so that one lies at +12 dB), a range of 18 dB
/// at least, 20 dB above a room of more than 45 dB, a speaker that reaches 65 dB, a default of 60
/// to 70 dB (65 at most on a speaker) that is one of the steps, a cap between the loudest speech
/// and what the output can give, at most 105 dB. One line that names what is wrong.
[[nodiscard]] Result<void> check(const OutputProfile& profile);

/// What the text of a file holds, the defaults for what it does not name; `name` is that file's,
/// for the error. Malformed, an unknown key, a value out of range or a rule that is broken: one
/// line with file and line number.
[[nodiscard]] Result<SoundSettings> parse_sound(std::string_view text, std::string_view name);

/// At most 1 MB.
[[nodiscard]] Result<SoundSettings> read_sound(const std::filesystem::path& file);

/// The text that parse_sound() reads back to the same settings.
[[nodiscard]] std::string sound_text(const SoundSettings& settings);

}  // namespace touchline
