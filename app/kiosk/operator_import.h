// What an operator takes from a stick into this kiosk: packs of pictures and networks.
// Threads: any, each call by itself; calls wait for the stick and for workers.
#pragma once

#include "app/isolation/process/memory.h"
#include "app/kiosk/outcome.h"
#include "app/kiosk/stick_source.h"
#include "audio-cues/words/language.h"
#include "config/types/result.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

namespace touchline {

/// Its bytes, or a sentence for the operator. Waits for the stick.
using StickFileReader = std::function<Result<Mapping, Outcome>()>;

[[nodiscard]] StickFileReader reader_of(const OperatorStick& stick, std::size_t file,
                                        const Language& language);

/// A file of the operator's stick.
struct Brought {
    StickFileReader read;
    StickFileKind kind;
    std::string name;  // for the screen
};

/// Takes it, a pack into `library`, and says what came of it.
[[nodiscard]] Outcome imported(const Brought& file, const std::filesystem::path& library,
                               const Language& language);

}  // namespace touchline
