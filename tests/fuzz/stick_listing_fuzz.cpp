// Any bytes give a sound listing of a stick or one clear line.
#include "app/documents/sticks/listing.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace touchline;
    const std::span bytes(reinterpret_cast<const std::byte*>(data), size);
    const auto listing = listing_of(bytes);
    if (!listing) {
        if (listing.error().line.empty()) abort();
        return 0;
    }
    if (listing->entries.size() > most_listed) abort();
    for (const StickEntry& entry : listing->entries) {
        if (!is_file_name(entry.name)) abort();
        if (!is_folder_path(entry.folder)) abort();
        if (static_cast<int>(entry.kind) >= stick_file_kind_count) abort();
    }
    const auto back = bytes_of(*listing);
    if (!std::equal(back.begin(), back.end(), bytes.begin(), bytes.end())) abort();
    return 0;
}
