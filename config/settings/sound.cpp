#include "config/settings/sound.h"

#include "config/settings/settings_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

#include <toml++/toml.h>

namespace touchline {
namespace {

constexpr std::array settings{
    LevelSetting{"full_scale_dB", &OutputProfile::full_scale_dB, 60.0, 140.0,
                 "what arrives of a full sine in the middle, as measured"},
    LevelSetting{"quietest_dB", &OutputProfile::quietest_dB, 20.0, 80.0,
                 "speech at the lowest volume"},
    LevelSetting{"loudest_dB", &OutputProfile::loudest_dB, 38.0, 105.0,
                 "speech at the highest volume"},
    LevelSetting{"step_dB", &OutputProfile::step_dB, 1.0, 6.0, "from one volume to the next"},
    LevelSetting{"default_dB", &OutputProfile::default_dB, 60.0, 70.0,
                 "speech at the start of every session"},
    LevelSetting{"cap_dB", &OutputProfile::cap_dB, 60.0, 105.0, "no peak is above"},
    LevelSetting{"ambient_dB", &OutputProfile::ambient_dB, 0.0, 85.0,
                 "the room, as the operator measured it"},
};

struct KindName {
    OutputKind kind;
    std::string_view name;
};

constexpr std::array kinds{KindName{OutputKind::headset, "headset"},
                           KindName{OutputKind::speaker, "speaker"}};

/// Reads the tables, and keeps the first fault in `wrong`.
class SoundReader {
  public:
    explicit SoundReader(std::string_view file) : file_(file) {}

    SoundSettings read(const toml::table& table) {
        SoundSettings sound;
        for (const auto& [key, node] : table) {
            if (key.str() == "headset") {
                read_output(node, sound.headset);
            } else if (key.str() == "speaker") {
                read_output(node, sound.speaker);
            } else if (key.str() == "assumed_output") {
                read_assumed(node, sound.assumed);
            } else {
                blame(node, quoted(key.str()) + " is not a setting here");
            }
        }
        return sound;
    }

    std::string wrong;

  private:
    static std::string quoted(std::string_view key) { return "'" + std::string(key) + "'"; }

    void blame(const toml::node& node, const std::string& why) {
        if (!wrong.empty()) return;
        wrong = line_in_file(file_, node.source().begin.line, why);
    }

    void read_assumed(const toml::node& node, OutputKind& assumed) {
        const auto name = node.value<std::string_view>();
        const auto found = std::find_if(kinds.begin(), kinds.end(), [&name](const KindName& known) {
            return known.name == name;
        });
        if (found == kinds.end()) {
            blame(node, "'assumed_output' must be \"headset\" or \"speaker\"");
        } else {
            assumed = found->kind;
        }
    }

    void read_output(const toml::node& node, OutputProfile& profile) {
        const toml::table* table = node.as_table();
        if (table == nullptr) return blame(node, "an output is a table, like [headset]");
        for (const auto& [key, value] : *table) read_value(key.str(), value, profile);
        if (const auto kept = check(profile); !kept) blame(node, kept.error().line);
    }

    void read_value(std::string_view key, const toml::node& node, OutputProfile& profile) {
        const auto setting =
            std::find_if(settings.begin(), settings.end(),
                         [key](const LevelSetting& known) { return known.key == key; });
        if (setting != settings.end()) return read_level(*setting, node, profile);
        if (key != "mono") return blame(node, quoted(key) + " is not a setting here");
        const auto is_mono = node.is_boolean() ? node.value<bool>() : std::nullopt;
        if (!is_mono) blame(node, "'mono' must be true or false");
        profile.is_mono = is_mono.value_or(false);
    }

    void read_level(const LevelSetting& setting, const toml::node& node, OutputProfile& profile) {
        const auto level_dB = node.is_number() ? node.value<double>() : std::nullopt;
        if (level_dB && *level_dB >= setting.least_dB && *level_dB <= setting.most_dB) {
            profile.*setting.level_dB = *level_dB;
            return;
        }
        std::ostringstream why;
        why << quoted(setting.key) << " must be a number from " << setting.least_dB << " to "
            << setting.most_dB << ", in dB";
        blame(node, why.str());
    }

    std::string file_;
};

bool is_a_step(const OutputProfile& profile) {
    const double steps = (profile.default_dB - profile.quietest_dB) / profile.step_dB;
    const bool is_between =
        profile.default_dB >= profile.quietest_dB && profile.default_dB <= profile.loudest_dB;
    return is_between && std::abs(steps - std::round(steps)) * profile.step_dB <= 0.01;
}

void add_output(std::ostringstream& text, std::string_view name, const OutputProfile& profile) {
    toml::table table;
    for (const LevelSetting& setting : settings)
        table.insert(setting.key, profile.*setting.level_dB);
    table.insert("mono", profile.is_mono);
    text << "\n[" << name << "]\n" << table << '\n';
}

}  // namespace

std::span<const LevelSetting> level_settings() {
    return settings;
}

OutputProfile default_output(OutputKind kind) {
    OutputProfile profile;
    profile.kind = kind;
    if (kind == OutputKind::speaker) {
        profile.full_scale_dB = 95.0;
        profile.loudest_dB = 75.0;
        profile.cap_dB = 92.0;
    }
    return profile;
}

Result<void> check(const OutputProfile& profile) {
    const auto is_finite = [&profile](const LevelSetting& setting) {
        return std::isfinite(profile.*setting.level_dB);
    };
    if (!std::all_of(settings.begin(), settings.end(), is_finite))
        return failure("Every level of an output is a number.");
    if (profile.step_dB < 1.0 || profile.step_dB > 6.0)
        return failure("A volume step is 1 to 6 dB.");
    if (profile.loudest_dB - profile.quietest_dB < 18.0)
        return failure("The volume has a range of 18 dB at least.");
    if (profile.ambient_dB > 45.0 && profile.loudest_dB < profile.ambient_dB + 20.0)
        return failure("In a room of more than 45 dB the volume reaches 20 dB above it.");
    const bool is_speaker = profile.kind == OutputKind::speaker;
    if (is_speaker && profile.loudest_dB < 65.0) return failure("A speaker reaches 65 dB.");
    if (profile.default_dB < 60.0 || profile.default_dB > (is_speaker ? 65.0 : 70.0)) {
        return failure(is_speaker ? "A speaker begins with 60 to 65 dB."
                                  : "A headset begins with 60 to 70 dB.");
    }
    if (!is_a_step(profile)) return failure("The volume to begin with is one of its steps.");
    if (profile.cap_dB < profile.loudest_dB || profile.cap_dB > 105.0 ||
        profile.cap_dB > profile.full_scale_dB) {
        return failure(
            "The cap lies above the loudest speech, within 105 dB and what the output gives.");
    }
    return {};
}

Result<SoundSettings> parse_sound(std::string_view text, std::string_view name) {
    try {
        SoundReader reader(name);
        const SoundSettings sound = reader.read(toml::parse(text));
        if (!reader.wrong.empty()) return failure(reader.wrong);
        return sound;
    } catch (const toml::parse_error& error) {
        return failure(
            line_in_file(name, error.source().begin.line, std::string(error.description())));
    }
}

Result<SoundSettings> read_sound(const std::filesystem::path& file) {
    const auto text = read_settings_file(file);
    if (!text) return tl::unexpected(text.error());
    return parse_sound(*text, file.string());
}

std::string sound_text(const SoundSettings& sound) {
    std::ostringstream text;
    text << "assumed_output = '" << kinds[static_cast<std::size_t>(sound.assumed)].name << "'\n";
    add_output(text, "headset", sound.headset);
    add_output(text, "speaker", sound.speaker);
    return text.str();
}

}  // namespace touchline
