// What may be in a picture, where it is, and what the kiosk may say that it is.
// Threads: plain values and pure functions.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace touchline {

/// A thing's place, as shares of the picture's width and height from its upper left corner.
struct ThingBox {
    double left = 0.0;
    double top = 0.0;
    double right = 0.0;
    double bottom = 0.0;

    friend bool operator==(const ThingBox&, const ThingBox&) = default;
};

/// Returns whether it lies in the picture and is not empty; false if a side is NaN.
[[nodiscard]] constexpr bool is_sound(const ThingBox& box) {
    return box.left >= 0.0 && box.left < box.right && box.right <= 1.0 && box.top >= 0.0 &&
           box.top < box.bottom && box.bottom <= 1.0;
}

/// Returns the share of the picture that it covers.
[[nodiscard]] constexpr double area_of(const ThingBox& box) {
    return (box.right - box.left) * (box.bottom - box.top);
}

/// Returns the area of their intersection over that of their union: 1 if they are the same, 0 if
/// they do not meet.
[[nodiscard]] constexpr double overlap_of(const ThingBox& a, const ThingBox& b) {
    const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    if (!(width > 0.0 && height > 0.0)) return 0.0;
    return width * height / (area_of(a) + area_of(b) - width * height);
}

/// Returns the smallest box that holds both.
[[nodiscard]] constexpr ThingBox around(const ThingBox& a, const ThingBox& b) {
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
            std::max(a.bottom, b.bottom)};
}

/// The only things that the kiosk may name by a network's word: never anybody's age, gender,
/// feelings or identity, nor food, sports gear, ties or small goods.
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

/// The parts of a face that a hand meets, one line each.
/// Left and right are as the hand feels them, so the left eye lies on the left of the picture.
enum class FacePart : std::uint8_t {
    face,  // its oval, from the hairline to the chin
    left_brow,
    right_brow,
    left_eye,
    right_eye,
    nose,  // its ridge
    nostrils,
    mouth,
    person,  // the outline of hair, hat and shoulders
};

/// Names of the parts in maps; the spoken words are in audio-cues/words (context "part").
inline constexpr std::array<std::string_view, 9> face_part_ids{
    "face", "left brow", "right brow", "left eye",          "right eye",
    "nose", "nostrils",  "mouth",      "hair and shoulders"};

[[nodiscard]] constexpr std::string_view id_of(FacePart part) {
    return face_part_ids[static_cast<std::size_t>(part)];
}

}  // namespace touchline
