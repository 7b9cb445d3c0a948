#include "app/decode/formats.h"

namespace touchline::decode {

void compose_over_white(std::vector<std::uint8_t>& bgra) {
    const std::size_t pixels = bgra.size() / 4;
    for (std::size_t i = 0; i < pixels; ++i) {
        const unsigned alpha = bgra[4 * i + 3];
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const unsigned sum = bgra[4 * i + channel] * alpha + 255U * (255U - alpha) + 127U;
            bgra[3 * i + channel] = static_cast<std::uint8_t>(sum / 255U);
        }
    }
    bgra.resize(3 * pixels);
}

}  // namespace touchline::decode
