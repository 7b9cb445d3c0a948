#include "vision/prepare/stand.h"

#include "tests/vision/prepare/page_photos.h"
#include "vision/prepare/fiducials.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double bed_width_mm = 320.0;
constexpr double bed_height_mm = 230.0;
constexpr int px_per_mm = 3;
constexpr int mark_mm = 24;
constexpr int margin_mm = 40;  // round the bed: the marks lie in it

struct StandPhoto {
    cv::Mat bgr;
    Quad bed;
};

/// The bed with a disc on it, marks at its corners, seen by a camera that is not quite above it.
/// `hidden`: a mark that something lies on.
StandPhoto stand_photo(unsigned seed, double shade, int hidden = -1) {
    std::mt19937 random(seed);
    const auto between = [&](double least, double most) {
        return least + (most - least) * static_cast<double>(random()) / 4294967295.0;
    };
    const cv::Size plate((static_cast<int>(bed_width_mm) + 2 * margin_mm) * px_per_mm,
                         (static_cast<int>(bed_height_mm) + 2 * margin_mm) * px_per_mm);
    cv::Mat flat(plate, CV_8UC3, cv::Scalar(215, 220, 222));
    const cv::Rect bed(margin_mm * px_per_mm, margin_mm * px_per_mm,
                       static_cast<int>(bed_width_mm) * px_per_mm,
                       static_cast<int>(bed_height_mm) * px_per_mm);
    cv::circle(flat, (bed.tl() + bed.br()) / 2, 80 * px_per_mm, {160, 60, 40}, cv::FILLED);
    const int side_px = mark_mm * px_per_mm;
    const cv::Point corners[4] = {
        bed.tl(), {bed.x + bed.width, bed.y}, bed.br(), {bed.x, bed.y + bed.height}};
    for (int id = 0; id < fiducial_count; ++id) {
        if (id == hidden) continue;
        cv::Mat mark;
        cv::cvtColor(fiducial_drawing(id, side_px / 6), mark, cv::COLOR_GRAY2BGR);
        const bool is_left = id == 0 || id == 3;
        const bool is_up = id < 2;
        mark.copyTo(flat(cv::Rect(corners[id].x - (is_left ? side_px : 0),
                                  corners[id].y - (is_up ? side_px : 0), side_px, side_px)));
    }
    const cv::Size size(1600, 1200);
    const auto w = static_cast<double>(size.width);
    const auto h = static_cast<double>(size.height);
    std::vector<cv::Point2f> to;
    for (const cv::Point2d p : {cv::Point2d(0.1, 0.1), {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9}})
        to.emplace_back(
            cv::Point2d((p.x + between(-0.06, 0.06)) * w, (p.y + between(-0.06, 0.06)) * h));
    const auto right = static_cast<float>(plate.width) - 0.5F;
    const auto bottom = static_cast<float>(plate.height) - 0.5F;
    const std::vector<cv::Point2f> from{
        {-0.5F, -0.5F}, {right, -0.5F}, {right, bottom}, {-0.5F, bottom}};
    const cv::Matx33d transform = cv::getPerspectiveTransform(from, to);
    StandPhoto photo{cv::Mat(size, CV_8UC3, cv::Scalar::all(70)), {}};
    cv::warpPerspective(flat, photo.bgr, transform, size, cv::INTER_AREA, cv::BORDER_TRANSPARENT);
    for (std::size_t i = 0; i < 4; ++i) {
        const cv::Vec3d p = transform * cv::Vec3d(corners[i].x - 0.5, corners[i].y - 0.5, 1.0);
        photo.bed[i] = {p[0] / p[2], p[1] / p[2]};
    }
    cv::GaussianBlur(photo.bgr, photo.bgr, {}, 1.0);
    testing::add_shade(photo.bgr, shade, between(0.0, 6.28));
    cv::Mat noise(size, CV_16SC3);
    cv::RNG(seed + 1).fill(noise, cv::RNG::NORMAL, 0.0, 4.0);
    cv::add(photo.bgr, noise, photo.bgr, cv::noArray(), CV_8U);
    return photo;
}

TEST(StandTest, TheBedIsWhereItsMarksSay) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const StandPhoto photo = stand_photo(seed, 0.05 * seed);
        const auto stand = calibrated_stand(photo.bgr, {bed_width_mm, bed_height_mm});
        ASSERT_TRUE(stand) << seed << ": " << stand.error().line;
        for (std::size_t i = 0; i < 4; ++i) {
            const cv::Point2d found(stand->bed_corners_px[2 * i], stand->bed_corners_px[2 * i + 1]);
            EXPECT_LT(cv::norm(found - photo.bed[i]), 1.0) << "seed " << seed << " corner " << i;
        }
    }
}

TEST(StandTest, TheBedComesUprightAtAnotherSizeToo) {
    const StandPhoto photo = stand_photo(3, 0.0);
    const auto stand = calibrated_stand(photo.bgr, {bed_width_mm, bed_height_mm});
    ASSERT_TRUE(stand);
    cv::Mat half;
    cv::resize(photo.bgr, half, {}, 0.5, 0.5, cv::INTER_AREA);
    for (const cv::Mat& picture : {photo.bgr, half}) {
        const cv::Mat bed = bed_picture(picture, *stand);
        EXPECT_NEAR(static_cast<double>(bed.cols) / bed.rows, bed_width_mm / bed_height_mm, 0.01);
        // The disc is round again, in the middle, and as large as it is.
        cv::Mat1b is_disc;
        cv::inRange(bed, cv::Scalar(120, 30, 10), cv::Scalar(200, 110, 90), is_disc);
        const cv::Rect box = cv::boundingRect(is_disc);
        const double px_per = bed.cols / bed_width_mm;
        EXPECT_NEAR(box.width / px_per, 160.0, 2.0);
        EXPECT_NEAR(box.height / px_per, 160.0, 2.0);
        EXPECT_NEAR((box.x + box.width / 2.0) / px_per, bed_width_mm / 2, 1.0);
        EXPECT_NEAR((box.y + box.height / 2.0) / px_per, bed_height_mm / 2, 1.0);
    }
}

TEST(StandTest, AHiddenMarkIsSaid) {
    for (int hidden = 0; hidden < fiducial_count; ++hidden) {
        const auto stand =
            calibrated_stand(stand_photo(5, 0.2, hidden).bgr, {bed_width_mm, bed_height_mm});
        ASSERT_FALSE(stand);
        EXPECT_EQ(stand.error().line,
                  "The corners of the tray are covered. Clear them and try again.");
    }
}

TEST(StandTest, NothingElseIsTakenForAMark) {
    int found = 0;
    for (unsigned seed = 0; seed < 40; ++seed)
        found += static_cast<int>(find_fiducials(testing::pageless_photo(seed)).size());
    EXPECT_EQ(found, 0);
}

TEST(StandTest, AMarkIsKnownHoweverItIsTurned) {
    for (int id = 0; id < fiducial_count; ++id) {
        cv::Mat picture(400, 400, CV_8UC3, cv::Scalar::all(225));
        cv::Mat mark;
        cv::cvtColor(fiducial_drawing(id, 20), mark, cv::COLOR_GRAY2BGR);
        mark.copyTo(picture(cv::Rect(100, 150, 120, 120)));
        cv::Point2d upper_left(99.5, 149.5);
        for (int quarter = 0; quarter < 4; ++quarter) {
            const auto found = find_fiducials(picture);
            ASSERT_EQ(found.size(), 1U);
            EXPECT_EQ(found[0].id, id);
            EXPECT_LT(cv::norm(found[0].corners[0] - upper_left), 1.0) << quarter;
            cv::rotate(picture, picture, cv::ROTATE_90_CLOCKWISE);
            upper_left = {399.0 - upper_left.y, upper_left.x};
        }
    }
}

}  // namespace
}  // namespace touchline
