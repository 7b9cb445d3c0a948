#include "app/sound/catalogues.h"

#include "app/isolation/process/places.h"

#include <system_error>

namespace touchline {

namespace fs = std::filesystem;

fs::path words_folder() {
    const std::string chosen = environment("TOUCHLINE_WORDS");
    if (!chosen.empty()) return chosen;
    return installed_place(TOUCHLINE_WORDS_BESIDE_PROGRAM, TOUCHLINE_WORDS_BUILT);
}

Languages read_languages(const fs::path& folder, std::vector<std::string>& problems) {
    Languages languages{Language()};
    const auto codes = languages_in(folder.string());
    if (!codes) problems.push_back(codes.error().line);
    for (const std::string& code : codes.value_or(std::vector<std::string>{})) {
        if (code == languages.front().code()) continue;
        auto language = Language::load(folder.string(), code);
        if (language) {
            languages.push_back(std::move(*language));
        } else {
            problems.push_back(language.error().line);
        }
    }
    return languages;
}

fs::path sound_file() {
    const std::string chosen = environment("TOUCHLINE_SOUND");
    if (!chosen.empty()) return chosen;
    std::error_code error;
    const fs::path own = user_settings_folder() / "touchline" / "sound.toml";
    if (fs::is_regular_file(own, error)) return own;
    return installed_place(TOUCHLINE_SOUND_BESIDE_PROGRAM, TOUCHLINE_SOUND_SOURCE);
}

fs::path prompts_folder() {
    const std::string chosen = environment("TOUCHLINE_PROMPTS");
    return chosen.empty() ? user_settings_folder() / "touchline" / "prompts" : fs::path(chosen);
}

SoundSettings read_sound_settings(const fs::path& file, std::vector<std::string>& problems) {
    const auto settings = read_sound(file);
    if (settings) return *settings;
    problems.push_back(settings.error().line);
    return {};
}

}  // namespace touchline
