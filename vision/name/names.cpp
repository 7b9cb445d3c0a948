#include "vision/name/names.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

namespace touchline {
namespace {

/// The likelihoods from which "an animal" or "a vehicle" is said.
constexpr double animal_from = 0.5;
constexpr double vehicle_from = 0.6;
/// Beside a thing that has a word, another of the same kind is likely: it counts from here on.
constexpr double counted_from = 0.45;

/// A kind's own word is said from one of these on, by what else is taken for it (README.md). For
/// the first, hardly anything is: only dolls and towels for people.
constexpr double hardly_mistaken = 0.6;
/// Some things are taken for these: hills for beds, pianos for benches, llamas for dogs.
constexpr double mistaken = 0.68;
/// Many things are taken for these: wild dogs for cats, lizards for birds, bisons for sheep, sharks
/// for aeroplanes.
constexpr double often_mistaken = 0.72;
/// These have look-alikes that the network does not know, and it is almost sure of them: it takes
/// tigers for zebras, rhinoceroses for elephants, baboons for bears.
constexpr double look_alike = 0.82;

struct SaidKind {
    int kind = 0;  // in COCO's order
    ThingName name = ThingName::person;
    double sure_from = 1.0;
};

/// A kind that is not listed here is never said.
constexpr std::array said_kinds{SaidKind{0, ThingName::person, hardly_mistaken},
                                SaidKind{1, ThingName::bicycle, often_mistaken},
                                SaidKind{2, ThingName::car, hardly_mistaken},
                                SaidKind{3, ThingName::motorcycle, often_mistaken},
                                SaidKind{4, ThingName::aeroplane, often_mistaken},
                                SaidKind{5, ThingName::bus, often_mistaken},
                                SaidKind{6, ThingName::train, often_mistaken},
                                SaidKind{7, ThingName::truck, often_mistaken},
                                SaidKind{8, ThingName::boat, often_mistaken},
                                SaidKind{13, ThingName::bench, mistaken},
                                SaidKind{14, ThingName::bird, often_mistaken},
                                SaidKind{15, ThingName::cat, often_mistaken},
                                SaidKind{16, ThingName::dog, mistaken},
                                SaidKind{17, ThingName::horse, often_mistaken},
                                SaidKind{18, ThingName::sheep, often_mistaken},
                                SaidKind{19, ThingName::cow, often_mistaken},
                                SaidKind{20, ThingName::elephant, look_alike},
                                SaidKind{21, ThingName::bear, look_alike},
                                SaidKind{22, ThingName::zebra, look_alike},
                                SaidKind{23, ThingName::giraffe, often_mistaken},
                                SaidKind{25, ThingName::umbrella, mistaken},
                                SaidKind{56, ThingName::chair, mistaken},
                                SaidKind{57, ThingName::sofa, mistaken},
                                SaidKind{58, ThingName::potted_plant, mistaken},
                                SaidKind{59, ThingName::bed, mistaken},
                                SaidKind{60, ThingName::table, mistaken},
                                SaidKind{62, ThingName::screen, mistaken},
                                SaidKind{72, ThingName::refrigerator, mistaken}};

using Things = std::vector<NamedThing>;
using Words = std::set<ThingName>;

const SaidKind* said_kind(const Detection& found) {
    const auto* const at = std::ranges::find(said_kinds, found.kind, &SaidKind::kind);
    return at == said_kinds.end() ? nullptr : at;
}

/// Returns "an animal" or "a vehicle"; nothing for anything else.
std::optional<ThingName> general_word(ThingName name) {
    if (is_animal(name)) return ThingName::animal;
    if (is_vehicle(name)) return ThingName::vehicle;
    return std::nullopt;
}

double general_from(ThingName general) {
    return general == ThingName::animal ? animal_from : vehicle_from;
}

/// Collects all own words, and a general one if none of its kind has an own word: beside a dog, "an
/// animal" may be the same dog again.
Words words_for(std::span<const Detection> found) {
    Words words;
    for (const Detection& detection : found) {
        const SaidKind* kind = said_kind(detection);
        if (kind != nullptr && detection.likelihood >= kind->sure_from) words.insert(kind->name);
    }
    const Words own = words;
    for (const Detection& detection : found) {
        const SaidKind* kind = said_kind(detection);
        const auto general = kind != nullptr ? general_word(kind->name) : std::nullopt;
        if (!general || detection.likelihood < general_from(*general)) continue;
        const bool is_beside_own = std::ranges::any_of(
            own, [general](ThingName word) { return general_word(word) == general; });
        if (!is_beside_own) words.insert(*general);
    }
    return words;
}

std::optional<ThingName> word_of(const Detection& detection, const Words& words) {
    const SaidKind* kind = said_kind(detection);
    if (kind == nullptr || detection.likelihood < counted_from) return std::nullopt;
    if (words.contains(kind->name)) return kind->name;
    const auto general = general_word(kind->name);
    return general && words.contains(*general) ? general : std::nullopt;
}

Things of_first_names(const Things& things) {
    Things kept;
    Words names;
    for (const NamedThing& thing : things) {
        if (!names.contains(thing.name) && names.size() == most_names) continue;
        names.insert(thing.name);
        kept.push_back(thing);
        if (kept.size() == most_named_things) break;
    }
    return kept;
}

}  // namespace

Things names_of(std::span<const Detection> found) {
    const Words words = words_for(found);
    Things things;
    for (const Detection& detection : found) {
        if (const auto word = word_of(detection, words))
            things.push_back({*word, detection.box, detection.likelihood});
    }
    std::ranges::stable_sort(things, std::ranges::greater{},
                             [](const NamedThing& thing) { return area_of(thing.box); });
    return of_first_names(things);
}

std::vector<ThingBox> people_in(std::span<const Detection> found) {
    std::vector<ThingBox> boxes;
    for (const Detection& detection : found) {
        if (detection.kind == 0) boxes.push_back(detection.box);
    }
    return boxes;
}

}  // namespace touchline
