// A pack made from a curator's folder of pictures, texts and recordings (README.md shows one).
// Threads: any; a call waits for workers.
#pragma once

#include "app/documents/packs/pack.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <functional>
#include <string>
#include <vector>

namespace touchline {

/// The lines of a picture that is no SVG. Errors are one line that begins with the path.
using PictureTracer = std::function<Result<TactileMap>(const std::string& path)>;

struct MadePack {
    Pack pack;  // only if there are no faults; check_pack() tells what could be better
    /// What is wrong with the folder, each with the file, why, and what to do: every file that is
    /// not understood, each text and recording that has no picture, part or language.
    std::vector<std::string> faults;
};

/// Reads the files of the folder, not those in folders in it. The same folder gives the same pack,
/// bit for bit, wherever it lies. Does not change it.
[[nodiscard]] MadePack make_pack(const std::string& folder, const PictureTracer& trace);

}  // namespace touchline
