// How loud the kiosk is, for the headset and for the speaker, as the operator measured it. The only
// table of these settings; the file is config/defaults/sound.toml.
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

/// One output at one place. All levels are in dB SPL (dB(A) on a speaker) at the visitor's ear.
struct OutputProfile {
    OutputKind kind = OutputKind::headset;
    double full_scale_dB = 110.0;  // measured, with a full sine in the middle
    double quietest_dB = 50.0;     // for speech
    double loudest_dB = 80.0;
    double step_dB = 5.0;
    double default_dB = 65.0;  // at the start of every session
    double cap_dB = 100.0;     // no peak is above it
    double ambient_dB = 45.0;  // room noise, as the operator measured it
    bool is_mono = false;

    friend bool operator==(const OutputProfile&, const OutputProfile&) = default;
};

/// Levels before an output is calibrated on site: cautious, for common hardware.
[[nodiscard]] OutputProfile default_output(OutputKind kind);

struct SoundSettings {
    OutputProfile headset = default_output(OutputKind::headset);
    OutputProfile speaker = default_output(OutputKind::speaker);
    /// The output to assume if nothing tells whether headphones are plugged in.
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

/// Checks the rules between the levels: steps of 1 to 6 dB (so that one lies at +12 dB), a range of
/// at least 18 dB, 20 dB above a room of more than 45 dB, a speaker that reaches 65 dB, a default
/// of 60 to 70 dB (at most 65 on a speaker) that is one of the steps, and a cap between the loudest
/// speech and what the output can give, at most 105 dB. The error is one line that names what is
/// wrong.
[[nodiscard]] Result<void> check(const OutputProfile& profile);

/// Parses the text of a file, with the defaults for what it does not name; `name` is the file's,
/// for the error. Malformed text, an unknown key, a value out of range or a broken rule gives a
/// one-line error with file and line number.
[[nodiscard]] Result<SoundSettings> parse_sound(std::string_view text, std::string_view name);

/// Reads at most 1 MB.
[[nodiscard]] Result<SoundSettings> read_sound(const std::filesystem::path& file);

/// Returns text that parse_sound() reads back to the same settings.
[[nodiscard]] std::string sound_text(const SoundSettings& settings);

}  // namespace touchline
