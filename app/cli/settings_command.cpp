#include "app/cli/settings_command.h"

#include "app/decode/files.h"
#include "app/operator/settings_files.h"
#include "config/settings/settings_text.h"
#include "config/types/plain_line.h"

#include <algorithm>
#include <filesystem>
#include <ostream>

#include <fmt/core.h>

namespace touchline {
namespace {

Result<Settings> settings_with(const std::string& file) {
    const auto bytes = read_file(file);
    if (!bytes) return tl::unexpected(bytes.error());
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    return apply_settings(Settings{}, text, file, SettingLayer::site);
}

std::string verdict(const std::string& file, const Settings& settings) {
    const auto rows = setting_rows();
    const auto count = std::count_if(rows.begin(), rows.end(), [&](const SettingRow& row) {
        return value_of(settings, row) != value_of(Settings{}, row);
    });
    return fmt::format("{}: can be used; {} of {} settings differ from the program's own", file,
                       count, rows.size());
}

}  // namespace

Result<void> run_settings(const SettingsCommandOptions& options, std::ostream& out) {
    const bool is_named = !options.file.empty();
    const std::string file = is_named ? options.file : settings_files().site.string();
    std::error_code error;
    const bool is_missing = !is_named && !std::filesystem::exists(file, error) && !error;
    const auto settings = is_missing ? Result<Settings>(Settings{}) : settings_with(file);
    if (!settings) return tl::unexpected(settings.error());
    if (options.action == SettingsAction::print) {
        out << settings_text(*settings);
    } else if (is_missing) {
        out << plain_line(file) << ": is not there; the program's own settings hold\n";
    } else {
        out << plain_line(verdict(file, *settings)) << '\n';
    }
    return {};
}

}  // namespace touchline
