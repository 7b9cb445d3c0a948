// Where this kiosk keeps what a bundle changes, and what it knows of bundles.
// Threads: values; house_places() reads the environment.
#pragma once

#include "app/operator/settings_files.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>

namespace touchline {

/// The folders in which a bundle changes something. What is new, and what was before, lies beside
/// its place for a while, under names that begin with a dot.
enum class HouseRoot : std::uint8_t { house, settings, profiles, packs, networks };

inline constexpr std::array<std::string_view, 5> house_root_words{"house", "settings", "profiles",
                                                                  "packs", "networks"};

struct HousePlaces {
    std::filesystem::path house;  // keys, and what was applied
    SettingsFiles settings;
    std::filesystem::path profiles;            // the site's own
    std::filesystem::path installed_profiles;  // the program's; never changed
    std::filesystem::path library;             // of packs
    std::filesystem::path networks;            // those that do not ship

    [[nodiscard]] std::filesystem::path folder_of(HouseRoot root) const {
        switch (root) {
            case HouseRoot::house:
                return house;
            case HouseRoot::settings:
                return settings.site.parent_path();
            case HouseRoot::profiles:
                return profiles;
            case HouseRoot::packs:
                return library;
            case HouseRoot::networks:
                return networks;
        }
        return {};
    }
};

/// The settings that this kiosk is to have. Fails with one line if their file cannot be used: a
/// running kiosk then has others, which must not be signed or written over it.
[[nodiscard]] Result<Settings> read_settings_as_written(const HousePlaces& places);

/// The places of this machine.
[[nodiscard]] HousePlaces house_places();

}  // namespace touchline
