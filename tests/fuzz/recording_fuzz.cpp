// Any bytes with a right checksum give a recording or one clear line.
#include "haptics/servo/recording.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace touchline;
    const auto given = std::as_bytes(std::span(data, size));
    std::vector<std::byte> bytes(given.begin(), given.end());
    const std::uint64_t checksum = checksum_of(bytes);
    const auto end = std::as_bytes(std::span(&checksum, 1));
    bytes.insert(bytes.end(), end.begin(), end.end());
    const auto recording = recording_of(bytes);
    if (!recording) {
        const std::string& line = recording.error().line;
        if (line.empty() || line.find('\n') != std::string::npos) abort();
        return 0;
    }
    if (recording->start_tick > recording->ticks.size()) abort();
    if (bytes_of(*recording).size() != bytes.size()) abort();
    return 0;
}
