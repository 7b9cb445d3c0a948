// The only things that the kiosk may say about a picture by a network's word: never anybody's age,
// gender, feelings or identity, nor food, sports gear, ties or small goods.
// Threads: plain values and pure functions.
#pragma once

#include "config/types/thing_box.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace touchline {

/// `animal`, `vehicle`: an animal or a vehicle of unknown kind. `screen`: of a television or a
/// computer.
enum class ThingName : std::uint8_t {
    person,
    bicycle,
    car,
    motorcycle,
    aeroplane,
    bus,
    train,
    truck,
    boat,
    bird,
    cat,
    dog,
    horse,
    sheep,
    cow,
    elephant,
    bear,
    zebra,
    giraffe,
    bench,
    umbrella,
    chair,
    sofa,
    potted_plant,
    bed,
    table,
    screen,
    refrigerator,
    animal,
    vehicle
};

/// Names for files and reports; what visitors hear is in audio-cues/words.
inline constexpr std::array<std::string_view, 30> thing_ids{
    "person", "bicycle", "car",     "motorcycle",   "aeroplane", "bus",    "train", "truck",
    "boat",   "bird",    "cat",     "dog",          "horse",     "sheep",  "cow",   "elephant",
    "bear",   "zebra",   "giraffe", "bench",        "umbrella",  "chair",  "sofa",  "potted plant",
    "bed",    "table",   "screen",  "refrigerator", "animal",    "vehicle"};

inline constexpr std::size_t thing_name_count = thing_ids.size();
static_assert(static_cast<std::size_t>(ThingName::vehicle) + 1 == thing_name_count);

/// Reads a number from another process; returns nothing if it names no thing.
[[nodiscard]] constexpr std::optional<ThingName> thing_name_of(std::uint32_t number) {
    if (number >= thing_name_count) return std::nullopt;
    return static_cast<ThingName>(number);
}

[[nodiscard]] constexpr std::string_view id_of(ThingName name) {
    return thing_ids[static_cast<std::size_t>(name)];
}

[[nodiscard]] constexpr bool is_animal(ThingName name) {
    return name == ThingName::animal || (name >= ThingName::bird && name <= ThingName::giraffe);
}

[[nodiscard]] constexpr bool is_vehicle(ThingName name) {
    return name == ThingName::vehicle || (name >= ThingName::bicycle && name <= ThingName::boat);
}

/// A guess: the thing that a network sees in the box.
struct NamedThing {
    ThingName name = ThingName::person;
    ThingBox box;
    double likelihood = 0.0;  // 0 to 1; not the chance of being right

    friend bool operator==(const NamedThing&, const NamedThing&) = default;
};

}  // namespace touchline
