#include "vision/prepare/document.h"

#include "tests/vision/prepare/page_photos.h"
#include "vision/prepare/quad.h"

#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

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
