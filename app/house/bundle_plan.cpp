#include "app/house/bundle_plan.h"

#include "app/documents/decode/files.h"
#include "app/documents/decode/one_line.h"
#include "app/house/house_keys.h"
#include "audio-cues/words/language.h"
#include "config/settings/setting_rows.h"
#include "config/settings/settings_text.h"

#include <algorithm>
#include <exception>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

/// The name under which a fault of a bundle's own file is told.
std::string name_in_bundle(const BundleFile& file) {
    return "bundle, " + file.name;
}

tl::unexpected<BundleError> bad(const std::string& line) {
    return bundle_failure(BundleFault::bad_contents, line);
}

tl::unexpected<BundleError> broken_disk(const Error& error) {
    return bundle_failure(BundleFault::disk, error.line);
}

std::optional<std::size_t> row_of_kiosk_in(std::string_view text) {
    for (const std::size_t row : rows_in(text))
        if (setting_rows()[row].owner == SettingOwner::kiosk) return row;
    return std::nullopt;
}

/// Judges what is in a bundle against this kiosk, one file after the other.
struct Planner {
    const HousePlaces& places;
    std::span<const std::string> languages;
    BundlePlan plan{};
    std::vector<Profile> brought{};

    BundleResult<void> add(const BundleFile& file) {
        switch (file.part) {
            case BundlePart::settings:
                return add_settings(file);
            case BundlePart::profile:
                return add_profile(file);
            case BundlePart::pack:
                return add_pack(file);
            case BundlePart::network:
                return add_network(file);
        }
        return {};
    }

    BundleResult<void> add_settings(const BundleFile& file) {
        const std::string name = name_in_bundle(file);
        const std::string_view text = as_text(file.bytes);
        if (file.name != "kiosk") return bad(name + ": is no file of settings of a kiosk");
        if (const auto row = row_of_kiosk_in(text))
            return bad(fmt::format("{}: '{}.{}' belongs to each kiosk itself", name,
                                   setting_rows()[*row].table, setting_rows()[*row].key));
        const auto house = apply_settings(Settings{}, text, name, SettingLayer::site);
        if (!house) return bad(house.error().line);
        // A kiosk with fewer languages takes a bundle that says nothing of them.
        const bool sets_languages = house->languages != Settings{}.languages;
        const auto faults = sets_languages
                                ? settings_faults(text, name, SettingLayer::site, languages)
                                : std::vector<std::string>();
        if (!faults.empty()) return bad(faults.front());
        plan.after = with_settings_of_house(plan.before, *house);
        return {};
    }

    BundleResult<void> add_profile(const BundleFile& file) {
        const std::string name = name_in_bundle(file);
        const std::string text(as_text(file.bytes));
        if (!is_allowed(TextKind::name, file.name))
            return bad(
                fmt::format("{}: a profile is named by {}", name, allowed_texts(TextKind::name)));
        const auto judged = apply_settings(Settings{}, text, name, SettingLayer::profile);
        if (!judged) return bad(judged.error().line);
        brought.push_back({file.name, text, {}});
        const fs::path here = places.profiles / (file.name + ".toml");
        plan.seen.push_back(see(places, HouseRoot::profiles, file.name + ".toml"));
        const auto text_here = read_text(here.string());
        if (!text_here || *text_here != text)
            plan.profiles.push_back({file.name, text, !is_there(here)});
        return {};
    }

    BundleResult<void> add_pack(const BundleFile& file) {
        auto pack = read_pack(file.bytes);
        if (!pack) return bad(told(file, pack.error()));
        if (pack->info.id != file.name) return bad(name_in_bundle(file) + ": is another pack");
        const auto installed = read_pack((places.library / file.name).string());
        plan.seen.push_back(seen_pack(file.name, installed));
        if (installed && installed->files == pack->files) return {};
        const auto here = installed ? std::optional(installed->info.version) : std::nullopt;
        if (here && pack->info.version < *here)
            return bundle_failure(
                BundleFault::older_pack,
                fmt::format("the pack {} is version {} in the bundle, and {} on this kiosk; make "
                            "a new bundle with the newer one",
                            file.name, text_of(pack->info.version), text_of(*here)));
        const auto findings = check_pack(*pack);
        if (!can_be_used(findings)) return bad(told(file, findings.front()));
        plan.packs.push_back({std::move(*pack), here});
        return {};
    }

    static std::string told(const BundleFile& file, const PackFinding& finding) {
        return name_in_bundle(file) + ": " + sentence_of(finding, Language());
    }

    BundleResult<void> add_network(const BundleFile& file) {
        const Network* const network = network_of(file.bytes);
        if (network == nullptr || network->name != file.name)
            return bad(name_in_bundle(file) +
                       ": is damaged, or a network of another version of Touchline");
        if (!read_network(*network, places.networks / network->file))
            plan.networks.push_back({network, {file.bytes.begin(), file.bytes.end()}});
        return {};
    }

    /// The profile in use must be there, and may not raise what the site bounds.
    BundleResult<void> judge_whole() {
        std::vector<std::string> problems;
        std::vector<Profile> profiles = brought;
        for (Profile& profile : read_profiles(places.installed_profiles, places.profiles, problems))
            profiles.push_back(std::move(profile));
        const auto used = with_profile(plan.after, profiles);
        return used ? BundleResult<void>{} : bad(used.error().line);
    }
};

BundleResult<BundlePlan> plan_of(const Bundle& bundle, const HousePlaces& places,
                                 std::span<const std::string> languages) {
    Planner planner{places, languages};
    planner.plan.made_s = bundle.made_s;
    const auto before = read_settings_as_written(places);
    if (!before) return broken_disk(before.error());
    planner.plan.before = *before;
    planner.plan.after = *before;
    for (const BundleFile& file : bundle.files)
        if (auto added = planner.add(file); !added) return tl::unexpected(added.error());
    if (auto judged = planner.judge_whole(); !judged) return tl::unexpected(judged.error());
    return std::move(planner.plan);
}

/// What an older program cannot know is no fault of the bundle.
BundleError as_of_newer_program(BundleError error, const Bundle& bundle) {
    const auto theirs = version_of(bundle.program);
    const auto ours = version_of(TOUCHLINE_VERSION);
    if (error.fault != BundleFault::bad_contents || !theirs || !ours || *theirs <= *ours)
        return error;
    return {BundleFault::newer_program,
            fmt::format("{}; the bundle is of Touchline {}, update the program of this kiosk "
                        "first",
                        error.line, text_of(*theirs))};
}

/// A shell, or the operator, may have been here between the look and the "yes". The settings come
/// last: a running kiosk writes them without waiting for anybody, and what is seen takes long.
Result<void> judge_anew(const BundlePlan& plan, const HousePlaces& places) {
    const bool is_as_seen_here = std::ranges::all_of(
        plan.seen, [&](const SeenThing& thing) { return is_as_seen(places, thing); });
    const auto last = read_change_record(places);
    const auto settings = read_settings_as_written(places);
    const bool is_as_told =
        is_as_seen_here && last && settings && *last == plan.last && *settings == plan.before;
    if (is_as_told) return {};
    return failure(
        "this kiosk was changed meanwhile; nothing of the bundle was applied, look at "
        "it again");
}

/// The settings of before, if they can be told.
std::optional<Settings> settings_before(const HousePlaces& places, const ChangeRecord& record,
                                        const ChangedThing& thing) {
    const auto file = place_before(places, record, thing);
    if (!file) return Settings{};
    const auto settings = read_text(file->string()).and_then([&](const std::string& all) {
        return apply_settings(Settings{}, all, file->string(), SettingLayer::site);
    });
    return settings ? std::optional(*settings) : std::nullopt;
}

std::string site_file_name(const HousePlaces& places) {
    return places.settings.site.filename().string();
}

}  // namespace

BundleResult<BundlePlan> plan_of_bundle(std::span<const std::byte> bytes, const std::string& name,
                                        const HousePlaces& places,
                                        std::span<const std::string> languages) {
    try {
        const auto key = read_house_key(places);
        if (!key) return tl::unexpected(key.error());
        const auto bundle = bundle_in(bytes, *key, name);
        if (!bundle) return tl::unexpected(bundle.error());
        if (const auto done = finish_change(places); !done) return broken_disk(done.error());
        const auto record = read_change_record(places);
        if (!record) return broken_disk(record.error());
        if (*record && bundle->made_s < (*record)->made_s)
            return bundle_failure(BundleFault::older,
                                  one_line(name) +
                                      ": is older than the bundle that was applied here; go back "
                                      "first, or make a new one");
        auto plan = plan_of(*bundle, places, languages);
        if (!plan) return tl::unexpected(as_of_newer_program(plan.error(), *bundle));
        plan->last = *record;
        return plan;
    } catch (const std::exception&) {
        return bundle_failure(BundleFault::disk,
                              one_line(name) + ": there is not enough memory for this bundle");
    }
}

BundleResult<void> apply_plan(const BundlePlan& plan, const HousePlaces& places) {
    const std::string settings = site_text(plan.after);
    std::vector<NewThing> things;
    for (const PlannedProfile& profile : plan.profiles)
        things.push_back({HouseRoot::profiles,
                          profile.name + ".toml",
                          {{"", std::as_bytes(std::span(profile.text))}}});
    for (const PlannedPack& planned : plan.packs) {
        NewThing folder{HouseRoot::packs, planned.pack.info.id, {}};
        for (const PackFile& file : planned.pack.files)
            folder.files.push_back({file.name, file.bytes});
        things.push_back(std::move(folder));
    }
    for (const PlannedNetwork& planned : plan.networks)
        things.push_back(
            {HouseRoot::networks, std::string(planned.network->file), {{"", planned.bytes}}});
    // After the profiles: a running kiosk must not find the name of one that is not there yet.
    if (plan.after != plan.before)
        things.push_back({HouseRoot::settings,
                          site_file_name(places),
                          {{"", std::as_bytes(std::span(settings))}}});
    bool is_as_seen = true;
    const auto done = change(places, things, plan.made_s, [&] {
        auto judged = judge_anew(plan, places);
        is_as_seen = judged.has_value();
        return judged;
    });
    if (done) return {};
    return is_as_seen ? broken_disk(done.error())
                      : bundle_failure(BundleFault::changed_since, done.error().line);
}

BundleResult<WayBack> find_way_back(const HousePlaces& places) {
    if (const auto done = finish_change(places); !done) return broken_disk(done.error());
    const auto record = read_change_record(places);
    if (!record) return broken_disk(record.error());
    if (!*record || !can_change_back(places, **record))
        return bundle_failure(BundleFault::nothing_to_undo,
                              "no bundle was applied here, or what was before is gone");
    WayBack way{**record, read_settings(places.settings).settings, {}, {}};
    way.before = way.now;
    const auto changed =
        std::ranges::find(way.record.things, HouseRoot::settings, &ChangedThing::root);
    if (changed != way.record.things.end())
        way.before = settings_before(places, way.record, *changed).value_or(way.now);
    for (const ChangedThing& thing : way.record.things)
        if (auto info = thing.root == HouseRoot::packs ? installed_info(places.library / thing.name)
                                                       : PackResult<PackInfo>())
            way.packs.push_back(std::move(*info));
    return way;
}

BundleResult<void> go_back(const WayBack& way, const HousePlaces& places) {
    const auto done = change_back(places, way.record);
    return done ? BundleResult<void>{} : broken_disk(done.error());
}

}  // namespace touchline
