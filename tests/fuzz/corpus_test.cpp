// Every input that a fuzzer found worth keeping, again, and random ones.
#include "tests/fuzz/reply_fuzz.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(FuzzCorpus, RepliesAreHandledWhateverTheyAre) {
    const auto folder = std::filesystem::path(TOUCHLINE_SOURCE_DIR) / "tests/fuzz/corpus/reply";
    int inputs = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::ifstream in(entry.path(), std::ios::binary);
        const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
        feed_packets({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
        ++inputs;
    }
    EXPECT_GT(inputs, 10);
}

TEST(FuzzCorpus, RandomPacketsAreHandled) {
    constexpr std::array<std::uint8_t, 10> good{9,    0x05, 0x8f, 0x36, 0x3f,
                                                0x41, 0xd2, 0xe6, 0x27, 0x43};
    std::mt19937_64 random(5);
    for (int run = 0; run < 5000; ++run) {
        std::vector<std::uint8_t> bytes;
        for (auto packets = random() % 12; packets > 0; --packets) {
            const std::size_t at = bytes.size();
            bytes.insert(bytes.end(), good.begin(), good.end());
            if (random() % 4 == 0) bytes[at] = static_cast<std::uint8_t>(random());
            if (random() % 4 == 0)
                bytes[at + 1 + random() % 9] ^= static_cast<std::uint8_t>(1U << random() % 8);
            bytes.push_back(0xff);
        }
        feed_packets(bytes);
    }
}

}  // namespace
}  // namespace touchline
