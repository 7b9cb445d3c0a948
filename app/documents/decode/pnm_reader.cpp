// The six plain formats of Netpbm, read by hand because its own library ends the program at the
// first error. Fuzzed (tests/fuzz/plain_picture_fuzz.cpp).
#include "app/documents/decode/readers.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace touchline::decode {
namespace {

struct Form {
    bool is_text = false;  // P1, P2, P3: numbers as digits
    bool is_bits = false;  // P1, P4: 1 is black
    std::size_t channels = 1;
    std::uint32_t most = 1;  // the largest sample
};

class Scanner {
  public:
    explicit Scanner(Bytes bytes) : bytes_(bytes) {}

    /// Takes a number behind white space and comments; nothing if there is none.
    std::optional<std::uint32_t> number() {
        skip_space();
        std::uint32_t value = 0;
        const std::size_t first = at_;
        while (is_digit() && value < 100'000'000) value = 10 * value + digit();
        if (at_ == first || is_digit()) return std::nullopt;
        return value;
    }

    /// Takes 0 or 1; these need no space between them.
    std::optional<std::uint32_t> bit() {
        skip_space();
        if (!is_digit()) return std::nullopt;
        const std::uint32_t value = digit();
        return value <= 1 ? std::optional(value) : std::nullopt;
    }

    /// The bytes after the one character that ends the header.
    [[nodiscard]] Bytes rest() const { return bytes_.subspan(std::min(at_ + 1, bytes_.size())); }

  private:
    [[nodiscard]] char peek() const {
        return at_ < bytes_.size() ? static_cast<char>(bytes_[at_]) : '\0';
    }

    [[nodiscard]] bool is_digit() const { return peek() >= '0' && peek() <= '9'; }

    std::uint32_t digit() { return static_cast<std::uint32_t>(bytes_[at_++]) - '0'; }

    void skip_space() {
        constexpr std::string_view space = " \t\r\n\v\f";
        for (;;) {
            if (peek() == '#') {
                while (at_ < bytes_.size() && peek() != '\n') ++at_;
            } else if (at_ < bytes_.size() && space.find(peek()) != std::string_view::npos) {
                ++at_;
            } else {
                return;
            }
        }
    }

    Bytes bytes_;
    std::size_t at_ = 2;  // behind the magic
};

Form form_of(char digit) {
    Form form;
    form.is_text = digit <= '3';
    form.is_bits = digit == '1' || digit == '4';
    form.channels = digit == '3' || digit == '6' ? 3 : 1;
    return form;
}

/// Samples as 0 ... 255, in a row.
using Samples = std::vector<std::uint8_t>;

std::uint8_t scaled(std::uint32_t value, std::uint32_t most) {
    return static_cast<std::uint8_t>((std::min(value, most) * 255U + most / 2U) / most);
}

Result<Samples> read_text(Scanner scanner, const Form& form, std::size_t count) {
    // Each sample needs at least a digit and a blank, so nothing is allocated for missing ones.
    if (scanner.rest().size() + 1 < (form.is_bits ? count : 2 * count - 1)) return cut_short("PNM");
    Samples samples(count);
    for (std::uint8_t& sample : samples) {
        const auto value = form.is_bits ? scanner.bit() : scanner.number();
        if (!value) return cut_short("PNM");
        sample = form.is_bits ? static_cast<std::uint8_t>(*value == 0 ? 255 : 0)
                              : scaled(*value, form.most);
    }
    return samples;
}

Result<Samples> read_bits(Bytes raster, std::size_t width, std::size_t height) {
    const std::size_t stride = (width + 7) / 8;
    if (raster.size() < stride * height) return cut_short("PNM");
    Samples samples(width * height);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const std::size_t x = i % width;
        const auto byte = std::to_integer<unsigned>(raster[i / width * stride + x / 8]);
        samples[i] = (byte >> (7 - x % 8) & 1U) != 0 ? 0 : 255;
    }
    return samples;
}

Result<Samples> read_numbers(Bytes raster, const Form& form, std::size_t count) {
    const std::size_t bytes = form.most > 255 ? 2 : 1;
    if (raster.size() < bytes * count) return cut_short("PNM");
    Samples samples(count);
    for (std::size_t i = 0; i < count; ++i) {
        auto value = std::to_integer<std::uint32_t>(raster[bytes * i]);
        if (bytes == 2) value = value << 8U | std::to_integer<std::uint32_t>(raster[2 * i + 1]);
        samples[i] = scaled(value, form.most);
    }
    return samples;
}

Picture picture_of(const Samples& samples, std::size_t channels, std::size_t width,
                   std::size_t height) {
    Shrinking shrinking(width, height, 3);
    std::vector<std::uint8_t> row(3 * width);
    for (std::size_t y = 0; y < height; ++y) {
        const std::uint8_t* from = samples.data() + channels * width * y;
        for (std::size_t x = 0; x < width; ++x, from += channels)
            for (std::size_t part = 0; part < 3; ++part)
                row[3 * x + part] = from[channels == 3 ? 2 - part : 0];
        shrinking.add_row(y, row);
    }
    return std::move(shrinking).picture();
}

}  // namespace

Result<Stored> read_pnm(Bytes bytes) {
    if (bytes.size() < 3) return cut_short("PNM");
    Form form = form_of(static_cast<char>(bytes[1]));
    Scanner scanner(bytes);
    const auto width = scanner.number();
    const auto height = scanner.number();
    const auto most = form.is_bits ? std::optional(std::uint32_t{1}) : scanner.number();
    if (!width || !height || !most || *most < 1 || *most > 65'535)
        return damaged("PNM", "its header is unknown");
    if (auto fits = check_file_size("PNM", *width, *height); !fits)
        return tl::unexpected(fits.error());
    form.most = *most;
    const std::size_t count = form.channels * *width * *height;
    const auto samples = form.is_text   ? read_text(scanner, form, count)
                         : form.is_bits ? read_bits(scanner.rest(), *width, *height)
                                        : read_numbers(scanner.rest(), form, count);
    if (!samples) return tl::unexpected(samples.error());
    return Stored{picture_of(*samples, form.channels, *width, *height)};
}

}  // namespace touchline::decode
