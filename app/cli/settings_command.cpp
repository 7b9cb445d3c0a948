#include "app/cli/commands.h"
#include "app/documents/decode/files.h"
#include "app/operator/settings_files.h"
#include "app/sound/catalogues.h"
#include "config/settings/settings_text.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <filesystem>
#include <ostream>

#include <fmt/core.h>

namespace touchline {
namespace {

/// The languages of the catalogues; none if their folder cannot be read.
std::vector<std::string> languages_that_there_are() {
    return languages_in(words_folder().string()).value_or(std::vector<std::string>{});
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

std::vector<std::string> run_settings(const SettingsCommandOptions& options, std::ostream& out) {
    const bool is_named = !options.file.empty();
    const std::string file = is_named ? options.file : settings_files().site.string();
    std::error_code error;
    const bool is_missing = !is_named && !std::filesystem::exists(file, error) && !error;
    const auto text = is_missing ? Result<std::string>("") : read_text(file);
    if (!text) return {text.error().line};
    auto faults = settings_faults(*text, file, SettingLayer::site, languages_that_there_are());
    if (!faults.empty()) return faults;
    const auto settings = apply_settings(Settings{}, *text, file, SettingLayer::site);
    if (!settings) return {settings.error().line};
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
