#include "vision/name/names.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

namespace touchline {
namespace {

/// The likelihoods from which "an animal" or "a vehicle" is said.
constexpr double kAnimalFrom = 0.5;
constexpr double kVehicleFrom = 0.6;
/// Beside a thing that has a word, another of the same kind is likely: it counts from here on.
constexpr double kCountedFrom = 0.45;

/// A kind's own word is said from one of these on, by what else is taken for it (README.md). For
/// the first, hardly anything is: only dolls and towels for people.
constexpr double kHardlyMistaken = 0.6;
/// Some things are taken for these: hills for beds, pianos for benches, llamas for dogs.
constexpr double kMistaken = 0.68;
/// Many things are taken for these: wild dogs for cats, lizards for birds, bisons for sheep, sharks
/// for aeroplanes.
constexpr double kOftenMistaken = 0.72;
/// These have look-alikes that the network does not know, and it is almost sure of them: it takes
/// tigers for zebras, rhinoceroses for elephants, baboons for bears.
constexpr double kLookAlike = 0.82;

struct SaidKind {
    int kind = 0;  // in COCO's order
    ThingName name = ThingName::person;
    double sure_from = 1.0;
};

/// A kind that is not listed here is never said.
constexpr std::array kSaidKinds{SaidKind{0, ThingName::person, kHardlyMistaken},
                                SaidKind{1, ThingName::bicycle, kOftenMistaken},
                                SaidKind{2, ThingName::car, kHardlyMistaken},
                                SaidKind{3, ThingName::motorcycle, kOftenMistaken},
                                SaidKind{4, ThingName::aeroplane, kOftenMistaken},
                                SaidKind{5, ThingName::bus, kOftenMistaken},
                                SaidKind{6, ThingName::train, kOftenMistaken},
                                SaidKind{7, ThingName::truck, kOftenMistaken},
                                SaidKind{8, ThingName::boat, kOftenMistaken},
                                SaidKind{13, ThingName::bench, kMistaken},
                                SaidKind{14, ThingName::bird, kOftenMistaken},
                                SaidKind{15, ThingName::cat, kOftenMistaken},
                                SaidKind{16, ThingName::dog, kMistaken},
                                SaidKind{17, ThingName::horse, kOftenMistaken},
                                SaidKind{18, ThingName::sheep, kOftenMistaken},
                                SaidKind{19, ThingName::cow, kOftenMistaken},
                                SaidKind{20, ThingName::elephant, kLookAlike},
                                SaidKind{21, ThingName::bear, kLookAlike},
                                SaidKind{22, ThingName::zebra, kLookAlike},
                                SaidKind{23, ThingName::giraffe, kOftenMistaken},
                                SaidKind{25, ThingName::umbrella, kMistaken},
                                SaidKind{56, ThingName::chair, kMistaken},
                                SaidKind{57, ThingName::sofa, kMistaken},
                                SaidKind{58, ThingName::potted_plant, kMistaken},
                                SaidKind{59, ThingName::bed, kMistaken},
                                SaidKind{60, ThingName::table, kMistaken},
                                SaidKind{62, ThingName::screen, kMistaken},
                                SaidKind{72, ThingName::refrigerator, kMistaken}};

using Things = std::vector<NamedThing>;
using Words = std::set<ThingName>;

const SaidKind* said_kind(const Detection& found) {
    const auto* const at = std::ranges::find(kSaidKinds, found.kind, &SaidKind::kind);
    return at == kSaidKinds.end() ? nullptr : at;
}

/// Returns "an animal" or "a vehicle"; nothing for anything else.
std::optional<ThingName> general_word(ThingName name) {
    if (is_animal(name)) return ThingName::animal;
    if (is_vehicle(name)) return ThingName::vehicle;
    return std::nullopt;
}

double general_from(ThingName general) {
    return general == ThingName::animal ? kAnimalFrom : kVehicleFrom;
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
    if (kind == nullptr || detection.likelihood < kCountedFrom) return std::nullopt;
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
