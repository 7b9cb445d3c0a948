#include "app/decode/bmp_runs.h"

#include <algorithm>
#include <array>
#include <utility>

namespace touchline::decode {
namespace {

/// Reads runs of equal pixels, and stretches of different ones.
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

}  // namespace

std::optional<std::vector<std::uint8_t>> unpacked_runs(Bytes packed, const BmpHeader& header) {
    RunReader runs(packed, header);
    if (!runs.read()) return std::nullopt;
    return std::move(runs).pixels();
}

}  // namespace touchline::decode
