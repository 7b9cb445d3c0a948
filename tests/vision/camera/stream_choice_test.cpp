#include "vision/camera/stream_camera.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

using enum PixelFormat;

TEST(StreamChoice, PreviewIsTheSmallestThatIsEnoughAndCheapest) {
    const CameraAbilities abilities{{{mjpeg, {4000, 3000}},
                                     {mjpeg, {640, 480}},
                                     {yuyv, {640, 480}},
                                     {yuyv, {1280, 720}},
                                     {yuyv, {320, 240}}},
                                    false,
                                    false,
                                    false};
    EXPECT_EQ(preview_mode(abilities), (StreamMode{yuyv, {640, 480}}));
    EXPECT_EQ(still_mode(abilities), (StreamMode{mjpeg, {4000, 3000}}));
}

TEST(StreamChoice, WhereNoneIsEnoughTheLargestIsThePreview) {
    const CameraAbilities abilities{
        {{yuyv, {160, 120}}, {mjpeg, {352, 288}}, {yuyv, {352, 288}}}, false, false, false};
    EXPECT_EQ(preview_mode(abilities), (StreamMode{yuyv, {352, 288}}));
}

TEST(StreamChoice, NothingFromNothing) {
    EXPECT_FALSE(preview_mode({}));
    EXPECT_FALSE(still_mode({}));
}

}  // namespace
}  // namespace touchline
