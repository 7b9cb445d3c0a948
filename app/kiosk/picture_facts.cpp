#include "app/kiosk/picture_facts.h"

#include "app/kiosk/part_name.h"
#include "app/session/told_lines.h"

#include <algorithm>

namespace touchline {
namespace {

struct Extent {
    Position low;
    Position high;
};

Extent extent_of(const Outline& outline) {
    Extent box{outline.points.front(), outline.points.front()};
    for (const Position& p : outline.points) {
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    return box;
}

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
        const Extent box = extent_of(outline);
        parts.push_back({part_name(outline.label, language), outline.points.front(),
                         box.low + 0.5 * (box.high - box.low), outline.detail,
                         static_cast<int>(i)});
    }
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

/// Programs make a title without a blank from a file's name.
std::string title_of(const std::string& title, const PictureFile& file, const NameForm& form,
                     const Language& language) {
    const std::string& name = file.file_name;
    if (title == file.title && !name.empty()) return spoken_name(name, language, form);
    const bool is_of_a_person = title.empty() || title.find(' ') != std::string::npos;
    if (is_of_a_person) return title;
    const std::string said = spoken_name(title, language);
    return said == spoken_name(name, language) ? spoken_name(name, language, form) : said;
}

}  // namespace

PictureFacts facts_of(const LoadedScene& scene, const PictureFile& file, const NameForm& form,
                      const Language& language) {
    const TactileMap& map = *scene.felt.map;
    PictureFacts facts;
    facts.title = title_of(scene.facts.title, file, form, language);
    facts.description = map.description;
    facts.place = scene.facts.place;
    facts.outline_count = scene.facts.outline_count;
    facts.note = told_of_file(scene.facts.note, crowded_picture, language);
    facts.names = scene.facts.names;
    facts.outer_outline = outer_outline(map);
    add_outlines(map, language, facts.parts);
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
