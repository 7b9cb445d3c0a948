// The decoders without their worker: in the test's own process, where a debugger and the sanitizers
// see them.
#pragma once

#include "app/decode/decoding.h"

namespace touchline {

inline Result<Page> decode_page(std::span<const std::byte> bytes, const PageOrder& order = {}) {
    return kind_of(bytes) == WorkerKind::document ? decode_document(bytes, order)
                                                  : decode_raster(bytes, order);
}

inline Result<Picture> decode_picture(std::span<const std::byte> bytes) {
    return decode_page(bytes).map([](Page page) { return std::move(page.picture); });
}

}  // namespace touchline
