// Any bytes give one finding, or a sound pack.toml that stays the same when written and read again.
#include "app/documents/packs/pack.h"
#include "app/documents/packs/plain_names.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace touchline;
    const auto info = pack_info_of({reinterpret_cast<const char*>(data), size});
    if (!info) {
        const bool is_ours = static_cast<int>(info.error().kind) < finding_kind_count &&
                             info.error().file == pack_table_name && info.error().line >= 0;
        if (!is_ours) abort();
        return 0;
    }
    if (info->title.empty() || info->languages.empty() || info->pictures.empty()) abort();
    for (const PackPicture& picture : info->pictures)
        if (trouble_with_name(picture.file)) abort();
    for (const PackSound& sound : info->sounds)
        if (trouble_with_name(sound.file) || !is_language_tag(sound.language)) abort();
    const auto back = pack_info_of(toml_of(*info));
    if (!back || !(*back == *info)) abort();
    return 0;
}
