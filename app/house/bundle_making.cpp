#include "app/house/bundle_making.h"

#include "app/documents/decode/files.h"
#include "app/documents/decode/one_line.h"
#include "app/documents/models/networks.h"
#include "app/documents/packs/pack.h"
#include "app/documents/packs/pack_library.h"
#include "app/documents/packs/unpacking.h"
#include "app/house/changing.h"
#include "app/house/house_keys.h"
#include "audio-cues/words/language.h"
#include "config/settings/setting_rows.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <list>
#include <string>
#include <system_error>
#include <utility>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr const char* last_made_name = "last-made";

/// The bytes of the files lie in a list, where they stay as it grows.
struct Gathered {
    std::vector<BundleFile> files;
    std::list<std::vector<std::byte>> kept;

    void add(BundlePart part, const std::string& name, std::vector<std::byte> bytes) {
        kept.push_back(std::move(bytes));
        files.push_back({part, name, kept.back()});
    }

    void add(BundlePart part, const std::string& name, const std::string& text) {
        const auto bytes = std::as_bytes(std::span(text));
        add(part, name, std::vector<std::byte>(bytes.begin(), bytes.end()));
    }
};

Result<void> add_settings(const HousePlaces& places, Gathered& gathered) {
    const auto site = read_settings_as_written(places);
    if (!site) return tl::unexpected(site.error());
    gathered.add(BundlePart::settings, "kiosk",
                 site_text(with_settings_of_house(Settings{}, *site)));
    return {};
}

Result<void> add_profiles(const HousePlaces& places, Gathered& gathered) {
    std::error_code error;
    if (!fs::exists(places.profiles, error)) return {};
    std::vector<std::string> problems;
    for (const Profile& profile : read_profiles(places.profiles, problems))
        gathered.add(BundlePart::profile, profile.name, profile.text);
    return problems.empty() ? Result<void>{} : failure(problems.front());
}

BundleResult<void> add_pack(const fs::path& folder, Gathered& gathered) {
    const auto pack = read_pack(folder.string());
    if (!pack) return bundle_failure(BundleFault::disk, sentence_of(pack.error(), Language()));
    auto zip = zip_of(*pack);
    if (!zip)
        return bundle_failure(BundleFault::too_large,
                              pack->info.id + ": " + sentence_of(zip.error(), Language()));
    gathered.add(BundlePart::pack, pack->info.id, std::move(*zip));
    return {};
}

BundleResult<void> add_packs(const HousePlaces& places, Gathered& gathered) {
    for (const fs::path& folder : installed_packs(places.library))
        if (auto added = add_pack(folder, gathered); !added) return added;
    return {};
}

Result<void> add_networks(const HousePlaces& places, Gathered& gathered) {
    for (const Network& network : networks()) {
        const fs::path file = places.networks / network.file;
        std::error_code error;
        if (network.ships || !fs::exists(file, error)) continue;
        auto bytes = read_network(network, file);
        if (!bytes) return tl::unexpected(bytes.error());
        gathered.add(BundlePart::network, std::string(network.name), std::move(*bytes));
    }
    return {};
}

tl::unexpected<BundleError> disk_error(const Error& error) {
    return bundle_failure(BundleFault::disk, error.line);
}

/// Later than any that was made or applied here.
Result<std::int64_t> time_for(const HousePlaces& places, std::int64_t now_s) {
    const auto record = read_change_record(places);
    if (!record) return tl::unexpected(record.error());
    std::int64_t made_s = std::max<std::int64_t>(now_s, 0);
    if (*record) made_s = std::max(made_s, (*record)->made_s + 1);
    const auto last = read_text((places.house / last_made_name).string());
    const auto last_s =
        last ? number_in<std::int64_t>(trimmed(*last, "\n")) : std::optional<std::int64_t>();
    return last_s ? std::max(made_s, *last_s + 1) : made_s;
}

}  // namespace

BundleResult<std::vector<std::byte>> make_bundle(const HousePlaces& places,
                                                 std::chrono::sys_seconds now) {
    const auto secret = read_secret_key(places);
    if (!secret) return tl::unexpected(secret.error());
    if (const auto done = finish_change(places); !done) return disk_error(done.error());
    const auto made_s = time_for(places, now.time_since_epoch().count());
    if (!made_s) return disk_error(made_s.error());
    Gathered gathered;
    if (const auto added = add_settings(places, gathered); !added) return disk_error(added.error());
    if (const auto added = add_profiles(places, gathered); !added) return disk_error(added.error());
    if (const auto added = add_packs(places, gathered); !added)
        return tl::unexpected(added.error());
    if (const auto added = add_networks(places, gathered); !added) return disk_error(added.error());
    auto bytes = signed_bundle({TOUCHLINE_VERSION, *made_s, std::move(gathered.files)}, *secret);
    if (!bytes) return bytes;
    const auto kept = keep_text(places.house / last_made_name, std::to_string(*made_s) + '\n');
    if (!kept) return disk_error(kept.error());
    return bytes;
}

}  // namespace touchline
