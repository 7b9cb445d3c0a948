// Adds metadata to a file with libexiv2. Threads: one at a time.
#pragma once

#include "app/documents/decode/exiv2_generations.h"
#include "tests/app/documents/decode/encoders.h"

#include <cstddef>

namespace touchline {

/// Calls `change` with the picture's Exiv2::Image.
template <class Change>
encoders::Bytes with_metadata(const encoders::Bytes& bytes, const Change& change) {
    auto image = Exiv2::ImageFactory::open(reinterpret_cast<const Exiv2::byte*>(bytes.data()),
                                           static_cast<decode::Exiv2Count>(bytes.size()));
    image->readMetadata();
    change(*image);
    image->writeMetadata();
    Exiv2::BasicIo& io = image->io();
    io.open();
    const Exiv2::DataBuf written = io.read(static_cast<decode::Exiv2Count>(io.size()));
    const auto all = std::as_bytes(decode::bytes_of(written));
    return {all.begin(), all.end()};
}

}  // namespace touchline
