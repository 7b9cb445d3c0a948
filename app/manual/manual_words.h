// What the manual's pages take from the kiosk's own words in a language: the settings, and the
// names of items. So a page names an item as the kiosk says it. Threads: pure functions.
#pragma once

#include "audio-cues/words/language.h"
#include "config/settings/setting_rows.h"

#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// The names between straight quotes in a page of Markdown, in their order: "Upkeep".
[[nodiscard]] std::vector<std::string> quoted_names(std::string_view page);

/// The contexts of the catalogue in which a name is looked up, in this order.
[[nodiscard]] std::vector<std::string> name_contexts();

/// What may be written for a setting: 'a number from 100 to 700', '"wall" (Wand) oder "groove"
/// (Rille)'. Numbers have a point, as in the file.
[[nodiscard]] std::string allowed_values(const SettingRow& row, const Language& language);

/// All settings as Markdown: a heading of level 3 for each table and of level 4 for each setting,
/// with sentences below.
[[nodiscard]] std::string settings_page(const Language& language);

/// The page with each quoted name in the language and its quotation marks, and with the settings in
/// place of a line `<!-- settings -->`. A name that the catalogue lacks stays English.
[[nodiscard]] std::string filled_page(std::string_view page, const Language& language);

}  // namespace touchline
