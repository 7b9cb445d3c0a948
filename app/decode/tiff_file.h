// Private to app/decode: a TIFF in memory, through libtiff, and its pixels as they are stored.
// Threads: one file, one thread.
#pragma once

#include "app/decode/formats.h"

#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <tiffio.h>

namespace touchline::decode {

/// A part of a row: `count` pixels from (x, y), which lie in the picture; the bytes of each plane
/// that was asked for, of all samples where they are not stored plane by plane.
struct Stretch {
    std::size_t x = 0;
    std::size_t y = 0;
    std::size_t count = 0;
    std::vector<Bytes> planes;
};

class TiffFile {
  public:
    /// At its first picture that is no small copy of one, nor a mask. Fails with one line.
    static Result<TiffFile> open(Bytes bytes);

    /// libtiff's, for its functions.
    [[nodiscard]] TIFF* get() const { return tiff_.get(); }

    /// A number of the directory, or its default; 0 where it has none.
    [[nodiscard]] std::uint32_t number(std::uint32_t tag) const;

    /// "the TIFF picture is cut short or damaged (...)", in libtiff's words.
    [[nodiscard]] tl::unexpected<Error> broken() const;

    /// The same picture, from its beginning again.
    [[nodiscard]] Result<TiffFile> again() const;

    [[nodiscard]] bool is_planar() const {
        return number(TIFFTAG_PLANARCONFIG) == PLANARCONFIG_SEPARATE;
    }

    /// All stretches, each once; `planes` matters only where is_planar(). Call it once.
    [[nodiscard]] Result<void> read(const std::vector<std::uint16_t>& planes,
                                    const std::function<void(const Stretch&)>& take) const;

  private:
    struct Source {
        Bytes bytes;
        std::size_t offset = 0;
        std::string error;  // the first
    };

    struct Close {
        void operator()(TIFF* tiff) const { TIFFClose(tiff); }
    };

    static tmsize_t read_some(thandle_t handle, void* to, tmsize_t wanted);
    static toff_t seek(thandle_t handle, toff_t offset, int from);
    static int keep_first_error(TIFF* tiff, void* user, const char* module, const char* format,
                                std::va_list arguments);
    static Result<TiffFile> opened(Bytes bytes);
    [[nodiscard]] Result<void> read_rows(const std::vector<std::uint16_t>& planes,
                                         const std::function<void(const Stretch&)>& take) const;
    [[nodiscard]] Result<void> read_tiles(const std::vector<std::uint16_t>& planes,
                                          const std::function<void(const Stretch&)>& take) const;

    std::unique_ptr<Source> source_;
    std::unique_ptr<TIFF, Close> tiff_;
};

}  // namespace touchline::decode
