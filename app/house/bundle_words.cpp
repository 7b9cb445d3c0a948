// What a bundle changes, as lines for a voice, a screen and a terminal.
#include "app/house/bundle_plan.h"
#include "app/operator/setting_words.h"
#include "audio-cues/words/language.h"
#include "config/settings/setting_rows.h"

#include <algorithm>

namespace touchline {
namespace {

std::string bundle_words(const Language& language, const char* english,
                         std::initializer_list<std::string_view> values) {
    return language.text("bundle", english, values);
}

void add_setting_lines(const Settings& before, const Settings& after, const Language& language,
                       std::vector<std::string>& lines) {
    for (const SettingRow& row : setting_rows())
        if (value_of(before, row) != value_of(after, row))
            lines.push_back(
                bundle_words(language, "{0}: from {1} to {2}",
                             {setting_name(row, language), setting_value(before, row, language),
                              setting_value(after, row, language)}));
}

std::string pack_line(const PlannedPack& planned, const Language& language) {
    const PackInfo& info = planned.pack.info;
    const std::string& title = title_in(info, language.code());
    if (!planned.here) return bundle_words(language, "Pack {0}: new", {title});
    if (*planned.here == info.version) return bundle_words(language, "Pack {0}: changed", {title});
    return bundle_words(language, "Pack {0}: from version {1} to version {2}",
                        {title, text_of(*planned.here), text_of(info.version)});
}

/// A pack that was taken out since, or damaged, has its id alone.
std::string pack_title(const WayBack& way, const std::string& id, const Language& language) {
    const auto info = std::ranges::find(way.packs, id, &PackInfo::id);
    return info == way.packs.end() ? id : title_in(*info, language.code());
}

/// What a thing is called once it goes back, or goes.
std::string way_back_line(const WayBack& way, const ChangedThing& thing, const Language& language) {
    const std::string name = thing.name.substr(0, thing.name.find('.'));
    switch (thing.root) {
        case HouseRoot::profiles:
            return bundle_words(language,
                                thing.was_there ? "Profile {0}: as before" : "Profile {0}: removed",
                                {language.text("profile", name)});
        case HouseRoot::packs:
            return bundle_words(language,
                                thing.was_there ? "Pack {0}: as before" : "Pack {0}: removed",
                                {pack_title(way, thing.name, language)});
        case HouseRoot::networks:
            return bundle_words(language,
                                thing.was_there ? "Network {0}: as before" : "Network {0}: removed",
                                {name});
        case HouseRoot::house:
        case HouseRoot::settings:
            return {};
    }
    return {};
}

}  // namespace

std::vector<std::string> plan_lines(const BundlePlan& plan, const Language& language) {
    std::vector<std::string> lines;
    add_setting_lines(plan.before, plan.after, language, lines);
    for (const PlannedProfile& profile : plan.profiles)
        lines.push_back(bundle_words(language,
                                     profile.is_new ? "Profile {0}: new" : "Profile {0}: changed",
                                     {language.text("profile", profile.name)}));
    for (const PlannedPack& planned : plan.packs) lines.push_back(pack_line(planned, language));
    for (const PlannedNetwork& planned : plan.networks)
        lines.push_back(bundle_words(language, "Network {0}: new", {planned.network->name}));
    return lines;
}

std::vector<std::string> way_back_lines(const WayBack& way, const Language& language) {
    std::vector<std::string> lines;
    add_setting_lines(way.now, way.before, language, lines);
    for (const ChangedThing& thing : way.record.things)
        if (std::string line = way_back_line(way, thing, language); !line.empty())
            lines.push_back(std::move(line));
    return lines;
}

}  // namespace touchline
