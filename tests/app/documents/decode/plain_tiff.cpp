#include "tests/app/documents/decode/plain_tiff.h"

#include <algorithm>

namespace touchline::encoders {
namespace {

class Writer {
  public:
    explicit Writer(bool is_big_endian) : is_big_endian_(is_big_endian) {}

    void number(std::uint64_t value, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t shift = 8 * (is_big_endian_ ? count - 1 - i : i);
            bytes.push_back(static_cast<std::byte>(value >> shift & 0xffU));
        }
    }

    Bytes bytes;

  private:
    bool is_big_endian_;
};

/// Writes whole-byte samples in the file's byte order; packs others highest bit first.
class SampleWriter {
  public:
    SampleWriter(Writer& to, unsigned bits) : to_(to), bits_(bits) {}

    void add(std::uint64_t sample) {
        if (bits_ == 8 || bits_ == 16 || bits_ == 24 || bits_ == 32 || bits_ == 64) {
            to_.number(sample, bits_ / 8);
            return;
        }
        for (unsigned bit = bits_; bit-- > 0;) {
            held_ = held_ << 1U | (sample >> bit & 1U);
            if (++count_ % 8 == 0) to_.bytes.push_back(static_cast<std::byte>(held_ & 0xffU));
        }
    }

    void end_row() {
        for (; count_ % 8 != 0; ++count_) {
            held_ <<= 1U;
            if (count_ % 8 == 7) to_.bytes.push_back(static_cast<std::byte>(held_ & 0xffU));
        }
        count_ = 0;
    }

  private:
    Writer& to_;
    unsigned bits_;
    std::uint64_t held_ = 0;
    unsigned count_ = 0;
};

struct Piece {
    std::uint32_t left, top, width, height, first, last;  // samples first to last - 1
};

/// Returns strips or tiles; all pieces of a sample come before those of the next.
std::vector<Piece> pieces_of(const PlainTiff& form) {
    const std::uint32_t strip = form.strip_rows != 0 ? form.strip_rows : form.height;
    const std::uint32_t across = form.tile != 0 ? form.tile : form.width;
    const std::uint32_t down = form.tile != 0 ? form.tile : strip;
    std::vector<Piece> pieces;
    for (std::uint32_t plane = 0; plane < (form.is_planar ? form.samples : 1U); ++plane)
        for (std::uint32_t top = 0; top < form.height; top += down)
            for (std::uint32_t left = 0; left < form.width; left += across) {
                const std::uint32_t rows =
                    form.tile != 0 ? down : std::min(down, form.height - top);
                pieces.push_back({left, top, across, rows, form.is_planar ? plane : 0U,
                                  form.is_planar ? plane + 1U : form.samples});
            }
    return pieces;
}

void write_piece(const PlainTiff& form, const std::vector<std::uint64_t>& stored,
                 const Piece& piece, Writer& to) {
    SampleWriter samples(to, form.bits);
    for (std::uint32_t y = piece.top; y < piece.top + piece.height; ++y) {
        for (std::uint32_t x = piece.left; x < piece.left + piece.width; ++x) {
            const bool is_inside = x < form.width && y < form.height;
            for (std::uint32_t sample = piece.first; sample < piece.last; ++sample)
                samples.add(
                    is_inside ? stored.at((std::size_t{y} * form.width + x) * form.samples + sample)
                              : 0U);
        }
        samples.end_row();
    }
}

struct Entry {
    unsigned tag, type;  // type 3: 16 bits, 4: 32 bits, 5: a fraction
    std::vector<std::uint32_t> values;
};

std::vector<Entry> entries_of(const PlainTiff& form, const std::vector<std::uint32_t>& places,
                              const std::vector<std::uint32_t>& sizes) {
    const bool is_tiled = form.tile != 0;
    std::vector<Entry> entries{
        {256, 4, {form.width}},
        {257, 4, {form.height}},
        {258, 3, std::vector<std::uint32_t>(form.samples, form.bits)},
        {259, 3, {1}},
        {262, 3, {form.photometric}},
        {274, 3, {form.orientation}},
        {277, 3, {form.samples}},
        {284, 3, {form.is_planar ? 2U : 1U}},
        {339, 3, std::vector<std::uint32_t>(form.samples, form.sample_format)},
        {is_tiled ? 324U : 273U, 4, places},
        {is_tiled ? 325U : 279U, 4, sizes},
    };
    if (is_tiled) {
        entries.push_back({322, 4, {form.tile}});
        entries.push_back({323, 4, {form.tile}});
    } else {
        entries.push_back({278, 4, {form.strip_rows != 0 ? form.strip_rows : form.height}});
    }
    if (form.extra_sample >= 0)
        entries.push_back({338, 3, {static_cast<std::uint32_t>(form.extra_sample)}});
    if (form.photometric == 6) entries.push_back({530, 3, {1, 1}});  // colour at every pixel
    if (!form.palette.empty())
        entries.push_back({320, 3, {form.palette.begin(), form.palette.end()}});
    if (form.x_resolution != 0) {
        entries.push_back({282, 5, {form.x_resolution, 1}});
        entries.push_back({283, 5, {form.y_resolution, 1}});
    }
    std::ranges::sort(entries, {}, &Entry::tag);
    return entries;
}

}  // namespace

Bytes plain_tiff(const PlainTiff& form, const std::vector<std::uint64_t>& stored) {
    Writer to(form.is_big_endian);
    to.bytes = bytes_of(form.is_big_endian ? "MM" : "II");
    to.number(42, 2);
    to.number(0, 4);  // the directory's offset, filled in at the end
    std::vector<std::uint32_t> places;
    std::vector<std::uint32_t> sizes;
    for (const Piece& piece : pieces_of(form)) {
        places.push_back(static_cast<std::uint32_t>(to.bytes.size()));
        write_piece(form, stored, piece, to);
        sizes.push_back(static_cast<std::uint32_t>(to.bytes.size()) - places.back());
    }
    const std::vector<Entry> entries = entries_of(form, places, sizes);
    std::vector<std::uint32_t> far;  // offsets of values that do not fit in their entry
    for (const Entry& entry : entries) {
        if (to.bytes.size() % 2 != 0) to.bytes.push_back(std::byte{0});
        far.push_back(static_cast<std::uint32_t>(to.bytes.size()));
        if (entry.values.size() * (entry.type == 3 ? 2U : 4U) > 4)
            for (const std::uint32_t value : entry.values)
                to.number(value, entry.type == 3 ? 2 : 4);
    }
    if (to.bytes.size() % 2 != 0) to.bytes.push_back(std::byte{0});
    const std::size_t directory = to.bytes.size();
    to.number(entries.size(), 2);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Entry& entry = entries[i];
        to.number(entry.tag, 2);
        to.number(entry.type, 2);
        to.number(entry.type == 5 ? entry.values.size() / 2 : entry.values.size(), 4);
        const std::size_t value_bytes = entry.type == 3 ? 2 : 4;
        if (entry.values.size() * value_bytes > 4) {
            to.number(far[i], 4);
            continue;
        }
        for (const std::uint32_t value : entry.values) to.number(value, value_bytes);
        to.bytes.resize(to.bytes.size() + 4 - entry.values.size() * value_bytes);
    }
    to.number(0, 4);
    Writer place(form.is_big_endian);
    place.number(directory, 4);
    std::ranges::copy(place.bytes, to.bytes.begin() + 4);
    return to.bytes;
}

}  // namespace touchline::encoders
