// Any bytes give a sound map or one clear line.
#include "config/types/map_bytes.h"
#include "tests/config/map_samples.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace touchline;
    const std::span bytes(reinterpret_cast<const std::byte*>(data), size);
    const auto map = map_of(bytes);
    if (!map) {
        if (map.error().line.empty() || map.error().line.find('\n') != std::string::npos) abort();
        return 0;
    }
    if (!is_sound(*map)) abort();
    const auto back = bytes_of(*map);
    if (!back || back->size() != size) abort();
    return 0;
}
