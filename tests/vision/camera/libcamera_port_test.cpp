// libcamera itself, on a machine with or without a camera: it starts, lists, and refuses cameras
// that do not exist. tests/machines/system/camera runs it with a camera.
#include "vision/camera/libcamera_port.h"

#include <filesystem>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(LibcameraPortTest, StartsListsAndRefusesWhatIsNotThere) {
    const auto port = LibcameraPort::create();
    ASSERT_TRUE(port) << port.error().line;
    if (!std::filesystem::exists("/dev/video0") && !std::filesystem::exists("/dev/media0")) {
        EXPECT_TRUE((*port)->list().empty());
    }
    for (const CameraName& camera : (*port)->list()) EXPECT_FALSE(camera.id.empty());
    EXPECT_FALSE((*port)->open("no such camera"));
    EXPECT_FALSE((*port)->start({}));
    EXPECT_FALSE((*port)->take());
    (*port)->order(LoopOrder::lock_exposure);
    (*port)->request_still();
    (*port)->close();
}

}  // namespace
}  // namespace touchline
