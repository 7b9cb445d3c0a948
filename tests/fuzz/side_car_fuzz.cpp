// Any text beside a picture gives lines without control characters, of bounded length; any file has
// a kind.
#include "app/documents/decode/file_format.h"
#include "app/documents/decode/opening.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace touchline;
    TactileMap told;
    tell({reinterpret_cast<const char*>(data), size}, told);
    for (const std::string* text : {&told.title, &told.description}) {
        const bool is_clean = std::none_of(text->begin(), text->end(), [](char c) {
            return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
        });
        if (!is_clean || text->size() > 4003) abort();
    }
    (void)kind_of(std::span(reinterpret_cast<const std::byte*>(data), size));
    return 0;
}
