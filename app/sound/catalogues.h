// Loads the words and the levels from where they are installed or were built.
// Threads: any, as long as nothing in the program changes its environment.
#pragma once

#include "audio-cues/words/language.h"
#include "config/settings/sound.h"

#include <filesystem>
#include <string>
#include <vector>

namespace touchline {

using Languages = std::vector<Language>;

/// TOUCHLINE_WORDS if it is set, else the installed folder, else the built one.
[[nodiscard]] std::filesystem::path words_folder();

/// English and every usable catalogue of the folder. `problems` gets a line for each that is not
/// usable. Never empty.
[[nodiscard]] Languages read_languages(const std::filesystem::path& folder,
                                       std::vector<std::string>& problems);

/// TOUCHLINE_SOUND if it is set, else the kiosk user's own file, else the installed one, else the
/// built one.
[[nodiscard]] std::filesystem::path sound_file();

/// The folder of prompts recorded for this kiosk (audio-cues/speech/recorded_prompts.h):
/// TOUCHLINE_PROMPTS if it is set, else the kiosk user's own. It may be missing.
[[nodiscard]] std::filesystem::path prompts_folder();

/// Returns the defaults if the file cannot be used; `problems` then gets a line.
[[nodiscard]] SoundSettings read_sound_settings(const std::filesystem::path& file,
                                                std::vector<std::string>& problems);

}  // namespace touchline
