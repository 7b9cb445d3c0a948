
#include "app/documents/decode/readers.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace touchline::decode {
namespace {

std::uint16_t weighted(std::uint8_t colour, unsigned alpha) {
    return static_cast<std::uint16_t>((colour * alpha + 127U) / 255U);
}

}  // namespace

unsigned reduction_for(std::uint64_t width, std::uint64_t height) {
    constexpr unsigned most = 8;
    unsigned by = 1;
    const auto is_too_large = [&] {
        const std::uint64_t across = reduced_side(width, by);
        const std::uint64_t down = reduced_side(height, by);
        return across * down > max_full_pixels || std::max(across, down) > max_picture_side_px;
    };
    while (by < most && is_too_large()) by *= 2;
    return by;
}

Shrinking::Shrinking(std::size_t width, std::size_t height, std::size_t channels)
    : width_(width),
      height_(height),
      channels_(channels),
      by_(reduction_for(width, height)),
      shift_(static_cast<unsigned>(std::countr_zero(by_))),
      picture_{static_cast<int>(reduced_side(width, by_)),
               static_cast<int>(reduced_side(height, by_)),
               {},
               1.0 / by_} {
    const std::size_t size = channels_ * static_cast<std::size_t>(picture_.width) *
                             static_cast<std::size_t>(picture_.height);
    if (by_ == 1) {
        picture_.bgr.resize(size);
    } else {
        sums_.resize(size);
    }
}

void Shrinking::add_row(std::size_t y, std::span<const std::uint8_t> pixels, Columns columns) {
    if (y >= height_ || columns.first >= width_) return;
    const std::size_t most = (width_ - columns.first + columns.step - 1) / columns.step;
    pixels = pixels.first(std::min(pixels.size(), channels_ * most));
    if (by_ == 1) return keep_row(y, pixels, columns);
    return channels_ == 4 ? sum_row<4>(y, pixels, columns) : sum_row<3>(y, pixels, columns);
}

void Shrinking::keep_row(std::size_t y, std::span<const std::uint8_t> pixels, Columns columns) {
    std::uint8_t* to = picture_.bgr.data() + channels_ * (y * width_ + columns.first);
    if (columns.step == 1) {
        std::ranges::copy(pixels, to);
        return;
    }
    for (std::size_t i = 0; i < pixels.size(); i += channels_, to += channels_ * columns.step)
        std::copy_n(&pixels[i], channels_, to);
}

template <std::size_t channels>
void Shrinking::sum_row(std::size_t y, std::span<const std::uint8_t> pixels, Columns columns) {
    std::uint16_t* const row =
        sums_.data() + channels * (y >> shift_) * static_cast<std::size_t>(picture_.width);
    std::size_t x = columns.first;
    for (std::size_t i = 0; i < pixels.size(); i += channels, x += columns.step) {
        std::uint16_t* const sum = row + channels * (x >> shift_);
        const std::uint8_t* const pixel = &pixels[i];
        const unsigned alpha = channels == 4 ? pixel[3] : 255U;
        for (std::size_t channel = 0; channel < 3; ++channel)
            sum[channel] = static_cast<std::uint16_t>(
                sum[channel] + (channels == 4 ? weighted(pixel[channel], alpha) : pixel[channel]));
        if (channels == 4) sum[3] = static_cast<std::uint16_t>(sum[3] + alpha);
    }
}

unsigned Shrinking::pixels_in(std::size_t x, std::size_t y) const {
    const std::size_t across = std::min<std::size_t>(by_, width_ - x * by_);
    const std::size_t down = std::min<std::size_t>(by_, height_ - y * by_);
    return static_cast<unsigned>(across * down);
}

void Shrinking::take_means() {
    picture_.bgr.resize(sums_.size());
    const std::uint16_t* sum = sums_.data();
    std::uint8_t* to = picture_.bgr.data();
    const auto width = static_cast<std::size_t>(picture_.width);
    const auto height = static_cast<std::size_t>(picture_.height);
    const auto mean = [](unsigned of, unsigned parts) {
        return static_cast<std::uint8_t>(std::min(255U, (of + parts / 2) / std::max(parts, 1U)));
    };
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x, sum += channels_, to += channels_) {
            const unsigned count = pixels_in(x, y);
            const bool has_alpha = channels_ == 4;
            for (std::size_t channel = 0; channel < 3; ++channel)
                to[channel] =
                    has_alpha ? mean(255U * sum[channel], sum[3]) : mean(sum[channel], count);
            if (has_alpha) to[3] = mean(sum[3], count);
        }
    }
    sums_ = {};
}

Picture Shrinking::picture() && {
    if (by_ > 1) take_means();
    if (channels_ == 4) compose(picture_.bgr);
    return std::move(picture_);
}

}  // namespace touchline::decode
