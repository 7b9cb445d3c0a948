// Private to app/decode: the meaning of a TIFF's samples.
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
