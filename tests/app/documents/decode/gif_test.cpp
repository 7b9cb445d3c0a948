// Tests every way to put a GIF together; the tests write the files themselves.
#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/encoders.h"

#include <array>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using encoders::Bytes;
using Indices = std::vector<std::uint8_t>;

void add(Bytes& bytes, std::uint32_t value, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        bytes.push_back(static_cast<std::byte>(value >> (8 * i) & 0xffU));
}

/// Writes codes of a growing number of bits, lowest bit first.
class CodeWriter {
  public:
    void add(unsigned code, unsigned bits) {
        held_ |= code << held_bits_;
        for (held_bits_ += bits; held_bits_ >= 8; held_bits_ -= 8, held_ >>= 8U)
            bytes_.push_back(static_cast<std::byte>(held_ & 0xffU));
    }

    /// Returns the bytes in blocks of at most 255.
    Bytes blocks() {
        if (held_bits_ > 0) bytes_.push_back(static_cast<std::byte>(held_ & 0xffU));
        Bytes out;
        for (std::size_t i = 0; i < bytes_.size(); i += 255) {
            const std::size_t size = std::min<std::size_t>(255, bytes_.size() - i);
            out.push_back(static_cast<std::byte>(size));
            const auto first = bytes_.begin() + static_cast<std::ptrdiff_t>(i);
            out.insert(out.end(), first, first + static_cast<std::ptrdiff_t>(size));
        }
        out.push_back(std::byte{0});
        return out;
    }

  private:
    Bytes bytes_;
    std::uint32_t held_ = 0;
    unsigned held_bits_ = 0;
};

/// The table is full at 4096 codes: it is then cleared, or kept to the end as some encoders do.
Bytes packed(const Indices& indices, bool is_kept_when_full) {
    constexpr unsigned index_bits = 8;
    constexpr unsigned clear = 1U << index_bits;
    constexpr unsigned most_codes = 4096;
    CodeWriter writer;
    std::map<std::pair<unsigned, std::uint8_t>, unsigned> table;
    unsigned bits = index_bits + 1;
    unsigned next = clear + 2;
    writer.add(clear, bits);
    unsigned held = indices.front();
    for (std::size_t i = 1; i < indices.size(); ++i) {
        const auto found = table.find({held, indices[i]});
        if (found != table.end()) {
            held = found->second;
            continue;
        }
        writer.add(held, bits);
        if (next < most_codes) {
            if (next == 1U << bits) ++bits;
            table[{held, indices[i]}] = next++;
        } else if (!is_kept_when_full) {
            writer.add(clear, bits);
            table.clear();
            bits = index_bits + 1;
            next = clear + 2;
        }
        held = indices[i];
    }
    writer.add(held, bits);
    if (next == 1U << bits && bits < 12) ++bits;
    writer.add(clear + 1, bits);
    Bytes out{static_cast<std::byte>(index_bits)};
    const Bytes blocks = writer.blocks();
    out.insert(out.end(), blocks.begin(), blocks.end());
    return out;
}

struct Frame {
    std::uint32_t left = 0, top = 0, width = 1, height = 1;
    Indices indices{};
    int pause = -1;        // in hundredths of a second; negative: not stated
    int transparent = -1;  // index
    unsigned disposal = 0;
    bool is_interlaced = false;
    bool is_kept_when_full = false;
    std::uint8_t green = 0;  // of the frame's colours (i, green, 255 - i)
    bool is_grey = false;    // then the colours are (i, i, i)
};

/// Returns colour i of a frame.
std::array<std::uint8_t, 3> bgr_of(const Frame& frame, std::uint8_t i) {
    if (frame.is_grey) return {i, i, i};
    return {static_cast<std::uint8_t>(255 - i), frame.green, i};
}

void add_frame(Bytes& bytes, const Frame& frame) {
    if (frame.pause >= 0 || frame.transparent >= 0 || frame.disposal > 0) {
        add(bytes, 0x04f921, 3);
        add(bytes, frame.disposal << 2U | (frame.transparent >= 0 ? 1U : 0U), 1);
        add(bytes, static_cast<std::uint32_t>(std::max(frame.pause, 0)), 2);
        add(bytes, static_cast<std::uint32_t>(std::max(frame.transparent, 0)), 1);
        add(bytes, 0, 1);
    }
    add(bytes, 0x2c, 1);
    for (const std::uint32_t place : {frame.left, frame.top, frame.width, frame.height})
        add(bytes, place, 2);
    add(bytes, 0x87U | (frame.is_interlaced ? 0x40U : 0U), 1);
    for (unsigned i = 0; i < 256; ++i) {
        const auto [blue, green, red] = bgr_of(frame, static_cast<std::uint8_t>(i));
        add(bytes, red, 1);
        add(bytes, green, 1);
        add(bytes, blue, 1);
    }
    const Bytes data = packed(frame.indices, frame.is_kept_when_full);
    bytes.insert(bytes.end(), data.begin(), data.end());
}

struct Screen {
    std::uint32_t width = 0, height = 0;
    bool is_repeated = false;
    std::uint32_t aspect = 0;
};

Bytes gif(const Screen& screen, const std::vector<Frame>& frames) {
    Bytes bytes = encoders::bytes_of("GIF89a");
    add(bytes, screen.width, 2);
    add(bytes, screen.height, 2);
    add(bytes, 0, 2);  // no global colours, background 0
    add(bytes, screen.aspect, 1);
    if (screen.is_repeated) {
        add(bytes, 0x0bff21, 3);
        const Bytes name = encoders::bytes_of("NETSCAPE2.0");
        bytes.insert(bytes.end(), name.begin(), name.end());
        add(bytes, 0x000103, 3);
        add(bytes, 0, 2);
    }
    for (const Frame& frame : frames) add_frame(bytes, frame);
    add(bytes, 0x3b, 1);
    return bytes;
}

Frame plain_frame(std::uint32_t left, std::uint32_t top, std::uint32_t width, std::uint32_t height,
                  std::uint8_t index) {
    Frame frame;
    frame.left = left;
    frame.top = top;
    frame.width = width;
    frame.height = height;
    frame.indices.assign(std::size_t{width} * height, index);
    return frame;
}

bool is(const Picture& picture, int x, int y, const std::array<std::uint8_t, 3>& bgr) {
    return std::equal(bgr.begin(), bgr.end(),
                      &picture.bgr.at(3 * static_cast<std::size_t>(y * picture.width + x)));
}

constexpr std::array<std::uint8_t, 3> white{255, 255, 255};

Frame noise_frame(std::uint32_t width, std::uint32_t height) {
    Frame frame = plain_frame(0, 0, width, height, 0);
    std::mt19937 random(7);
    for (std::uint8_t& index : frame.indices)
        index = static_cast<std::uint8_t>(random() % 3 == 0 ? random() % 256 : 40);
    return frame;
}

TEST(GifReader, AFullTableIsClearedOrKept) {
    for (const bool is_kept : {false, true}) {
        for (const bool is_interlaced : {false, true}) {
            Frame frame = noise_frame(301, 203);
            frame.is_kept_when_full = is_kept;
            frame.is_interlaced = false;
            const Picture plain = decoded(gif({301, 203}, {frame}));
            for (std::size_t i = 0; i < frame.indices.size(); ++i)
                ASSERT_TRUE(is(plain, static_cast<int>(i % 301), static_cast<int>(i / 301),
                               bgr_of(frame, frame.indices[i])))
                    << i;
            if (!is_interlaced) continue;
            Frame woven = frame;
            woven.is_interlaced = true;
            woven.indices.clear();
            for (const auto& [first, step] :
                 {std::pair{0U, 8U}, std::pair{4U, 8U}, std::pair{2U, 4U}, std::pair{1U, 2U}})
                for (std::size_t y = first; y < 203; y += step) {
                    const auto row = frame.indices.begin() + static_cast<std::ptrdiff_t>(301 * y);
                    woven.indices.insert(woven.indices.end(), row, row + 301);
                }
            EXPECT_TRUE(decoded(gif({301, 203}, {woven})).bgr == plain.bgr);
        }
    }
}

/// Each tile has its own 256 colours, so together they have more than one frame may have.
TEST(GifReader, TilesWithoutAPauseAreOnePicture) {
    std::vector<Frame> tiles;
    for (std::uint32_t i = 0; i < 6; ++i) {
        tiles.push_back(
            plain_frame(10 * (i % 3), 8 * (i / 3), 10, 8, static_cast<std::uint8_t>(i)));
        tiles.back().green = static_cast<std::uint8_t>(40 * i);
        tiles.back().pause = i % 2 == 0 ? 0 : -1;
    }
    const Picture picture = decoded(gif({30, 16}, tiles));
    ASSERT_EQ(picture.width, 30);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 30; ++x) {
            const int i = x / 10 + 3 * (y / 8);
            ASSERT_TRUE(
                is(picture, x, y,
                   bgr_of(tiles[static_cast<std::size_t>(i)], static_cast<std::uint8_t>(i))));
        }
}

TEST(GifReader, TheFirstPauseEndsThePicture) {
    Frame first = plain_frame(0, 0, 4, 4, 10);
    Frame second = plain_frame(1, 1, 2, 2, 20);
    Frame third = plain_frame(0, 0, 4, 3, 30);
    second.pause = 5;
    const Picture picture = decoded(gif({4, 4, true}, {first, second, third}));
    EXPECT_TRUE(is(picture, 0, 0, bgr_of(first, 10)));
    EXPECT_TRUE(is(picture, 1, 1, bgr_of(first, 20)));
    EXPECT_TRUE(is(picture, 3, 3, bgr_of(first, 10)));
}

/// Programs show such a film as fast as they can.
TEST(GifReader, AFilmWithoutPausesShowsItsFirstFrame) {
    std::vector<Frame> frames{plain_frame(0, 0, 4, 4, 10), plain_frame(0, 0, 4, 4, 20)};
    for (const bool is_repeated : {false, true})
        EXPECT_TRUE(is(decoded(gif({4, 4, is_repeated}, frames)), 2, 2, bgr_of(frames[0], 10)));
    frames[1] = plain_frame(1, 1, 2, 2, 20);  // only what changed
    EXPECT_TRUE(is(decoded(gif({4, 4, true}, frames)), 2, 2, bgr_of(frames[0], 10)));
}

/// Each layer adds what the earlier ones had no colours for.
TEST(GifReader, LayersWithoutAPauseAreOnePicture) {
    Frame second = plain_frame(0, 0, 4, 4, 0);
    second.transparent = 0;
    second.indices[5] = 20;
    const Picture picture = decoded(gif({4, 4}, {plain_frame(0, 0, 4, 4, 10), second}));
    EXPECT_TRUE(is(picture, 1, 1, bgr_of(second, 20)));
    EXPECT_TRUE(is(picture, 2, 1, bgr_of(second, 10)));
}

TEST(GifReader, WhatIsTakenAwayAgainIsNotSeen) {
    Frame ground = plain_frame(0, 0, 6, 2, 10);
    Frame previous = plain_frame(0, 0, 2, 2, 20);
    previous.disposal = 3;
    Frame background = plain_frame(2, 0, 2, 2, 30);
    background.disposal = 2;
    Frame last = plain_frame(4, 0, 1, 2, 40);
    last.disposal = 3;
    const Picture picture = decoded(gif({6, 2}, {ground, previous, background, last}));
    EXPECT_TRUE(is(picture, 0, 0, bgr_of(ground, 10)));
    EXPECT_TRUE(is(picture, 2, 0, white));
    EXPECT_TRUE(is(picture, 4, 0, bgr_of(ground, 40)));
    EXPECT_TRUE(is(picture, 5, 0, bgr_of(ground, 10)));
}

TEST(GifReader, AFrameThatCoversAPartLeavesTheRestClear) {
    Frame frame = plain_frame(2, 1, 3, 2, 7);
    frame.indices[0] = 9;
    frame.transparent = 9;
    const Picture picture = decoded(gif({8, 5}, {frame}));
    ASSERT_EQ(picture.width, 8);
    ASSERT_EQ(picture.height, 5);
    EXPECT_TRUE(is(picture, 0, 0, white));
    EXPECT_TRUE(is(picture, 2, 1, white));
    EXPECT_TRUE(is(picture, 3, 1, bgr_of(frame, 7)));
    EXPECT_TRUE(is(picture, 4, 2, bgr_of(frame, 7)));
    EXPECT_TRUE(is(picture, 5, 2, white));
}

TEST(GifReader, AScreenWithoutASizeIsAsLargeAsItsFrames) {
    const std::vector<Frame> tiles{plain_frame(0, 0, 3, 4, 1), plain_frame(3, 0, 2, 4, 2)};
    const Picture picture = decoded(gif({0, 0}, tiles));
    EXPECT_EQ(picture.width, 5);
    EXPECT_EQ(picture.height, 4);
    EXPECT_TRUE(is(picture, 4, 3, bgr_of(tiles[1], 2)));
    const Picture grown = decoded(gif({2, 2}, {plain_frame(0, 0, 3, 4, 1)}));
    EXPECT_EQ(grown.width, 3);
    EXPECT_EQ(grown.height, 4);
}

TEST(GifReader, WithoutItsLastByteItIsWhole) {
    Bytes bytes = gif({4, 4}, {plain_frame(0, 0, 4, 4, 10)});
    bytes.pop_back();
    EXPECT_TRUE(is(decoded(bytes), 3, 3, bgr_of({}, 10)));
}

TEST(GifReader, ATileThatIsMissingIsRefused) {
    Bytes bytes = gif({40, 4}, {plain_frame(0, 0, 20, 4, 10), noise_frame(20, 4)});
    bytes.resize(bytes.size() - 40);
    const auto picture = decode_picture(bytes);
    ASSERT_FALSE(picture);
    EXPECT_NE(picture.error().line.find("GIF"), std::string::npos);
}

/// The aspect byte n means a pixel's width over its height of (15 + n) / 64.
TEST(GifReader, TheShapeOfItsPixelsIsKept) {
    const Picture wide = decoded(gif({4, 4, false, 113}, {plain_frame(0, 0, 4, 4, 10)}));
    EXPECT_EQ(wide.width, 8);
    EXPECT_EQ(wide.height, 4);
    const Picture high = decoded(gif({4, 4, false, 17}, {plain_frame(0, 0, 4, 4, 10)}));
    EXPECT_EQ(high.width, 4);
    EXPECT_EQ(high.height, 8);
    EXPECT_EQ(decoded(gif({4, 4, false, 49}, {plain_frame(0, 0, 4, 4, 10)})).width, 4);
}

TEST(GifReader, InkOnNothingLiesOnTheGroundThatShowsIt) {
    for (const std::uint8_t ink : {std::uint8_t{255}, std::uint8_t{0}}) {
        Frame frame = plain_frame(0, 0, 24, 24, 9);
        frame.transparent = 9;
        frame.is_grey = true;
        for (std::size_t y = 8; y < 16; ++y)
            std::fill_n(frame.indices.begin() + static_cast<std::ptrdiff_t>(24 * y + 8), 8, ink);
        const Picture picture = decoded(gif({24, 24}, {frame}));
        const auto ground = static_cast<std::uint8_t>(255 - ink);
        EXPECT_TRUE(is(picture, 12, 12, {ink, ink, ink}));
        EXPECT_TRUE(is(picture, 2, 2, {ground, ground, ground}));
    }
}

}  // namespace
}  // namespace touchline
