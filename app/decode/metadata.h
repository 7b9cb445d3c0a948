// Private to app/decode: what a picture's file says beside its pixels, through libexiv2.
// Threads: one at a time (libexiv2's XMP reader has state).
#pragma once

#include "app/decode/formats.h"

#include <cstdint>
#include <string>
#include <vector>

namespace touchline::decode {

struct Metadata {
    std::string title;
    std::string description;  // what was written for those who cannot see it comes first
    int orientation = 1;      // 1 ... 8, as EXIF numbers them
    Resolution resolution{};  // of EXIF
    std::vector<std::uint8_t> colour_profile;  // ICC; empty: none
};

/// All that can be read; damaged metadata are no reason to refuse a picture.
[[nodiscard]] Metadata metadata_of(Bytes bytes);

/// Colours of another profile become sRGB, in place, by lcms2. A profile that is damaged, or not
/// for red, green and blue, changes nothing.
void convert_to_srgb(const std::vector<std::uint8_t>& colour_profile, Picture& picture);

}  // namespace touchline::decode
