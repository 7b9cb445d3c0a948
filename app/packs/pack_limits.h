// The limits of a picture pack. Anything beyond is refused before it costs anything.
// Threads: constants.
#pragma once

#include <cstddef>

namespace touchline {

struct PackLimits {
    std::size_t zip_bytes = 0;   // of the zip file
    std::size_t files = 0;       // how many
    std::size_t file_bytes = 0;  // of one file, unpacked
    std::size_t all_bytes = 0;   // of all files, unpacked
    std::size_t toml_bytes = 0;  // of pack.toml
    std::size_t name_bytes = 0;  // of a file, with its folders
    std::size_t folders = 0;     // above a file
    std::size_t pictures = 0;
    std::size_t sounds = 0;
    std::size_t languages = 0;
    std::size_t text_bytes = 0;  // of a title or an author
    double sound_s = 0.0;        // of one recording
};

inline constexpr PackLimits pack_limits{.zip_bytes = std::size_t{64} << 20U,
                                        .files = 500,
                                        .file_bytes = std::size_t{16} << 20U,
                                        .all_bytes = std::size_t{96} << 20U,
                                        .toml_bytes = std::size_t{1} << 20U,
                                        .name_bytes = 120,
                                        .folders = 3,
                                        .pictures = 100,
                                        .sounds = 400,
                                        .languages = 12,
                                        .text_bytes = 400,
                                        .sound_s = 60.0};

}  // namespace touchline
