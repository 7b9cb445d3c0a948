#include "app/house/places.h"

#include "app/documents/models/networks.h"
#include "app/documents/packs/pack_library.h"

#include <system_error>

namespace touchline {

Result<Settings> read_settings_as_written(const HousePlaces& places) {
    const KeptSettings kept = read_settings(places.settings);
    if (kept.note.empty()) return kept.settings;
    return failure(kept.note + "; mend that file first");
}

HousePlaces house_places() {
    SettingsFiles settings = settings_files();
    std::error_code error;
    const auto whole = [&error](const std::filesystem::path& path) {
        const auto absolute = std::filesystem::absolute(path, error);
        return error ? path : absolute;
    };
    settings.site = whole(settings.site);
    return {settings.site.parent_path() / "house",
            settings,
            whole(site_profiles_folder()),
            profiles_folder(),
            whole(library_folder()),
            whole(models_folder())};
}

}  // namespace touchline
