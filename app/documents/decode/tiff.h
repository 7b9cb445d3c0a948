// Private to app/documents/decode: a TIFF in memory, read by libtiff; the numbers in it, of any
// depth and kind, and which of them are bright; and what they mean as colours. Threads: one object,
// one thread.
#pragma once

#include "app/documents/decode/readers.h"
#include "app/isolation/process/descriptor.h"

#include <array>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <lcms2.h>
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

using TakeStretch = std::function<void(const Stretch&)>;

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
                                    const TakeStretch& take) const;

  private:
    struct Source {
        Bytes bytes;
        std::size_t offset = 0;
        std::string error;  // the first error
    };

    static tmsize_t read_some(thandle_t handle, void* to, tmsize_t wanted);
    static toff_t seek(thandle_t handle, toff_t offset, int from);
    static int keep_first_error(TIFF* tiff, void* user, const char* module, const char* format,
                                std::va_list arguments);
    static Result<TiffFile> opened(Bytes bytes);
    [[nodiscard]] Result<void> read_rows(const std::vector<std::uint16_t>& planes,
                                         const TakeStretch& take) const;
    [[nodiscard]] Result<void> read_tiles(const std::vector<std::uint16_t>& planes,
                                          const TakeStretch& take) const;

    std::unique_ptr<Source> source_;
    Owned<TIFF, TIFFClose> tiff_;
};

enum class NumberKind : std::uint8_t { whole, signed_whole, floating };

struct SampleForm {
    NumberKind kind = NumberKind::whole;
    unsigned bits = 8;
};

/// True for whole numbers of 1 to 32 and of 64 bits, and floating ones of 16, 24, 32 and 64.
[[nodiscard]] bool is_known(const SampleForm& form);

/// Unpacks as many numbers as there are places and bytes; missing ones become 0. Those of 16, 24,
/// 32 and 64 bits are in the machine's order; others are packed without gaps, the highest bit
/// first.
void unpack(Bytes stored, const SampleForm& form, std::span<float> numbers);

/// The numbers that become black and white.
struct Range {
    float low = 0.0F;
    float high = 1.0F;
};

/// All values of the kind; for floating ones 0 to 1.
[[nodiscard]] Range own_range(const SampleForm& form);

/// The range of the numbers seen. Ignores what stands for no number: NaN, infinite, beyond 10^30.
class Seen {
  public:
    void add(float number);

    /// The own range of the form, unless the numbers seen lie beyond it, or in so small a part of
    /// it that nobody would see it. Measurements are stored so, and 12 bits in 16.
    [[nodiscard]] Range range(const SampleForm& form) const;

  private:
    float least_ = 0.0F;
    float most_ = 0.0F;
    bool has_any_ = false;
};

/// 0 ... 255; NaN: 0.
[[nodiscard]] std::uint8_t level(float number, const Range& range);

/// How a colour is stored: each way has its own number of samples.
enum class TiffColours : std::uint8_t { grey, white_is_zero, palette, rgb, inks, lab };

/// How pixels are stored, unless libtiff reads them itself (tiff_reader.cpp).
struct TiffForm {
    SampleForm samples;
    std::uint16_t count = 1;  // samples per pixel
    bool is_planar = false;   // each sample has a plane of its own
    TiffColours colours = TiffColours::grey;
    std::uint16_t colour_count = 1;                    // samples of colour: the first ones
    std::optional<std::uint16_t> alpha;                // which of the others is alpha
    bool is_multiplied = false;                        // the colours are multiplied by alpha
    std::uint32_t lab_kind = 0;                        // TIFF's number for the kind of Lab
    std::vector<std::array<std::uint8_t, 3>> palette;  // blue, green, red
};

/// Fails with one line for pixels that cannot be shown.
[[nodiscard]] Result<TiffForm> form_of(const TiffFile& file);

/// Turns samples into blue, green, red and, if there is one, straight alpha.
class TiffPixels {
  public:
    /// `range`: the colours' range.
    TiffPixels(const TiffForm& form, const Range& range);

    [[nodiscard]] std::size_t channels() const { return form_.alpha ? 4 : 3; }

    /// The samples that are used, as planes.
    [[nodiscard]] std::vector<std::uint16_t> planes() const;

    /// Valid until the next call.
    [[nodiscard]] std::span<const std::uint8_t> pixels_of(const Stretch& stretch);

    /// Shows every sample of a colour to `seen`.
    void look(const Stretch& stretch, Seen& seen);

  private:
    struct Channel {
        const float* first = nullptr;
        std::size_t step = 1;
    };

    /// The numbers of the samples that are used.
    [[nodiscard]] std::vector<Channel> unpacked(const Stretch& stretch);
    void write_colours(std::span<const Channel> channels, std::size_t count);
    void write_inks(std::span<const Channel> channels, std::size_t count);
    void write_lab(std::span<const Channel> channels, std::size_t count);

    TiffForm form_;
    Range range_;
    std::vector<float> numbers_;
    std::vector<std::uint8_t> lab_;
    std::vector<std::uint8_t> pixels_;
    Owned<void, cmsDeleteTransform> from_lab_;
};

}  // namespace touchline::decode
