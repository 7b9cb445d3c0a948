#include "vision/prepare/quad.h"

#include "vision/prepare/document.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

const cv::Size photo_size(1600, 1200);

/// The corners in the picture of a sheet of this aspect before a pinhole camera, leaned about x and
/// y.
Quad seen(double aspect, double lean_x_rad, double lean_y_rad, double focal_px) {
    const double cx = std::cos(lean_x_rad), sx = std::sin(lean_x_rad);
    const double cy = std::cos(lean_y_rad), sy = std::sin(lean_y_rad);
    const cv::Matx33d turn =
        cv::Matx33d(1, 0, 0, 0, cx, -sx, 0, sx, cx) * cv::Matx33d(cy, 0, sy, 0, 1, 0, -sy, 0, cy);
    Quad corners;
    for (std::size_t i = 0; i < 4; ++i) {
        const double u = i == 1 || i == 2 ? 0.5 : -0.5;
        const double v = i >= 2 ? 0.5 : -0.5;
        const cv::Vec3d p = turn * cv::Vec3d(u * aspect, v, 0.0) + cv::Vec3d(0.0, 0.0, 2.2);
        corners[i] = {(photo_size.width - 1) / 2.0 + focal_px * p[0] / p[2],
                      (photo_size.height - 1) / 2.0 + focal_px * p[1] / p[2]};
    }
    return corners;
}

TEST(Rectify, TheAspectIsThatOfTheSheetWhateverTheLean) {
    for (const double aspect : {1.0 / a4_aspect, 1.0 / letter_aspect, 1.0, a4_aspect})
        for (const double lean_x : {-0.5, -0.25, 0.0, 0.25, 0.5})
            for (const double lean_y : {-0.4, -0.1, 0.0, 0.3}) {
                const double focal_px = usual_focal_share * photo_size.width;
                EXPECT_NEAR(aspect_of(seen(aspect, lean_x, lean_y, focal_px), photo_size) / aspect,
                            1.0, 0.005);
            }
}

TEST(Rectify, AnotherLensIsTakenFromThePerspective) {
    for (const double focal_px : {0.7 * photo_size.width, 1.6 * photo_size.width}) {
        const double aspect = 1.0 / a4_aspect;
        EXPECT_NEAR(aspect_of(seen(aspect, 0.45, 0.35, focal_px), photo_size) / aspect, 1.0, 0.005);
        // Too little lean to tell the lens, so the lens does not matter much.
        EXPECT_NEAR(aspect_of(seen(aspect, 0.12, 0.0, focal_px), photo_size) / aspect, 1.0, 0.01);
    }
}

TEST(Rectify, SnapsToA4AndLetterWithinThreePerCent) {
    EXPECT_DOUBLE_EQ(snapped_aspect(1.029 / a4_aspect), 1.0 / a4_aspect);
    EXPECT_DOUBLE_EQ(snapped_aspect(0.975 * a4_aspect), a4_aspect);
    EXPECT_DOUBLE_EQ(snapped_aspect(1.02 * letter_aspect), letter_aspect);
    EXPECT_DOUBLE_EQ(snapped_aspect(1.0), 1.0);
    EXPECT_DOUBLE_EQ(snapped_aspect(1.04 * a4_aspect), 1.04 * a4_aspect);
}

/// A checked sheet, seen aslant, comes back as it was, at every size up to the limit.
TEST(Rectify, ThePageIsSeenFromAbove) {
    cv::Mat sheet(848, 600, CV_8UC3, cv::Scalar::all(235));
    for (int y = 40; y < 800; y += 80)
        for (int x = 40; x < 560; x += 80)
            cv::rectangle(sheet, {x, y, 40, 40}, cv::Scalar(x / 4, 60, y / 5), cv::FILLED);
    const Quad corners = seen(600.0 / 848, 0.4, -0.3, 1500.0);
    cv::Mat photo(photo_size, CV_8UC3, cv::Scalar::all(60));
    const std::vector<cv::Point2f> from{
        {-0.5F, -0.5F}, {599.5F, -0.5F}, {599.5F, 847.5F}, {-0.5F, 847.5F}};
    cv::warpPerspective(
        sheet, photo,
        cv::getPerspectiveTransform(from, std::vector<cv::Point2f>(corners.begin(), corners.end())),
        photo_size, cv::INTER_AREA, cv::BORDER_TRANSPARENT);
    for (const double most : {1e6, 1e5}) {
        const cv::Mat page = rectified(photo, corners, 600.0 / 848, most);
        EXPECT_LE(page.total(), most);
        EXPECT_GT(static_cast<double>(page.total()), 0.9 * std::min(most, area_of(corners)));
        cv::Mat truth;
        cv::resize(sheet, truth, page.size(), 0, 0, cv::INTER_AREA);
        EXPECT_LT(cv::norm(page, truth, cv::NORM_L1) / static_cast<double>(3 * page.total()), 4.0);
    }
}

TEST(CaptureTroubleTest, SpokenSentencesAreShortAndNameNoColours) {
    for (int i = 0; i <= static_cast<int>(CaptureTrouble::too_far_down); ++i) {
        const std::string_view words = sentence(static_cast<CaptureTrouble>(i));
        EXPECT_EQ(words.empty(), i == 0);
        EXPECT_LE(std::count(words.begin(), words.end(), ' ') + 1, 15);
        for (const std::string_view banned : {"white", "black", "red", "green", "see", "look"})
            EXPECT_EQ((" " + std::string(words)).find(" " + std::string(banned)), std::string::npos)
                << words;
    }
}

}  // namespace
}  // namespace touchline
