// Private to app/decode: what the samples of a TIFF mean.
// Threads: one object, one thread.
#pragma once

#include "app/decode/tiff_file.h"
#include "app/decode/tiff_samples.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace touchline::decode {

/// Ways of telling a colour: so many samples each.
enum class TiffColours : std::uint8_t { grey, white_is_zero, palette, rgb, inks, lab };

/// How pixels are stored, where it is not libtiff's own business (tiff_reader.cpp).
struct TiffForm {
    SampleForm samples;
    std::uint16_t count = 1;  // of samples a pixel
    bool is_planar = false;   // each of them is stored for itself
    TiffColours colours = TiffColours::grey;
    std::uint16_t colour_count = 1;                    // of them, the first ones
    std::optional<std::uint16_t> alpha;                // which of the others
    bool is_multiplied = false;                        // the colours are, by alpha
    std::uint32_t lab_kind = 0;                        // TIFF's number of it
    std::vector<std::array<std::uint8_t, 3>> palette;  // blue, green, red
};

/// Fails with one line where nothing is felt of such pixels.
[[nodiscard]] Result<TiffForm> form_of(const TiffFile& file);

/// Samples become blue, green, red and, where there is one, straight alpha.
class TiffPixels {
  public:
    /// `range`: of the colours.
    TiffPixels(const TiffForm& form, const Range& range);

    [[nodiscard]] std::size_t channels() const { return form_.alpha ? 4 : 3; }

    /// The samples that are looked at, as planes.
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

    /// Of the samples that are looked at.
    [[nodiscard]] std::vector<Channel> unpacked(const Stretch& stretch);
    void write_colours(std::span<const Channel> channels, std::size_t count);
    void write_inks(std::span<const Channel> channels, std::size_t count);
    void write_lab(std::span<const Channel> channels, std::size_t count);

    struct DeleteTransform {
        void operator()(void* transform) const;
    };

    TiffForm form_;
    Range range_;
    std::vector<float> numbers_;
    std::vector<std::uint8_t> lab_;
    std::vector<std::uint8_t> pixels_;
    std::unique_ptr<void, DeleteTransform> from_lab_;
};

}  // namespace touchline::decode
