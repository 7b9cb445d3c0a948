// Private to app/documents/decode: one name for what the two generations of libexiv2 name
// differently. Debian 12 has 0.27, Debian 13 has 0.28. Threads: those of the library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <exiv2/exiv2.hpp>

namespace touchline::decode {

#if EXIV2_TEST_VERSION(0, 28, 0)

using Exiv2Count = std::size_t;

inline std::int64_t whole_of(const Exiv2::Exifdatum& field) {
    return field.toInt64();
}

inline std::span<const Exiv2::byte> bytes_of(const Exiv2::DataBuf& buffer) {
    return {buffer.c_data(), buffer.size()};
}

inline std::span<const Exiv2::byte> profile_of(const Exiv2::Image& image) {
    return bytes_of(image.iccProfile());
}

#else

using Exiv2Count = long;

inline std::int64_t whole_of(const Exiv2::Exifdatum& field) {
    return field.toLong();
}

inline std::span<const Exiv2::byte> bytes_of(const Exiv2::DataBuf& buffer) {
    if (buffer.size_ <= 0) return {};
    return {buffer.pData_, static_cast<std::size_t>(buffer.size_)};
}

inline std::span<const Exiv2::byte> profile_of(Exiv2::Image& image) {
    const Exiv2::DataBuf* const profile = image.iccProfile();
    return profile == nullptr ? std::span<const Exiv2::byte>() : bytes_of(*profile);
}

#endif

}  // namespace touchline::decode
