#include "vision/camera/folder_camera.h"

#include "app/documents/decode/picture.h"
#include "tests/vision/camera/frames.h"

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

const cv::Size picture_size(800, 600);

Result<cv::Mat> read_file(const fs::path& file) {
    const auto picture = read_picture(file.string());
    if (!picture) return tl::unexpected(picture.error());
    cv::Mat pixels(picture->height, picture->width, CV_8UC3);
    std::copy(picture->bgr.begin(), picture->bgr.end(), pixels.data);
    return pixels;
}

class FolderCameraTest : public ::testing::Test {
  protected:
    FolderCameraTest()
        : folder_(fs::path(::testing::TempDir()) /
                  ("touchline-camera-" + std::to_string(::getpid()))) {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }

    ~FolderCameraTest() override { fs::remove_all(folder_); }

    void save(const std::string& name, const cv::Scalar& colour) const {
        cv::Mat pixels = testing::scene(picture_size);
        pixels.rowRange(0, 60).setTo(colour);
        Picture picture{picture_size.width,
                        picture_size.height,
                        {pixels.data, pixels.data + 3 * pixels.total()}};
        ASSERT_TRUE(write_png((folder_ / name).string(), picture));
    }

    static cv::Scalar colour_of(const CameraFrame& frame) {
        const cv::Mat pixels = to_bgr(frame, frame.size).value();
        return cv::Scalar(pixels.at<cv::Vec3b>(0, 0));
    }

    fs::path folder_;
};

const cv::Scalar first{10, 20, 30};
const cv::Scalar second{40, 50, 60};

TEST_F(FolderCameraTest, PicturesComeByNameOneAStill) {
    save("2.png", second);
    save("1.png", first);
    FolderCamera camera(folder_, read_file);
    EXPECT_EQ(camera.list().size(), 1U);
    const CameraView view = camera.step(0.0);
    EXPECT_EQ(view.condition, CameraCondition::ready);
    ASSERT_TRUE(view.preview);
    EXPECT_EQ(view.preview->size(), cv::Size(640, 480));
    for (const cv::Scalar& expected : {first, second, first}) {
        camera.want_still();
        const CameraView taken = camera.step(0.1);
        ASSERT_TRUE(taken.still);
        EXPECT_EQ(taken.still->frame.size, picture_size);
        EXPECT_EQ(colour_of(taken.still->frame), expected);
        EXPECT_TRUE(camera.step(0.2).preview);
        EXPECT_FALSE(camera.step(0.3).preview);
    }
}

TEST_F(FolderCameraTest, AnEmptyOrMissingFolderIsNoCamera) {
    for (const fs::path& folder : {folder_, folder_ / "none"}) {
        FolderCamera camera(folder, read_file);
        EXPECT_TRUE(camera.list().empty());
        camera.want_still();
        const CameraView view = camera.step(0.0);
        EXPECT_EQ(view.condition, CameraCondition::absent);
        EXPECT_TRUE(view.has_given_up);
        EXPECT_FALSE(view.still);
    }
}

TEST_F(FolderCameraTest, FilesThatAreNoPicturesArePassedOver) {
    std::ofstream(folder_ / "0.txt") << "words";
    save("1.png", first);
    FolderCamera camera(folder_, read_file);
    (void)camera.step(0.0);
    for (int i = 0; i < 3; ++i) {
        camera.want_still();
        const CameraView view = camera.step(0.1);
        ASSERT_TRUE(view.still);
        EXPECT_EQ(colour_of(view.still->frame), first);
    }
    fs::remove(folder_ / "1.png");
    (void)camera.step(2.0);
    EXPECT_EQ(camera.step(2.1).condition, CameraCondition::absent);
}

TEST_F(FolderCameraTest, PluggedInAndOutByFilling) {
    FolderCamera camera(folder_, read_file);
    EXPECT_EQ(camera.step(0.0).condition, CameraCondition::absent);
    save("1.png", first);
    EXPECT_EQ(camera.step(1.5).condition, CameraCondition::ready);
    fs::remove_all(folder_);
    EXPECT_EQ(camera.step(3.0).condition, CameraCondition::absent);
}

TEST_F(FolderCameraTest, NotChosenIsAbsent) {
    save("1.png", first);
    FolderCamera camera(folder_, read_file);
    camera.choose("another");
    EXPECT_EQ(camera.step(0.0).condition, CameraCondition::absent);
    camera.choose(camera.list().front().id);
    EXPECT_EQ(camera.step(0.1).condition, CameraCondition::ready);
}

}  // namespace
}  // namespace touchline
