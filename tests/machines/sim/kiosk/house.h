// What every kiosk in a test takes from its site: languages, pictures, the operator's files.
// Threads: any; what is read once is shared and constant.
#pragma once

#include "app/kiosk/operator_session.h"
#include "app/kiosk/pictures.h"
#include "audio-cues/words/language.h"

#include <filesystem>
#include <vector>

namespace touchline {

/// Returns the languages that a kiosk offers at first, in that order.
[[nodiscard]] std::vector<Language> all_languages();

/// Returns the real gallery, opened by the real workers.
[[nodiscard]] Gallery whole_gallery(const std::vector<Language>& languages);

/// Returns the lines of the real gallery on blank pages, read once: no process, no pixels.
[[nodiscard]] const Gallery& gallery_without_workers();

/// Returns the operator's files in this folder, and makes the folder.
[[nodiscard]] OperatorFiles site_files_in(const std::filesystem::path& folder);

}  // namespace touchline
