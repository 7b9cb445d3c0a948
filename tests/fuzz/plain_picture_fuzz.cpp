// Fuzzes our own readers of BMP and PNM: any bytes give a picture or one clear line.
#include "app/documents/decode/readers.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace touchline;
    const std::span bytes(reinterpret_cast<const std::byte*>(data), size);
    if (bytes.size() < 3 || bytes.size() > 65536) return 0;
    const bool is_bmp = format_of(bytes) == FileFormat::bmp;
    const bool is_pnm = format_of(bytes) == FileFormat::pnm;
    if (!is_bmp && !is_pnm) return 0;
    // A few bytes may honestly make a large picture; here it would only be slow.
    const auto stored = is_bmp ? decode::read_bmp(bytes) : decode::read_pnm(bytes);
    if (!stored) {
        if (stored.error().line.empty() || stored.error().line.find('\n') != std::string::npos)
            abort();
        return 0;
    }
    const Picture& picture = stored->picture;
    if (picture.bgr.size() !=
        3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height))
        abort();
    return 0;
}
