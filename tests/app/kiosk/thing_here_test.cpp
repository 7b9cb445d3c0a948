// Tests a visitor's request for the thing under the hand, from the stick to what is said, with a
// made-up network.
#include "app/trace/finding_things.h"
#include "tests/app/kiosk/blind_visitor.h"
#include "tests/app/kiosk/kiosk_world.h"

#include <cmath>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Writes a PPM file: a dark disc with light and grain everywhere, as no program paints it.
void write_photograph(const std::filesystem::path& file) {
    constexpr int width = 420;
    constexpr int height = 300;
    std::ofstream out(file, std::ios::binary);
    out << "P6 " << width << ' ' << height << " 255\n";
    std::uint32_t random = 1;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            random = random * 1664525U + 1013904223U;
            const double grain = static_cast<double>(random >> 24U) / 16.0 - 8.0;
            const double light = 60.0 * std::sin(x / 17.0) * std::cos(y / 23.0);
            const double ground = std::hypot(x - 210, y - 150) < 70.0 ? 80.0 : 160.0;
            const double value =
                ground + 0.5 * light + 15.0 * std::sin((x + 2.0 * y) / 41.0) + grain;
            const char level = static_cast<char>(static_cast<unsigned char>(value));
            out.put(level).put(level).put(level);
        }
    }
}

/// For a place, it returns nothing at first, then a failure, then the middle of the picture.
ThingFinder made_up_finder(std::shared_ptr<int> looks) {
    return [looks](const Page& page,
                   const std::optional<PlaceInPicture>& place) -> Result<std::optional<Page>> {
        if (!place) {
            Page seen = page;
            seen.was_searched = true;
            return seen;
        }
        if (++*looks == 1) return std::nullopt;
        if (*looks == 2) return failure("the network is damaged");
        MainThings thing;
        thing.mask = {20, 20, std::vector<std::uint8_t>(400, 0)};
        for (std::size_t y = 5; y < 15; ++y)
            for (std::size_t x = 5; x < 15; ++x) thing.mask.grey[20 * y + x] = 255;
        thing.boxes = {{0.25, 0.25, 0.75, 0.75}};
        return with_further_thing(page, std::move(thing));
    };
}

TEST(ThingHere, IsSaidWhetherItWasFoundOrNotAndThePictureStays) {
    const auto looks = std::make_shared<int>(0);
    KioskWorld world(false, whole_gallery(all_languages()), made_up_finder(looks));
    BlindVisitor visitor(world);
    const std::filesystem::path photograph = world.folder() / "garden.ppm";
    write_photograph(photograph);
    world.put_stick({photograph});
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("English"));
    ASSERT_TRUE(visitor.choose("Your USB stick"));
    ASSERT_TRUE(visitor.choose("garden")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("It has no clear main thing")) << visitor.heard();
    (void)world.kiosk().take_report();

    ASSERT_TRUE(visitor.choose("Find the thing under my hand")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("Nothing clear lies there")) << visitor.heard();
    EXPECT_EQ(world.kiosk().take_report(), "") << "that is an answer, no trouble";

    ASSERT_TRUE(visitor.choose("Find the thing under my hand")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("The main thing cannot be looked for now")) << visitor.heard();
    EXPECT_NE(world.kiosk().take_report(), "");

    const int felt = world.servo().felt_count;
    ASSERT_TRUE(visitor.choose("Find the thing under my hand")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("The main thing of the photograph")) << visitor.heard();
    EXPECT_GT(world.servo().felt_count, felt);
    ASSERT_TRUE(visitor.choose("How much of the photo")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("The whole photograph")) << visitor.heard();
    EXPECT_EQ(*looks, 3);
}

}  // namespace
}  // namespace touchline
