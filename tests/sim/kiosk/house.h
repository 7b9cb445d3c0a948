// What every kiosk in a test has of the house: languages, pictures, files of its operator.
// Threads: any; what is read once is shared and constant.
#pragma once

#include "app/kiosk/operator_session.h"
#include "app/kiosk/pictures.h"
#include "audio-cues/words/language.h"

#include <filesystem>
#include <vector>

namespace touchline {

/// Those that a kiosk offers at first, in that order.
[[nodiscard]] std::vector<Language> all_languages();

/// The real gallery, opened by the real workers.
[[nodiscard]] Gallery whole_gallery(const std::vector<Language>& languages);

/// The lines of the real gallery on blank pages, read once: no process, no pixels.
[[nodiscard]] const Gallery& gallery_without_workers();

/// In this folder, which is made.
[[nodiscard]] OperatorFiles site_files_in(const std::filesystem::path& folder);

}  // namespace touchline
