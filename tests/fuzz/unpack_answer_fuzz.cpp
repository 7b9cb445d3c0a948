// Any answer of touchline-unpack gives a sound answer or none.
#include "app/documents/packs/plain_names.h"
#include "app/documents/packs/unpack_work.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace touchline;
    const auto bytes = std::as_bytes(std::span(data, size));
    const auto answer = unpack_answer_of(bytes);
    if (!answer) return 0;
    for (const PackFile& entry : answer->entries)
        if (trouble_with_name(entry.name)) abort();
    const auto back = bytes_of(*answer);
    if (!std::ranges::equal(back, bytes)) abort();
    return 0;
}
