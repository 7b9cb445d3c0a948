// A recording of the black box as a file, which is untrusted: every byte is checked. And the same
// ticks run again through the servo step. Threads: values and pure functions; run_again(): any one.
#pragma once

#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "haptics/servo/recorder.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace touchline {

/// Which map a version was. For a visitor's picture only the hash is kept.
struct RecordedMap {
    std::uint64_t version = 0;  // > 0
    std::string gallery_file;   // file name in the gallery; empty: a visitor's picture
    std::int32_t detail = 0;
    std::uint64_t hash = 0;

    friend bool operator==(const RecordedMap&, const RecordedMap&) = default;
};

/// Hashes everything in a map that can be felt. O(n).
[[nodiscard]] std::uint64_t hash_of(const TactileMap& map);

struct Recording {
    std::string profile;  // the device profile's name
    std::vector<RecordedMap> maps;
    std::vector<TickRecord> ticks;
    /// The servo step as it lay in memory before tick `start_tick`, for the build that wrote it.
    /// Empty if the ticks cannot be run again because a visitor's picture was felt after it.
    std::vector<std::byte> start;
    std::size_t start_tick = 0;
    std::uint64_t start_version = 0;  // map felt then; 0: none
};

/// Makes a recording from a held recorder. `maps` holds every map that was felt; a missing one
/// counts as a visitor's picture. O(ticks).
[[nodiscard]] Recording make_recording(const Recorder& recorder, std::string profile,
                                       const std::vector<RecordedMap>& maps);

/// O(size).
[[nodiscard]] std::vector<std::byte> bytes_of(const Recording& recording);

/// Computes the checksum that a recording's last eight bytes hold of all bytes before them. It
/// guards against damage, not malice.
[[nodiscard]] std::uint64_t checksum_of(std::span<const std::byte> bytes);

/// Reads any bytes. A file that is cut, damaged, of another version or not a recording gives a
/// one-line error. Numbers may be anything; enumerations and sizes are checked. The start cannot be
/// checked: run a recording again only if it comes from a machine of yours. O(size).
[[nodiscard]] Result<Recording> recording_of(std::span<const std::byte> bytes);

/// Returns whether the outputs of two ticks are equal, bit for bit.
[[nodiscard]] bool came_out_same(const TickRecord& a, const TickRecord& b);

struct Replay {
    std::size_t first = 0;                  // first tick of the recording that was run
    std::vector<TickRecord> ticks;          // with the outputs they have now
    std::optional<std::size_t> differs_at;  // first tick that is not the same, bit for bit
};

/// `scene_of` returns the scene of a version, built as it was then, or an error that says why it is
/// not available. Fails with one line if the recording holds no start, or if its start comes from
/// another build or does not fit its scene. O(ticks).
[[nodiscard]] Result<Replay> run_again(
    const Recording& recording,
    const std::function<Result<std::shared_ptr<const Scene>>(std::uint64_t version)>& scene_of);

}  // namespace touchline
