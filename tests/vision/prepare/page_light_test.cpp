#include "vision/prepare/page_light.h"

#include "tests/vision/prepare/page_photos.h"
#include "vision/prepare/paper.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

const cv::Size page_size(600, 848);

/// Returns the dark pixels of an evenly lit page, by the one threshold that fits all of it.
cv::Mat1b ink_of(const cv::Mat& bgr) {
    cv::Mat1b grey;
    cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
    cv::Mat ink;
    cv::threshold(grey, ink, 0, 255, cv::THRESH_BINARY_INV | cv::THRESH_OTSU);
    return ink;
}

/// Returns the share of the outline pixels of `ink` that have none of `other` within two pixels.
double lost(const cv::Mat1b& ink, const cv::Mat1b& other) {
    const auto outline = [](const cv::Mat1b& mask) {
        cv::Mat inner;
        cv::erode(mask, inner, {});
        return cv::Mat1b(cv::Mat(mask - inner));
    };
    cv::Mat near;
    cv::dilate(outline(other), near, cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
    const cv::Mat1b truth = outline(ink);
    return static_cast<double>(cv::countNonZero(truth & ~near)) / cv::countNonZero(truth);
}

cv::Mat shaded(const cv::Mat& page, double shade, double angle_rad, int seed) {
    cv::Mat photo = page.clone();
    testing::add_shade(photo, shade, angle_rad);
    cv::GaussianBlur(photo, photo, {}, 0.8);
    cv::Mat noise(page.size(), CV_16SC3);
    cv::RNG(static_cast<std::uint64_t>(seed)).fill(noise, cv::RNG::NORMAL, 0.0, 3.0);
    cv::add(photo, noise, photo, cv::noArray(), CV_8U);
    return photo;
}

cv::Mat letters_page() {
    cv::Mat page(page_size, CV_8UC3, cv::Scalar(230, 236, 238));
    for (int line = 0; line < 6; ++line)
        cv::putText(page, "Agxe R8s", {30, 120 + 130 * line}, cv::FONT_HERSHEY_DUPLEX, 3.4,
                    cv::Scalar::all(35), 9, cv::LINE_AA);
    return page;
}

TEST(EvenLight, NoOutlineIsLostInAShadeOfSixtyPerCent) {
    const cv::Mat page = letters_page();
    const cv::Mat1b truth = ink_of(page);
    double without = 0.0;
    for (int i = 0; i < 12; ++i) {
        const cv::Mat photo = shaded(page, 0.6, CV_PI * i / 6, i);
        const cv::Mat1b ink = ink_of(evenly_lit(photo));
        EXPECT_LE(lost(truth, ink), 0.01) << i;
        EXPECT_LE(lost(ink, truth), 0.01) << i;
        without = std::max(without, lost(ink_of(photo), truth));
    }
    EXPECT_GT(without, 0.05);  // otherwise the shade did no harm to begin with
}

/// A filled shape keeps its area and its darkness, up to half of the page.
TEST(EvenLight, LargeFilledShapesAreNotTakenForShade) {
    for (const double share : {0.1, 0.25, 0.4, 0.5}) {
        for (const bool is_round : {true, false}) {
            cv::Mat page(page_size, CV_8UC3, cv::Scalar::all(236));
            const double area = share * page_size.area();
            const cv::Point middle(page_size.width / 2, page_size.height / 2);
            if (is_round) {
                const int radius = static_cast<int>(std::sqrt(area / CV_PI));
                cv::ellipse(
                    page, middle,
                    {std::min(radius, 290), static_cast<int>(area / CV_PI / std::min(radius, 290))},
                    0, 0, 360, cv::Scalar(60, 50, 45), cv::FILLED);
            } else {
                const int width = static_cast<int>(600 * std::sqrt(share));
                const int height = static_cast<int>(848 * std::sqrt(share));
                cv::rectangle(page, {middle.x - width / 2, middle.y - height / 2, width, height},
                              cv::Scalar(60, 50, 45), cv::FILLED);
            }
            const cv::Mat1b truth = ink_of(page);
            for (int i = 0; i < 4; ++i) {
                const cv::Mat even = evenly_lit(shaded(page, 0.4, CV_PI * i / 2, i));
                const cv::Mat1b ink = ink_of(even);
                EXPECT_LE(lost(truth, ink), 0.01) << share << ' ' << is_round << ' ' << i;
                EXPECT_NEAR(cv::countNonZero(ink), cv::countNonZero(truth),
                            0.01 * page_size.area());
                EXPECT_LT(cv::mean(even, truth)[2], 90.0);
                EXPECT_NEAR(cv::mean(even, ~truth)[2], 235.0, 6.0);
            }
        }
    }
}

TEST(EvenLight, AnEvenPageStaysAsItIs) {
    const cv::Mat page = letters_page();
    const cv::Mat even = evenly_lit(page);
    EXPECT_LT(cv::norm(even, page, cv::NORM_L1) / static_cast<double>(3 * page.total()), 6.0);
}

TEST(EvenLight, OfPaperWithoutLightNothingIsDividedOut) {
    LabPicture lab(20, 20, cv::Vec3f(-100.0F, 0.0F, 0.0F));  // surfaces may be so far off
    lab(3, 4) = {7.0F, 5.0F, -5.0F};
    const LabPicture lit = evenly_lit(lab, Paper(lab));
    EXPECT_EQ(cv::norm(lit, lab, cv::NORM_INF), 0.0);
}

}  // namespace
}  // namespace touchline
