#include "vision/prepare/document.h"

#include "tests/vision/prepare/page_photos.h"
#include "vision/prepare/quad.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using testing::Hardship;
using testing::page_photo;
using testing::PagePhoto;

/// A five-hundredth of the picture's diagonal at 800 x 600.
constexpr double tolerance_px = 2.0;

double worst_corner_px(const Quad& found, const Quad& truth) {
    double worst = 0.0;
    for (std::size_t i = 0; i < 4; ++i) worst = std::max(worst, cv::norm(found[i] - truth[i]));
    return worst;
}

/// Tries the seeds first ... first + count - 1. Returns how many pages were found, and expects
/// these in their true places.
int found_of(int count, unsigned first, const Hardship& hardship) {
    int found = 0;
    for (unsigned seed = first; seed < first + static_cast<unsigned>(count); ++seed) {
        const PagePhoto photo = page_photo(seed, hardship);
        const PageSearch search = find_page(photo.bgr);
        EXPECT_EQ(search.corners.has_value(), search.trouble == CaptureTrouble::none);
        if (!search.corners) continue;
        ++found;
        EXPECT_LT(worst_corner_px(*search.corners, photo.corners), tolerance_px) << "seed " << seed;
    }
    return found;
}

TEST(PageSearchTest, APlainTable) {
    EXPECT_EQ(found_of(30, 100, {}), 30);
}

TEST(PageSearchTest, AnEmptyPage) {
    Hardship hardship;
    hardship.has_content = false;
    EXPECT_EQ(found_of(10, 200, hardship), 10);
}

TEST(PageSearchTest, TiltedAndTurned) {
    Hardship hardship;
    hardship.tilt = 0.4;
    hardship.turn_deg = 40.0;
    EXPECT_GE(found_of(50, 300, hardship), 49);
}

TEST(PageSearchTest, Shaded) {
    Hardship hardship;
    hardship.shade = 0.6;
    hardship.desk_level = 110.0;
    EXPECT_GE(found_of(50, 400, hardship), 50);
}

TEST(PageSearchTest, Cluttered) {
    Hardship hardship;
    hardship.clutter = 1.0;
    hardship.shade = 0.3;
    EXPECT_GE(found_of(40, 500, hardship), 39);
}

TEST(PageSearchTest, NoisyBlurredAndOnABrightTable) {
    Hardship hardship;
    hardship.noise_levels = 8.0;
    hardship.blur_px = 1.5;
    hardship.desk_level = 170.0;
    EXPECT_GE(found_of(30, 600, hardship), 29);
}

TEST(PageSearchTest, NoPageIsNeverTakenForOne) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        const PageSearch search = find_page(testing::pageless_photo(seed));
        EXPECT_FALSE(search.corners) << "seed " << seed;
        EXPECT_NE(search.trouble, CaptureTrouble::none);
    }
}

/// Says where corners are far enough outside to be cut off without doubt, and on one side only.
std::optional<CaptureTrouble> cut_off(const Quad& corners) {
    constexpr double sure_px = 12.0;
    double least_x = 0.0, most_x = 0.0, least_y = 0.0, most_y = 0.0;
    for (const cv::Point2d corner : corners) {
        least_x = std::min(least_x, corner.x);
        most_x = std::max(most_x, corner.x - 799.0);
        least_y = std::min(least_y, corner.y);
        most_y = std::max(most_y, corner.y - 599.0);
    }
    if (-least_x > sure_px && -least_y + most_y == 0.0) return CaptureTrouble::too_far_left;
    if (most_x > sure_px && -least_y + most_y == 0.0) return CaptureTrouble::too_far_right;
    if (-least_y > sure_px && -least_x + most_x == 0.0) return CaptureTrouble::too_far_up;
    if (most_y > sure_px && -least_x + most_x == 0.0) return CaptureTrouble::too_far_down;
    return std::nullopt;
}

TEST(PageSearchTest, ACornerOutsideIsToldByDirection) {
    int cases = 0;
    int told = 0;
    for (unsigned seed = 700; seed < 745; ++seed) {
        const std::array<cv::Point2d, 4> shifts{
            {{-0.8, 0.0}, {0.8, 0.0}, {0.0, -0.45}, {0.0, 0.45}}};
        Hardship hardship;
        hardship.page_share = 0.75;
        hardship.turn_deg = 6.0;
        hardship.shift = shifts[seed % 4];
        const PagePhoto photo = page_photo(seed, hardship);
        const auto expected = cut_off(photo.corners);
        if (!expected) continue;
        ++cases;
        const PageSearch search = find_page(photo.bgr);
        EXPECT_FALSE(search.corners) << "seed " << seed;
        told += search.trouble == *expected ? 1 : 0;
    }
    EXPECT_GE(cases, 25);
    EXPECT_GE(told, cases * 9 / 10);
}

TEST(PageSearchTest, TooDarkIsTold) {
    for (unsigned seed = 800; seed < 805; ++seed) {
        cv::Mat dark = page_photo(seed, {}).bgr * 0.12;
        EXPECT_EQ(find_page(dark).trouble, CaptureTrouble::too_dark);
    }
}

TEST(PageSearchTest, TooSmallIsTold) {
    Hardship hardship;
    hardship.page_share = 0.25;
    for (unsigned seed = 820; seed < 825; ++seed)
        EXPECT_EQ(find_page(page_photo(seed, hardship).bgr).trouble, CaptureTrouble::too_small);
}

TEST(PageSearchTest, GlareIsTold) {
    for (unsigned seed = 840; seed < 845; ++seed) {
        Hardship hardship;
        hardship.shade = 0.2;
        hardship.page_share = 0.7;
        PagePhoto photo = page_photo(seed, hardship);
        photo.bgr *= 0.8;
        const cv::Point2d middle =
            (photo.corners[0] + photo.corners[1] + photo.corners[2] + photo.corners[3]) / 4.0;
        testing::add_glare(photo.bgr, middle, 60.0);
        EXPECT_EQ(find_page(photo.bgr).trouble, CaptureTrouble::glare) << "seed " << seed;
    }
}

TEST(PageSearchTest, TooBrightIsTold) {
    const cv::Mat flooded(600, 800, CV_8UC3, cv::Scalar::all(255));
    EXPECT_EQ(find_page(flooded).trouble, CaptureTrouble::too_bright);
}

TEST(PageSearchTest, OddPicturesAreNoPage) {
    for (const cv::Size size : {cv::Size(64, 64), cv::Size(64, 4000), cv::Size(4000, 64)}) {
        const cv::Mat plain(size, CV_8UC3, cv::Scalar::all(128));
        EXPECT_EQ(find_page(plain).trouble, CaptureTrouble::no_page);
    }
}

/// A shaded page comes out upright, evenly lit and with the aspect of its quad.
TEST(DocumentTest, APhotoBecomesThePage) {
    testing::Hardship hardship;
    hardship.shade = 0.4;
    hardship.desk_level = 60.0;
    hardship.has_content = false;
    for (unsigned seed = 900; seed < 908; ++seed) {
        const testing::PagePhoto photo = testing::page_photo(seed, hardship);
        const Document document = document_in(photo.bgr);
        ASSERT_EQ(document.trouble, CaptureTrouble::none) << seed;
        ASSERT_FALSE(document.page.empty());
        EXPECT_LE(document.page.total(), 1'000'000U);
        const double aspect = static_cast<double>(document.page.cols) / document.page.rows;
        EXPECT_NEAR(aspect / snapped_aspect(aspect_of(photo.corners, photo.bgr.size())), 1.0, 0.03);
        cv::Scalar mean;
        cv::Scalar deviation;
        cv::meanStdDev(document.page, mean, deviation);
        EXPECT_NEAR(mean[1], 235.0, 4.0);
        EXPECT_LT(deviation[1], 8.0);
    }
}

TEST(DocumentTest, TroubleComesWithoutAPage) {
    const Document document = document_in(testing::pageless_photo(3));
    EXPECT_TRUE(document.page.empty());
    EXPECT_NE(document.trouble, CaptureTrouble::none);
}

}  // namespace
}  // namespace touchline
