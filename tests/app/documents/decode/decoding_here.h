// The decoders without their worker: they run in the test's own process, where a debugger and the
// sanitizers see them.
#pragma once

#include "app/documents/decode/worker_program.h"

#include <gtest/gtest.h>

namespace touchline {

inline Result<Page> decode_page(std::span<const std::byte> bytes, const PageOrder& order = {}) {
    switch (kind_of(bytes)) {
        case WorkerKind::document:
            return decode_document(bytes, order);
        case WorkerKind::heif:
            return decode_heif(bytes, order);
        default:
            return decode_raster(bytes, order);
    }
}

inline Result<Picture> decode_picture(std::span<const std::byte> bytes) {
    return decode_page(bytes).map([](Page page) { return std::move(page.picture); });
}

/// Decodes bytes that must be a picture.
inline Picture decoded(std::span<const std::byte> bytes) {
    auto picture = decode_picture(bytes);
    EXPECT_TRUE(picture.has_value()) << picture.error().line;
    return picture.value_or(Picture{});
}

}  // namespace touchline
