// Any directory at the end of a zip file gives plain names within the limits, or a finding.
#include "app/documents/packs/pack.h"
#include "app/documents/packs/plain_names.h"
#include "app/documents/packs/unpack_work.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace touchline;
    const auto members = zip_members({reinterpret_cast<const std::byte*>(data), size});
    if (!members) return 0;
    std::size_t all = 0;
    for (const ZipMember& member : *members) {
        if (trouble_with_name(member.name) || member.bytes > pack_limits.file_bytes) abort();
        all += member.bytes;
    }
    if (all > pack_limits.all_bytes || members->size() > pack_limits.files) abort();
    return 0;
}
