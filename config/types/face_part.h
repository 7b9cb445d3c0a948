// The parts of a face that a hand meets, one line each. Threads: plain values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace touchline {

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
