#include "app/operator/settings_files.h"

#include "app/decode/files.h"
#include "app/process/places.h"
#include "config/settings/settings_text.h"

#include <system_error>
#include <utility>

#include <sys/stat.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

// A power cut leaves an empty file of one that was being written in place.
constexpr const char* nothing_set = "# Nothing is set: the program's own settings hold.\n";

Result<std::string> text_in(const fs::path& file) {
    return read_file(file.string()).map([](const std::vector<std::byte>& bytes) {
        return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    });
}

Result<Settings> settings_in(const std::string& text, const fs::path& file) {
    return apply_settings(Settings{}, text, file.string(), SettingLayer::site);
}

bool is_there(const fs::path& file) {
    std::error_code error;
    return fs::exists(file, error) || error;
}

/// If the disk takes nothing, only the copy is lost, not the settings.
void remember(const SettingsFiles& files, const std::string& text) {
    const auto known = text_in(files.last_good);
    if (known && *known == text) return;
    (void)write_whole_file(files.last_good.string(), text);
}

KeptSettings fall_back(const SettingsFiles& files, const std::string& why) {
    if (is_there(files.last_good)) {
        const auto text = text_in(files.last_good);
        const auto settings = text ? settings_in(*text, files.last_good)
                                   : Result<Settings>(tl::unexpected(text.error()));
        if (settings) return {*settings, why + "; the settings before hold"};
    }
    return {Settings{}, why + "; the program's own settings hold"};
}

}  // namespace

SettingsFiles settings_files() {
    const std::string chosen = environment("TOUCHLINE_SETTINGS");
    const fs::path site =
        chosen.empty() ? user_settings_folder() / "touchline" / "kiosk.toml" : fs::path(chosen);
    return {site, fs::path(site).concat(".good")};
}

KeptSettings read_settings(const SettingsFiles& files) {
    if (!is_there(files.site)) return {};
    const auto text = text_in(files.site);
    if (!text) return fall_back(files, text.error().line);
    if (text->empty()) return fall_back(files, files.site.string() + ": is empty, as if cut off");
    const auto settings = settings_in(*text, files.site);
    if (!settings) return fall_back(files, settings.error().line);
    remember(files, *text);
    return {*settings, ""};
}

Result<void> keep_settings(const SettingsFiles& files, const Settings& settings) {
    std::error_code error;
    fs::create_directories(files.site.parent_path(), error);
    if (error)
        return failure("the folder " + files.site.parent_path().string() +
                       " cannot be made: " + error.message());
    const std::string text = settings_text(settings, Settings{});
    return write_whole_file(files.site.string(), text.empty() ? nothing_set : text);
}

FileWatch::FileWatch(fs::path file) : file_(std::move(file)), seen_(look()) {}

bool FileWatch::has_changed() {
    const auto now = look();
    return std::exchange(seen_, now) != now;
}

std::optional<FileWatch::Look> FileWatch::look() const {
    struct stat state {};

    if (::stat(file_.c_str(), &state) != 0) return std::nullopt;
    constexpr std::int64_t ns_per_s = 1'000'000'000;
    return Look{static_cast<std::uintmax_t>(state.st_size),
                state.st_mtim.tv_sec * ns_per_s + state.st_mtim.tv_nsec, state.st_ino};
}

}  // namespace touchline
