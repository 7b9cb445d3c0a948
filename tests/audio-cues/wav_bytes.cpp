#include "tests/audio-cues/wav_bytes.h"

namespace touchline {
namespace {

std::string number(std::uint32_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>((value >> (8 * i)) & 0xFFU);
    return text;
}

}  // namespace

std::string wav_bytes(std::uint32_t rate_Hz, std::uint32_t channels,
                      const std::vector<int>& samples) {
    std::string data;
    for (const int sample : samples) data += number(static_cast<std::uint32_t>(sample), 2);
    const std::string format = number(1, 2) + number(channels, 2) + number(rate_Hz, 4) +
                               number(rate_Hz * 2 * channels, 4) + number(2 * channels, 2) +
                               number(16, 2);
    const std::string rest = "WAVEfmt " + number(16, 4) + format + "junk" + number(3, 4) + "abc_" +
                             "data" + number(static_cast<std::uint32_t>(data.size()), 4) + data;
    return "RIFF" + number(static_cast<std::uint32_t>(rest.size()), 4) + rest;
}

}  // namespace touchline
