// Any answer of touchline-unpack is a sound one or none; behind a checksum that is made right.
#include "app/packs/plain_names.h"
#include "app/packs/unpack_answer.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <vector>

#include <zlib.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace touchline;
    std::vector<std::uint8_t> bytes(data, data + size);
    if (size >= unpack_header_bytes) {
        const auto sum = static_cast<std::uint32_t>(crc32(0, bytes.data(), unpack_checksum_at));
        std::memcpy(&bytes[unpack_checksum_at], &sum, sizeof sum);
        const std::uint64_t whole = size;
        std::memcpy(&bytes[12], &whole, sizeof whole);
        const auto again = static_cast<std::uint32_t>(crc32(0, bytes.data(), unpack_checksum_at));
        std::memcpy(&bytes[unpack_checksum_at], &again, sizeof again);
    }
    const auto answer = unpack_answer_of(std::as_bytes(std::span(bytes)));
    if (!answer) return 0;
    for (const PackFile& entry : answer->entries)
        if (trouble_with_name(entry.name)) abort();
    const auto back = bytes_of(*answer);
    if (back.size() != bytes.size() || std::memcmp(back.data(), bytes.data(), back.size()) != 0)
        abort();
    return 0;
}
