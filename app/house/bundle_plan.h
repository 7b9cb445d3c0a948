// What a bundle would change on this kiosk, judged wholly before anything is changed; and the
// change itself. Threads: any; calls wait for the disk and for the workers that open packs.
#pragma once

#include "app/documents/models/networks.h"
#include "app/documents/packs/pack.h"
#include "app/house/bundle.h"
#include "app/house/changing.h"
#include "app/house/places.h"
#include "app/house/seen.h"
#include "config/settings/settings.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace touchline {

struct PlannedProfile {
    std::string name;
    std::string text;
    bool is_new = false;  // this site has none of that name
};

struct PlannedPack {
    Pack pack;
    std::optional<PackVersion> here;  // the version that it replaces; nothing: it is new
};

struct PlannedNetwork {
    const Network* network = nullptr;
    std::vector<std::byte> bytes;
};

/// Only what differs from this kiosk. It owns its bytes: the bundle may go.
struct BundlePlan {
    std::int64_t made_s = 0;
    std::optional<ChangeRecord> last;  // the change that the kiosk was at
    std::vector<SeenThing> seen;       // all profiles and packs of the bundle, also those alike
    Settings before;
    Settings after;
    std::vector<PlannedProfile> profiles;
    std::vector<PlannedPack> packs;
    std::vector<PlannedNetwork> networks;
};

/// Judges everything in the bytes of a bundle: signature, age, every setting, profile, pack and
/// network. `languages`: the codes of those that there are; empty: they are not judged.
[[nodiscard]] BundleResult<BundlePlan> plan_of_bundle(std::span<const std::byte> bytes,
                                                      const std::string& name,
                                                      const HousePlaces& places,
                                                      std::span<const std::string> languages);

/// A line for each change, in the language: "Firmness: from 400 newtons per metre to 500 newtons
/// per metre". Empty: the kiosk is as the bundle says.
[[nodiscard]] std::vector<std::string> plan_lines(const BundlePlan& plan, const Language& language);

/// Puts all of it in place, or nothing (changing.h). Fails with `changed_since` if another bundle
/// was applied, or the settings, a profile or a pack of it were changed since the plan was made.
[[nodiscard]] BundleResult<void> apply_plan(const BundlePlan& plan, const HousePlaces& places);

/// What going back to before the last bundle would change. The settings are alike where one of the
/// files cannot be read: it goes back all the same.
struct WayBack {
    ChangeRecord record;
    Settings now;
    Settings before;
    std::vector<PackInfo> packs;  // of the record, as they are now: for their titles
};

/// Fails with `nothing_to_undo` if there is none.
[[nodiscard]] BundleResult<WayBack> find_way_back(const HousePlaces& places);

[[nodiscard]] std::vector<std::string> way_back_lines(const WayBack& way, const Language& language);

/// Everything is as it was before the last bundle. What an operator has set since is lost.
[[nodiscard]] BundleResult<void> go_back(const WayBack& way, const HousePlaces& places);

}  // namespace touchline
