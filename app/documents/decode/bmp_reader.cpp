// Reads BMP by hand: no library of Debian reads it from memory without bringing along sound,
// windows or a hundred formats. It is fuzzed (tests/fuzz/plain_picture_fuzz.cpp), and only ever
// runs inside the sandbox. OS/2 has arrays of bitmaps, each for another screen, and icons and
// pointers: a bitmap of colours behind one of masks, or masks alone.
#include "app/documents/decode/bmp_header.h"
#include "app/documents/decode/one_line.h"
#include "app/documents/decode/readers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <string_view>
#include <utility>

namespace touchline::decode {
namespace {

/// Unpacks runs of equal pixels, and stretches of different ones, into rows in the file's order.
/// Each pixel is an index or, if the packing is runs_of_24, blue, green and red; it is 0 if nothing
/// is written to it. O(pixels + bytes).
class RunReader {
  public:
    RunReader(Bytes packed, const BmpHeader& header)
        : packed_(packed),
          width_(static_cast<std::size_t>(header.width)),
          height_(static_cast<std::size_t>(header.height)),
          is_4_bit_(header.packing == BmpPacking::runs_of_4),
          pixel_bytes_(header.packing == BmpPacking::runs_of_24 ? 3 : 1),
          pixels_(pixel_bytes_ * width_ * height_) {}

    /// False if the file ends before the picture does.
    bool read() {
        while (at_ + 2 <= packed_.size()) {
            if (const unsigned count = take(); count > 0) {
                take_run(count);
                continue;
            }
            const unsigned order = take();
            if (order == 0) {
                x_ = 0;
                ++y_;
            } else if (order == 1) {
                return true;
            } else if (order == 2) {
                x_ += take();
                y_ += take();
            } else {
                take_stretch(order);
            }
            if (y_ > height_) return true;
        }
        return y_ >= height_;
    }

    [[nodiscard]] std::vector<std::uint8_t> pixels() && { return std::move(pixels_); }

  private:
    using Pixel = std::array<std::uint8_t, 3>;

    std::uint8_t take() {
        return at_ < packed_.size() ? std::to_integer<std::uint8_t>(packed_[at_++])
                                    : std::uint8_t{0};
    }

    Pixel take_pixel() {
        Pixel pixel{};
        for (std::size_t i = 0; i < pixel_bytes_; ++i) pixel[i] = take();
        return pixel;
    }

    /// Two indices may share a byte, the upper half first.
    [[nodiscard]] Pixel part_of(const Pixel& taken, unsigned i) const {
        if (!is_4_bit_) return taken;
        return {static_cast<std::uint8_t>(i % 2 == 0 ? taken[0] >> 4U : taken[0] & 15U)};
    }

    void take_run(unsigned count) {
        const Pixel taken = take_pixel();
        for (unsigned i = 0; i < count; ++i) put(part_of(taken, i));
    }

    void take_stretch(unsigned count) {
        const std::size_t first = at_;
        Pixel taken{};
        for (unsigned i = 0; i < count; ++i) {
            if (!is_4_bit_ || i % 2 == 0) taken = take_pixel();
            put(part_of(taken, i));
        }
        if ((at_ - first) % 2 == 1) (void)take();  // to an even number
    }

    void put(const Pixel& pixel) {
        if (x_ < width_ && y_ < height_)
            std::copy_n(
                pixel.begin(), pixel_bytes_,
                pixels_.begin() + static_cast<std::ptrdiff_t>(pixel_bytes_ * (y_ * width_ + x_)));
        if (x_ < width_) ++x_;
    }

    Bytes packed_;
    std::size_t width_;
    std::size_t height_;
    bool is_4_bit_;
    std::size_t pixel_bytes_;
    std::vector<std::uint8_t> pixels_;
    std::size_t at_ = 0;
    std::size_t x_ = 0;
    std::size_t y_ = 0;
};

/// A field of a packed pixel, scaled to 0 ... 255.
std::uint8_t part_of(std::uint32_t pixel, std::uint32_t field) {
    if (field == 0) return 0;
    const int shift = std::countr_zero(field);
    const std::uint64_t most = field >> static_cast<unsigned>(shift);
    const std::uint64_t value = (pixel & field) >> static_cast<unsigned>(shift);
    return static_cast<std::uint8_t>((value * 255 + most / 2) / most);
}

/// The stored pixels of one bitmap; gives any of their rows.
class Bitmap {
  public:
    Bitmap(const Bitmap&) = delete;  // it holds a view of its own pixels
    Bitmap(Bitmap&&) = default;
    Bitmap& operator=(const Bitmap&) = delete;
    Bitmap& operator=(Bitmap&&) = default;
    ~Bitmap() = default;

    static Result<Bitmap> of(Bytes bytes, const BmpHeader& header) {
        if (header.pixels_at > bytes.size()) return damaged("BMP", "it ends before its pixels");
        Bitmap bitmap(header, bytes.subspan(header.pixels_at));
        const bool has_runs =
            header.packing != BmpPacking::none && header.packing != BmpPacking::fields;
        if (has_runs) {
            RunReader runs(bitmap.stored_, header);
            if (!runs.read()) return cut_short("BMP");
            bitmap.unpacked_ = std::move(runs).pixels();
            bitmap.stored_ = std::as_bytes(std::span(bitmap.unpacked_));
            bitmap.bits_ = header.packing == BmpPacking::runs_of_24 ? 24 : 8;
            bitmap.stride_ = bitmap.width() * bitmap.bits_ / 8;
        }
        if (bitmap.stored_.size() < bitmap.stride_ * bitmap.height()) return cut_short("BMP");
        return bitmap;
    }

    [[nodiscard]] std::size_t width() const { return static_cast<std::size_t>(header_.width); }

    [[nodiscard]] std::size_t height() const { return static_cast<std::size_t>(header_.height); }

    /// A stored number, which is an index if there are at most 8 bits. `y` counts from the top.
    [[nodiscard]] std::uint32_t number(std::size_t x, std::size_t y) const {
        const std::size_t row = header_.is_top_down ? y : height() - 1 - y;
        const Bytes stored = stored_.subspan(row * stride_, stride_);
        if (bits_ > 8) return little_endian(stored, x * bits_ / 8, bits_ / 8);
        const auto byte = std::to_integer<std::uint32_t>(stored[x * bits_ / 8]);
        return byte >> (8 - bits_ - x * bits_ % 8) & ((1U << bits_) - 1U);
    }

    /// Blue, green, red and alpha; alpha is 0 if there is none.
    [[nodiscard]] std::array<std::uint8_t, 4> pixel(std::size_t x, std::size_t y) const {
        const std::uint32_t stored = number(x, y);
        if (bits_ <= 8) {
            const auto& colour = header_.palette[stored];
            return {colour[0], colour[1], colour[2], 0};
        }
        std::array<std::uint8_t, 4> parts{};
        for (std::size_t part = 0; part < 4; ++part)
            parts[part] = part_of(stored, header_.fields[part]);
        return parts;
    }

    /// Checks the values too: some programs have a field for alpha and leave it empty.
    [[nodiscard]] bool has_alpha() const {
        if (bits_ <= 8 || header_.fields[3] == 0) return false;
        for (std::size_t y = 0; y < height(); ++y)
            for (std::size_t x = 0; x < width(); ++x)
                if ((number(x, y) & header_.fields[3]) != 0) return true;
        return false;
    }

  private:
    Bitmap(const BmpHeader& header, Bytes stored)
        : header_(header),
          stored_(stored),
          bits_(static_cast<std::size_t>(header.bits)),
          stride_((width() * bits_ + 31) / 32 * 4) {}

    BmpHeader header_;
    Bytes stored_;
    std::size_t bits_;
    std::size_t stride_;
    std::vector<std::uint8_t> unpacked_;
};

Picture picture_of(const Bitmap& bitmap) {
    const std::size_t channels = bitmap.has_alpha() ? 4 : 3;
    Shrinking shrinking(bitmap.width(), bitmap.height(), channels);
    std::vector<std::uint8_t> row(channels * bitmap.width());
    for (std::size_t y = 0; y < bitmap.height(); ++y) {
        for (std::size_t x = 0; x < bitmap.width(); ++x)
            std::copy_n(bitmap.pixel(x, y).begin(), channels, &row[channels * x]);
        shrinking.add_row(y, row);
    }
    return std::move(shrinking).picture();
}

/// An icon or a pointer. The upper half of the masks tells where nothing is drawn; the lower half
/// inverts black, or the colour.
Picture picture_of(const Bitmap& masks, const Bitmap* colours) {
    const std::size_t width = masks.width();
    const std::size_t height = masks.height() / 2;
    Shrinking shrinking(width, height, 4);
    std::vector<std::uint8_t> row(4 * width);
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            std::array<std::uint8_t, 4> pixel{};
            if (colours != nullptr) pixel = colours->pixel(x, y);
            if (masks.number(x, height + y) != 0)
                for (std::uint8_t& part : pixel) part = static_cast<std::uint8_t>(255 - part);
            pixel[3] = masks.number(x, y) != 0 ? 0 : 255;
            std::ranges::copy(pixel, row.begin() + static_cast<std::ptrdiff_t>(4 * x));
        }
        shrinking.add_row(y, row);
    }
    return std::move(shrinking).picture();
}

struct Entry {
    BmpHeader header;                // that of a bitmap, or of masks
    bool is_masked = false;          // an icon or a pointer
    std::optional<BmpHeader> other;  // that of its colours
};

/// True if a file header of this kind begins there.
bool begins(Bytes bytes, std::size_t at, std::string_view letters) {
    return at + 2 <= bytes.size() && as_text(bytes).substr(at, 2) == letters;
}

Result<Entry> entry_at(Bytes bytes, std::size_t at) {
    auto first = read_bmp_header(bytes, at);
    if (!first) return tl::unexpected(first.error());
    if (begins(bytes, at, "BM")) return Entry{std::move(*first), false, std::nullopt};
    const bool is_coloured = begins(bytes, at, "CI") || begins(bytes, at, "CP");
    std::optional<BmpHeader> other;
    if (is_coloured) {
        auto second = read_bmp_header(bytes, first->end);
        if (!second) return tl::unexpected(second.error());
        other = std::move(*second);
        const bool are_swapped = other->bits == 1 && other->height == 2 * first->height;
        if (are_swapped) std::swap(*first, *other);
    }
    const bool is_whole =
        first->bits == 1 && first->height % 2 == 0 &&
        (!other || (other->width == first->width && 2 * other->height == first->height));
    if (!is_whole) return damaged("BMP", "its masks do not fit");
    return Entry{std::move(*first), true, std::move(other)};
}

/// The pixels, then the possible colours: the larger, the better.
std::pair<std::uint64_t, int> size_of(const Entry& entry) {
    const BmpHeader& shown = entry.other ? *entry.other : entry.header;
    return {std::uint64_t{1} * static_cast<unsigned>(shown.width) *
                static_cast<unsigned>(entry.is_masked && !entry.other ? shown.height / 2
                                                                      : shown.height),
            shown.bits};
}

/// The largest entry of an array; the first error if there is none.
Result<Entry> largest_of(Bytes bytes) {
    constexpr int most_entries = 100;
    Result<Entry> best = damaged("BMP", "it has no pixels");
    bool is_first = true;
    std::size_t at = 0;
    for (int i = 0; i < most_entries && begins(bytes, at, "BA"); ++i) {
        auto entry = entry_at(bytes, at + file_header_bytes);
        if (is_first || (entry && (!best || size_of(*entry) > size_of(*best))))
            best = std::move(entry);
        is_first = false;
        const std::size_t next = little_endian(bytes, at + 6, 4);
        if (next <= at) break;
        at = next;
    }
    return best;
}

}  // namespace

Result<Stored> read_bmp(Bytes bytes) {
    const auto entry = begins(bytes, 0, "BA") ? largest_of(bytes) : entry_at(bytes, 0);
    if (!entry) return tl::unexpected(entry.error());
    const auto first = Bitmap::of(bytes, entry->header);
    if (!first) return tl::unexpected(first.error());
    const Resolution& resolution = entry->header.resolution;
    if (!entry->is_masked) return Stored{picture_of(*first), resolution};
    if (!entry->other) return Stored{picture_of(*first, nullptr), resolution};
    const auto colours = Bitmap::of(bytes, *entry->other);
    if (!colours) return tl::unexpected(colours.error());
    return Stored{picture_of(*first, &*colours), resolution};
}

}  // namespace touchline::decode
