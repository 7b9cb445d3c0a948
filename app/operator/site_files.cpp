#include "app/operator/site_files.h"

#include "app/decode/files.h"
#include "app/operator/settings_files.h"
#include "app/process/places.h"

namespace touchline {
namespace {

namespace fs = std::filesystem;

Result<KeyTable> keys_in(const fs::path& file) {
    const auto bytes = read_file(file.string());
    if (!bytes) return tl::unexpected(bytes.error());
    return parse_keys({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, file.string());
}

Result<void> keep(const fs::path& file, const std::string& text) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error)
        return failure("the folder " + file.parent_path().string() +
                       " cannot be made: " + error.message());
    return write_whole_file(file.string(), text);
}

}  // namespace

fs::path keys_file() {
    return settings_files().site.parent_path() / "keys.toml";
}

fs::path site_sound_file() {
    return user_settings_folder() / "touchline" / "sound.toml";
}

KeptKeys read_keys(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error) && !error) return {default_keys(), ""};
    const auto keys = keys_in(file);
    if (keys) return {*keys, ""};
    return {default_keys(), keys.error().line + "; the program's own keys hold"};
}

Result<void> keep_keys(const fs::path& file, const KeyTable& keys) {
    const std::string text = keys_text(keys);
    const auto read_back = parse_keys(text, file.string());
    if (!read_back) return tl::unexpected(read_back.error());
    return keep(file, text);
}

Result<void> keep_sound(const fs::path& file, const SoundSettings& sound) {
    const std::string text = sound_text(sound);
    const auto read_back = parse_sound(text, file.string());
    if (!read_back) return tl::unexpected(read_back.error());
    return keep(file, text);
}

}  // namespace touchline
