#include "audio-cues/words/words_of.h"

#include "audio-cues/cues/cue_table.h"

#include <algorithm>
#include <array>
#include <vector>

namespace touchline {
namespace {

constexpr int most_counted = 4;
/// As a share of the picture's area: from a half on, "most" is true.
constexpr double most_from = 0.5;
/// As a share of the picture's width: things that span three of the five columns are in none of
/// them.
constexpr double across_from = 0.6;
constexpr int columns = 5;
/// As shares of the picture's height: the middle row is a little higher than the others, so that a
/// thing only somewhat off the middle is not said to be at the top or at the bottom.
constexpr double top_until = 0.3;
constexpr double bottom_from = 0.7;

struct ThingText {
    const char* one;
    const char* many;
};

/// The texts are in the order of ThingName.
constexpr std::array<ThingText, thing_name_count> texts{{{"a person", "{0} people"},
                                                         {"a bicycle", "{0} bicycles"},
                                                         {"a car", "{0} cars"},
                                                         {"a motorcycle", "{0} motorcycles"},
                                                         {"an aeroplane", "{0} aeroplanes"},
                                                         {"a bus", "{0} buses"},
                                                         {"a train", "{0} trains"},
                                                         {"a lorry", "{0} lorries"},
                                                         {"a boat", "{0} boats"},
                                                         {"a bird", "{0} birds"},
                                                         {"a cat", "{0} cats"},
                                                         {"a dog", "{0} dogs"},
                                                         {"a horse", "{0} horses"},
                                                         {"a sheep", "{0} sheep"},
                                                         {"a cow", "{0} cows"},
                                                         {"an elephant", "{0} elephants"},
                                                         {"a bear", "{0} bears"},
                                                         {"a zebra", "{0} zebras"},
                                                         {"a giraffe", "{0} giraffes"},
                                                         {"a bench", "{0} benches"},
                                                         {"an umbrella", "{0} umbrellas"},
                                                         {"a chair", "{0} chairs"},
                                                         {"a sofa", "{0} sofas"},
                                                         {"a potted plant", "{0} potted plants"},
                                                         {"a bed", "{0} beds"},
                                                         {"a table", "{0} tables"},
                                                         {"a screen", "{0} screens"},
                                                         {"a refrigerator", "{0} refrigerators"},
                                                         {"an animal", "{0} animals"},
                                                         {"a vehicle", "{0} vehicles"}}};

/// The rows go from the top, the columns from the left.
constexpr std::array<std::array<const char*, columns>, 3> place_texts{
    {{"at the top left", "at the top, left of the middle", "at the top",
      "at the top, right of the middle", "at the top right"},
     {"on the left", "left of the middle", "in the middle", "right of the middle", "on the right"},
     {"at the bottom left", "at the bottom, left of the middle", "at the bottom",
      "at the bottom, right of the middle", "at the bottom right"}}};

/// All things with one name.
struct Group {
    ThingName name;
    ThingBox box;  // around all of them
    double largest_area = 0.0;
    int count = 1;
};

std::vector<Group> groups_of(std::span<const NamedThing> things) {
    std::vector<Group> groups;
    for (const NamedThing& thing : things) {
        const auto at = std::ranges::find(groups, thing.name, &Group::name);
        if (at == groups.end()) {
            groups.push_back({thing.name, thing.box, area_of(thing.box)});
        } else {
            at->box = around(at->box, thing.box);
            at->largest_area = std::max(at->largest_area, area_of(thing.box));
            ++at->count;
        }
    }
    return groups;
}

/// Returns the words for the middle of the box, or for how much of the picture the largest thing
/// covers.
std::string place_of(const ThingBox& box, double largest_area, const Language& language) {
    if (largest_area >= most_from) return language.text("thing place", "in most of the picture");
    const double x = (box.left + box.right) / 2.0;
    const double y = (box.top + box.bottom) / 2.0;
    const std::size_t row = y < top_until ? 0 : y <= bottom_from ? 1 : 2;
    const auto column = static_cast<std::size_t>(std::clamp(x * columns, 0.0, columns - 1.0));
    return language.text("thing place", place_texts[row][column]);
}

std::string place_of(const Group& group, const Language& language) {
    const bool is_across = group.count > 1 && group.box.right - group.box.left >= across_from;
    if (is_across) return language.text("thing place", "across the picture");
    return place_of(group.box, group.largest_area, language);
}

}  // namespace

std::string words_of(Place place, const Language& language) {
    // In the order of Place.
    static constexpr std::array names{"upper left", "top",    "upper right",
                                      "left",       "middle", "right",
                                      "lower left", "bottom", "lower right"};
    return language.text("place", names[static_cast<std::size_t>(place)]);
}

std::string words_of(Cue cue, const Language& language) {
    return language.text("sound", std::string(row_of(cue).name));
}

std::string words_of(ThingName name, int count, const Language& language) {
    const ThingText& text = texts[static_cast<std::size_t>(name)];
    const std::string counted =
        language.counted("thing", text.one, text.many, std::min(count, most_counted));
    return count < most_counted ? counted : language.text("things", "{0} or more", {counted});
}

std::string words_of(const ThingBox& box, const Language& language) {
    return place_of(box, area_of(box), language);
}

std::string words_of(std::span<const NamedThing> things, const Language& language) {
    std::string words;
    for (const Group& group : groups_of(things)) {
        const char* sentence = words.empty() ? "Probably {0}, {1}." : "And probably {0}, {1}.";
        if (!words.empty()) words += ' ';
        words +=
            language.text("things", sentence,
                          {words_of(group.name, group.count, language), place_of(group, language)});
    }
    return words;
}

}  // namespace touchline
