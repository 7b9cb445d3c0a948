// Private to app/decode: what a picture's file says beside its pixels, read by libexiv2.
// Threads: one at a time (libexiv2's XMP reader has state).
#pragma once

#include "app/decode/formats.h"

#include <cstdint>
#include <string>
#include <vector>

namespace touchline::decode {

struct Metadata {
    std::string title;
    std::string description;                   // text for people who cannot see it comes first
    int orientation = 1;                       // an EXIF number, 1 ... 8
    Resolution resolution{};                   // by EXIF
    std::vector<std::uint8_t> colour_profile;  // ICC; empty: none
};

/// Reads everything that can be read. Damaged metadata are no reason to refuse a picture.
[[nodiscard]] Metadata metadata_of(Bytes bytes);

/// Converts colours of another profile to sRGB, in place, by lcms2. Changes nothing if the profile
/// is damaged, or not for red, green and blue.
void convert_to_srgb(const std::vector<std::uint8_t>& colour_profile, Picture& picture);

}  // namespace touchline::decode
