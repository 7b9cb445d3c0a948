#include "app/operator/backup.h"

#include "app/documents/decode/files.h"
#include "app/operator/settings_files.h"
#include "config/settings/settings_text.h"

#include <array>
#include <optional>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view first_line = "Touchline backup 1\n";
constexpr std::size_t most_bytes = std::size_t{4} << 20U;

/// The parts, in their order; each begins with its line and ends before the next.
constexpr std::array<std::string_view, 3> part_lines{"=== settings ===\n", "=== sound ===\n",
                                                     "=== keys ===\n"};
constexpr std::string_view last_line = "=== end ===\n";

tl::unexpected<Error> refused(std::string_view name, const std::string& why) {
    return failure(std::string(name) + ": " + why + "; make a new backup, and use that one");
}

/// The part after as many empty lines as lie before it, so that its reader's line numbers are right
/// for the whole file.
std::string with_lines_before(std::string_view whole, std::size_t begin, std::size_t end) {
    std::string text;
    for (const char letter : whole.substr(0, begin))
        if (letter == '\n') text += '\n';
    return text + std::string(whole.substr(begin, end - begin));
}

std::optional<std::array<std::string, part_lines.size()>> parts_of(std::string_view text) {
    std::array<std::string, part_lines.size()> parts;
    std::size_t at = first_line.size();
    for (std::size_t i = 0; i < part_lines.size(); ++i) {
        if (!text.substr(at).starts_with(part_lines[i])) return std::nullopt;
        const std::size_t begin = at + part_lines[i].size();
        const std::string_view next = i + 1 < part_lines.size() ? part_lines[i + 1] : last_line;
        const std::size_t end = text.find("\n" + std::string(next), begin - 1);
        if (end == std::string_view::npos) return std::nullopt;
        at = end + 1;
        parts[i] = with_lines_before(text, begin, at);
    }
    if (text.substr(at) != last_line) return std::nullopt;
    return parts;
}

}  // namespace

std::string backup_text(const Backup& backup) {
    return std::string(first_line) + std::string(part_lines[0]) + settings_text(backup.settings) +
           std::string(part_lines[1]) + sound_text(backup.sound) + std::string(part_lines[2]) +
           keys_text(backup.keys) + std::string(last_line);
}

Result<Backup> parse_backup(std::string_view text, std::string_view name) {
    if (!text.starts_with(first_line)) return refused(name, "is no backup of this program");
    const auto parts = parts_of(text);
    if (!parts) return refused(name, "the backup is not whole");
    const auto settings = apply_settings(Settings{}, (*parts)[0], name, SettingLayer::site);
    if (!settings) return tl::unexpected(settings.error());
    const auto sound = parse_sound((*parts)[1], name);
    if (!sound) return tl::unexpected(sound.error());
    const auto keys = parse_keys((*parts)[2], name);
    if (!keys) return tl::unexpected(keys.error());
    return Backup{*settings, *sound, *keys};
}

Result<void> write_backup(const fs::path& folder, const Backup& backup) {
    return write_whole_file((folder / backup_name).string(), backup_text(backup));
}

Result<Backup> read_backup(const fs::path& folder) {
    const std::string file = (folder / backup_name).string();
    const auto text = read_text(file);
    if (!text) return tl::unexpected(text.error());
    if (text->size() > most_bytes) return refused(file, "is larger than 4 MB, as no backup is");
    return parse_backup(*text, file);
}

}  // namespace touchline
