// Tests VI-4 on ten seconds of frames of a visit that changes as fast as it can: no area changes
// more than twice a second, except the handle's marker, which is no layer.
#include "app/screen/pace.h"
#include "app/screen/screen_layers.h"
#include "tests/app/screen/contact_sheet.h"
#include "tests/app/screen/probes.h"
#include "tests/app/screen/sample_screens.h"

#include <cmath>
#include <deque>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr int small_width = 640;
constexpr int small_height = 400;
constexpr int tile_px = 20;
constexpr int frame_rate_Hz = 60;

/// Returns the mean brightness of each tile, 0 ... 1.
std::vector<double> tiles_of(const Canvas& canvas) {
    std::vector<double> tiles;
    for (int top = 0; top < small_height; top += tile_px) {
        for (int left = 0; left < small_width; left += tile_px) {
            double sum = 0.0;
            for (int y = top; y < top + tile_px; ++y) {
                for (int x = left; x < left + tile_px; ++x) {
                    const Colour c = colour_at(canvas, {x + 0.5, y + 0.5});
                    sum += 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue;
                }
            }
            tiles.push_back(sum / (tile_px * tile_px));
        }
    }
    return tiles;
}

/// Records the most changes that any tile had within any second.
class FrameLog {
  public:
    void add(std::vector<double> tiles, std::int64_t now_ns) {
        changes_.resize(tiles.size());
        for (std::size_t i = 0; i < tiles.size() && !last_.empty(); ++i) {
            if (std::abs(tiles[i] - last_[i]) < 0.005) continue;
            std::deque<std::int64_t>& times = changes_[i];
            while (!times.empty() && now_ns - times.front() >= one_second_ns) times.pop_front();
            times.push_back(now_ns);
            most_ = std::max(most_, times.size());
            ++all_;
        }
        last_ = std::move(tiles);
    }

    [[nodiscard]] std::size_t most() const { return most_; }

    [[nodiscard]] std::size_t all() const { return all_; }

  private:
    std::vector<double> last_;
    std::vector<std::deque<std::int64_t>> changes_;
    std::size_t most_ = 0;
    std::size_t all_ = 0;
};

std::uint64_t versions(const ScreenLayers& layers) {
    return layers.sheet().version + layers.captions().version + layers.picture().version;
}

template <class ContentAt>
FrameLog log_of(const ContentAt& content_at) {
    ScreenLayers layers(14.0);
    FrameLog log;
    std::uint64_t last = 0;
    for (int frame = 0; frame < 10 * frame_rate_Hz; ++frame) {
        const std::int64_t now_ns = frame * one_second_ns / frame_rate_Hz;
        layers.update(content_at(frame), small_width, small_height, now_ns);
        if (versions(layers) == last) continue;
        last = versions(layers);
        log.add(tiles_of(composed(layers, small_width, small_height)), now_ns);
    }
    return log;
}

TEST(Flashing, VI4_AVisitThatChangesWithEveryFrameDoesNot) {
    const std::vector<NamedScreen> screens = sample_screens(Language());
    const FrameLog log = log_of([&](int frame) {
        ScreenContent content;
        const auto i = static_cast<std::size_t>(frame);
        content.screen = screens[i / 40 % screens.size()].screen;
        if (!content.screen.items.empty())
            content.screen.focus = i / 6 % content.screen.items.size();
        content.caption = "Sentence number " + std::to_string(i / 10);
        content.sound_sign = i % 12 < 6 ? "touch" : "leave";
        content.text_size = static_cast<TextSize>(i / 25 % text_size_count);
        content.palette = static_cast<PaletteName>(i / 15 % palette_count);
        return content;
    });
    EXPECT_LE(log.most(), 2U);
    EXPECT_GT(log.all(), 1000U);  // it did change
}

TEST(Flashing, TwoItemsInTurnAndTwoSoundsInTurnDoNot) {
    ScreenContent content;
    content.screen = sample_screens(Language()).front().screen;
    const FrameLog log = log_of([&](int frame) {
        content.screen.focus = static_cast<std::size_t>(frame / 5 % 2);
        content.sound_sign = frame % 10 == 0 ? "touch" : frame % 10 == 5 ? "leave" : "";
        return content;
    });
    EXPECT_LE(log.most(), 2U);
    EXPECT_GT(log.all(), 100U);
}

TEST(Flashing, PagesThatTurnByThemselvesDoNot) {
    ScreenContent content;
    content.screen = sample_screens(Language())[5].screen;  // a text of many pages
    content.text_size = TextSize::largest;
    content.caption = content.screen.text;
    const FrameLog log = log_of([&](int) { return content; });
    EXPECT_LE(log.most(), 1U);
    EXPECT_GT(log.all(), 100U);
}

TEST(Flashing, ASingleKeyIsShownAtOnce) {
    ScreenLayers layers(14.0);
    ScreenContent content;
    content.screen = sample_screens(Language()).front().screen;
    layers.update(content, small_width, small_height, 0);
    content.screen.focus = 2;
    layers.update(content, small_width, small_height, 5 * one_second_ns);
    EXPECT_EQ(layers.shown().screen.focus, 2U);
}

TEST(Flashing, TheLastOfManyKeysIsShownWithinASecond) {
    ScreenLayers layers(14.0);
    ScreenContent content;
    content.screen = sample_screens(Language()).front().screen;
    for (int frame = 0; frame < 90; ++frame) {
        content.screen.focus = static_cast<std::size_t>(std::min(frame, 30) % 4);
        layers.update(content, small_width, small_height, frame * one_second_ns / frame_rate_Hz);
    }
    EXPECT_EQ(layers.shown().screen.focus, 2U);  // 30 % 4
}

TEST(Flashing, ASoundOfOneFrameKeepsItsSignForASecond) {
    ScreenLayers layers(14.0);
    ScreenContent content;
    content.screen = sample_screens(Language()).front().screen;
    layers.update(content, small_width, small_height, 0);
    content.sound_sign = "corner";
    layers.update(content, small_width, small_height, 5 * one_second_ns);
    content.sound_sign.clear();
    layers.update(content, small_width, small_height, 6 * one_second_ns - 1);
    EXPECT_EQ(layers.shown().sound_sign, "corner");
    layers.update(content, small_width, small_height, 6 * one_second_ns);
    EXPECT_EQ(layers.shown().sound_sign, "");
}

TEST(Flashing, VI4_ThePreviewIsOffWhenItIsTurnedOff) {
    ScreenLayers layers(14.0);
    ScreenContent content;
    content.screen = sample_screens(Language())[3].screen;
    ASSERT_EQ(content.screen.view, ScreenView::camera);
    const std::vector<std::uint8_t> white(3 * 40 * 30, 255);
    content.preview = std::make_shared<const Canvas>(canvas_of_frame(white, 40, 30, 120));
    layers.update(content, small_width, small_height, 0);
    const Rect& rect = layers.picture().rect;
    ASSERT_GT(rect.width, 0.0);
    const PixelPoint middle{rect.x + rect.width / 2.0, rect.y + rect.height / 2.0};
    EXPECT_TRUE(
        is_near(colour_at(composed(layers, small_width, small_height), middle), {1.0, 1.0, 1.0}));
    content.is_preview_on = false;
    layers.update(content, small_width, small_height, one_second_ns);
    EXPECT_EQ(layers.picture().rect.width, 0.0);
    EXPECT_EQ(layers.sheet().rect.width, small_width);
}

}  // namespace
}  // namespace touchline
