// The words and the levels, from where they are installed or were built.
// Threads: any, as long as nothing in the program changes its environment.
#pragma once

#include "audio-cues/words/language.h"
#include "config/settings/sound.h"

#include <filesystem>
#include <string>
#include <vector>

namespace touchline {

using Languages = std::vector<Language>;

/// TOUCHLINE_WORDS where that is set, else as installed, else as built.
[[nodiscard]] std::filesystem::path words_folder();

/// English and every catalogue of the folder that can be used; `problems` has a line for each that
/// cannot. Never empty.
[[nodiscard]] Languages read_languages(const std::filesystem::path& folder,
                                       std::vector<std::string>& problems);

/// TOUCHLINE_SOUND where that is set, else the kiosk user's own, else as installed, else as built.
[[nodiscard]] std::filesystem::path sound_file();

/// Prompts that somebody recorded for this kiosk (audio-cues/speech/recorded_prompts.h):
/// TOUCHLINE_PROMPTS where that is set, else the kiosk user's own. It need not exist.
[[nodiscard]] std::filesystem::path prompts_folder();

/// The defaults where the file cannot be used; `problems` then has its line.
[[nodiscard]] SoundSettings read_sound_settings(const std::filesystem::path& file,
                                                std::vector<std::string>& problems);

}  // namespace touchline
