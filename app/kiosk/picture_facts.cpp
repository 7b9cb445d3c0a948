#include "app/kiosk/picture_facts.h"

#include "app/visit/screen_model.h"
#include "app/visit/told_lines.h"
#include "audio-cues/words/part_name.h"
#include "config/types/extent.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace touchline {
namespace {

/// The part of the outline with this label.
std::optional<std::size_t> part_labelled(const TactileMap& map, const std::vector<PartFacts>& parts,
                                         const std::string& label) {
    const auto at = std::ranges::find_if(parts, [&](const PartFacts& part) {
        return part.outline && map.outlines[static_cast<std::size_t>(*part.outline)].label == label;
    });
    if (at == parts.end()) return std::nullopt;
    return static_cast<std::size_t>(at - parts.begin());
}

void add_outlines(const TactileMap& map, const Language& language, std::vector<PartFacts>& parts) {
    for (std::size_t i = 0; i < map.outlines.size(); ++i) {
        const Outline& outline = map.outlines[i];
        if (outline.label.empty() || part_labelled(map, parts, outline.label)) continue;
        parts.push_back({part_name(outline.label, language), outline.points.front(),
                         extent_of(outline).middle(), outline.detail, static_cast<int>(i)});
    }
}

void add_recordings(const TactileMap& map, const PictureRecordings& recordings,
                    PictureFacts& facts) {
    facts.title_recording = recordings.title;
    facts.description_recording = recordings.description;
    for (const auto& [label, recording] : recordings.parts)
        if (const auto part = part_labelled(map, facts.parts, label))
            facts.parts[*part].recording = recording;
}

/// The line around most of the picture; 0 if there is none.
int outer_outline(const TactileMap& map) {
    int outer = 0;
    double most_m2 = -1.0;
    for (std::size_t i = 0; i < map.outlines.size(); ++i) {
        const Extent box = extent_of(map.outlines[i]);
        const double size_m2 = (box.high.x - box.low.x) * (box.high.y - box.low.y);
        if (size_m2 <= most_m2) continue;
        most_m2 = size_m2;
        outer = static_cast<int>(i);
    }
    return outer;
}

std::optional<std::size_t> nearest_spot(const std::vector<PartFacts>& parts, Position place) {
    std::optional<std::size_t> nearest;
    double least_m = spot_m;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double distance_m = norm(parts[i].place_W - place);
        if (parts[i].outline || !(distance_m <= least_m)) continue;
        least_m = distance_m;
        nearest = i;
    }
    return nearest;
}

/// The title that the document has beside its name in the list; empty if there is none, or if it
/// sounds like the name, so that a list of both would tell them apart. Programs make a title
/// without a blank from a file's name.
std::string own_title(const std::string& title, const PictureFile& file, const Language& language) {
    if (title.empty() || title == file.title) return {};
    const std::array names{file.file_name, title};
    const std::vector<NameForm> plain(names.size());
    if (spoken_forms(names, std::span(&language, 1)) != plain) return {};
    return title.find(' ') == std::string::npos ? spoken_name(title, language) : title;
}

/// Title and description. The gallery's pictures and photographs are no files of a list.
void name(PictureFacts& facts, const std::string& title, const PictureFile& file,
          const NameForm& form, const Language& language) {
    facts.title = title;
    if (file.file_name.empty()) return;
    facts.title = spoken_name(file.file_name, language, form);
    std::string description = own_title(title, file, language);
    add_sentence(description, facts.description);
    facts.description = std::move(description);
}

}  // namespace

PictureFacts facts_of(const LoadedScene& scene, const PictureFile& file, const NameForm& form,
                      const Language& language) {
    const TactileMap& map = *scene.felt.map;
    PictureFacts facts;
    facts.description = map.description;
    name(facts, scene.facts.title, file, form, language);
    facts.place = scene.facts.place;
    facts.outline_count = scene.facts.outline_count;
    facts.note = told_of_file(scene.facts.note, crowded_picture, language);
    facts.names = scene.facts.names;
    facts.outer_outline = outer_outline(map);
    add_outlines(map, language, facts.parts);
    if (scene.facts.recordings) add_recordings(map, *scene.facts.recordings, facts);
    for (const Label& label : map.labels) {
        if (!label.text.empty())
            facts.parts.push_back({label.text, label.place, label.place, 1, std::nullopt});
    }
    return facts;
}

std::optional<std::size_t> part_at(const TactileMap& map, const std::vector<PartFacts>& parts,
                                   const HandState& hand) {
    const bool is_on_line = hand.outline >= 0 && hand.map_version == map.version &&
                            static_cast<std::size_t>(hand.outline) < map.outlines.size();
    if (is_on_line) {
        const auto part =
            part_labelled(map, parts, map.outlines[static_cast<std::size_t>(hand.outline)].label);
        if (part) return part;
    }
    return nearest_spot(parts, hand.p_WH);
}

}  // namespace touchline
