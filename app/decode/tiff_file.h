// Private to app/decode: a TIFF in memory, read by libtiff, and its pixels as they are stored.
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

/// A part of a row: `count` pixels from (x, y), all within the picture. Holds the bytes of each
/// plane that was asked for, or of all samples if they are not stored plane by plane.
struct Stretch {
    std::size_t x = 0;
    std::size_t y = 0;
    std::size_t count = 0;
    std::vector<Bytes> planes;
};

class TiffFile {
  public:
    /// Opens the file at its first picture that is neither a small copy of another nor a mask.
    /// Fails with one line.
    static Result<TiffFile> open(Bytes bytes);

    /// The handle for libtiff's functions.
    [[nodiscard]] TIFF* get() const { return tiff_.get(); }

    /// A number of the directory, or its default; 0 if it has none.
    [[nodiscard]] std::uint32_t number(std::uint32_t tag) const;

    /// "the TIFF picture is cut short or damaged (...)", in libtiff's words.
    [[nodiscard]] tl::unexpected<Error> broken() const;

    /// Opens the same picture again, from its beginning.
    [[nodiscard]] Result<TiffFile> again() const;

    [[nodiscard]] bool is_planar() const {
        return number(TIFFTAG_PLANARCONFIG) == PLANARCONFIG_SEPARATE;
    }

    /// Gives all stretches, each once. `planes` matters only if is_planar(). Call it once.
    [[nodiscard]] Result<void> read(const std::vector<std::uint16_t>& planes,
                                    const std::function<void(const Stretch&)>& take) const;

  private:
    struct Source {
        Bytes bytes;
        std::size_t offset = 0;
        std::string error;  // the first error
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
