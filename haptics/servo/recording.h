// A recording of the black box as a file: untrusted bytes, all of them checked.
// Threads: values and pure functions.
#pragma once

#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "haptics/servo/recorder.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace touchline {

/// Which map a version was. Of a visitor's picture there is the hash and nothing else.
struct RecordedMap {
    std::uint64_t version = 0;  // > 0
    std::string gallery_file;   // name of a file of the gallery; empty: a visitor's picture
    std::int32_t detail = 0;
    std::uint64_t hash = 0;

    friend bool operator==(const RecordedMap&, const RecordedMap&) = default;
};

/// Of everything in a map that can be felt. O(n).
[[nodiscard]] std::uint64_t hash_of(const TactileMap& map);

struct Recording {
    std::string profile;  // name of the device's
    std::vector<RecordedMap> maps;
    std::vector<TickRecord> ticks;
    /// The servo step as it lies in memory before tick `start_tick`, for the build that wrote it;
    /// empty where the ticks cannot be run again: after it a visitor's picture was felt.
    std::vector<std::byte> start;
    std::size_t start_tick = 0;
    std::uint64_t start_version = 0;  // of the map felt then; 0: none
};

/// What a held recorder has. `maps`: all that were felt; one that is missing counts as a visitor's.
/// O(ticks).
[[nodiscard]] Recording make_recording(const Recorder& recorder, std::string profile,
                                       const std::vector<RecordedMap>& maps);

/// O(size).
[[nodiscard]] std::vector<std::byte> encode(const Recording& recording);

/// What a recording's last eight bytes are, of those before them: against damage, not malice.
[[nodiscard]] std::uint64_t checksum_of(std::span<const std::byte> bytes);

/// Any bytes may come in: a file that is cut, damaged, of another version or not a recording is one
/// clear line. Numbers may be anything, enumerations and sizes are checked. What cannot be checked
/// is the start: run only a recording again that comes from a machine of yours. O(size).
[[nodiscard]] Result<Recording> decode(std::span<const std::byte> bytes);

/// What came out of a tick, bit for bit.
[[nodiscard]] bool came_out_same(const TickRecord& a, const TickRecord& b);

}  // namespace touchline
