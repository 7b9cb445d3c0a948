#include "app/decode/formats.h"

#include <algorithm>
#include <cstdlib>

namespace touchline::decode {
namespace {

constexpr int kAlike = 40;  // grey levels: a smaller difference from the background is invisible
constexpr double kUnseen = 0.97;  // if more of what is painted is near white, nothing would be seen

int lightness_of(const std::uint8_t* bgr) {
    return (29 * bgr[0] + 150 * bgr[1] + 77 * bgr[2]) / 256;
}

/// White, as paper is; black if nearly everything painted is white, and something shows through.
unsigned ground_for(const std::vector<std::uint8_t>& bgra) {
    std::uint64_t painted = 0;
    std::uint64_t unseen = 0;
    std::size_t open = 0;
    for (std::size_t i = 0; i + 3 < bgra.size(); i += 4) {
        const unsigned alpha = bgra[i + 3];
        painted += alpha;
        if (255 - lightness_of(&bgra[i]) < kAlike) unseen += alpha;
        if (alpha < 255 - kAlike) ++open;
    }
    const bool is_unseen =
        open > 0 && static_cast<double>(unseen) >
                        kUnseen * static_cast<double>(std::max<std::uint64_t>(painted, 1));
    return is_unseen ? 0U : 255U;
}

}  // namespace

void compose(std::vector<std::uint8_t>& bgra) {
    const unsigned ground = ground_for(bgra);
    const std::size_t pixels = bgra.size() / 4;
    for (std::size_t i = 0; i < pixels; ++i) {
        const unsigned alpha = bgra[4 * i + 3];
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const unsigned sum = bgra[4 * i + channel] * alpha + ground * (255U - alpha) + 127U;
            bgra[3 * i + channel] = static_cast<std::uint8_t>(sum / 255U);
        }
    }
    bgra.resize(3 * pixels);
}

void unmultiply(std::uint8_t* bgra) {
    const unsigned alpha = bgra[3];
    for (std::size_t channel = 0; alpha > 0 && channel < 3; ++channel)
        bgra[channel] =
            static_cast<std::uint8_t>(std::min(255U, (bgra[channel] * 255U + alpha / 2U) / alpha));
}

}  // namespace touchline::decode
