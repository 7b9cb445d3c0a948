#include "app/documents/sticks/stick_port.h"
#include "tests/app/documents/sticks/stick_folder.h"

#include <typeinfo>

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

class FolderPortTest : public testing::Test {
  protected:
    /// Polls half a second later.
    std::vector<StickEvent> poll() {
        now_ns += 500'000'000;
        return port->poll(now_ns);
    }

    StickFolder stick;
    std::string root = stick.root() + "/in";
    std::unique_ptr<StickPort> port = open_stick_port(root);
    std::int64_t now_ns = 0;
};

using Events = std::vector<StickEvent>;

TEST_F(FolderPortTest, SomethingInItIsAStick) {
    EXPECT_TRUE(poll().empty());
    EXPECT_FALSE(port->is_watching());
    stick.folder("in");
    EXPECT_TRUE(poll().empty());
    EXPECT_TRUE(port->is_watching());
    stick.file("in/boat.png");
    EXPECT_EQ(poll(), (Events{{StickNews::ready, root, ""}}));
    EXPECT_TRUE(poll().empty());
    fs::remove(stick.path() / "in/boat.png");
    EXPECT_EQ(poll(), (Events{{StickNews::gone, root, ""}}));
    fs::remove(stick.path() / "in");
    EXPECT_TRUE(poll().empty());
    EXPECT_FALSE(port->is_watching());
}

TEST_F(FolderPortTest, AnotherFolderInItsPlaceIsAnotherStick) {
    stick.folder("in");
    stick.file("in/boat.png");
    EXPECT_EQ(poll().size(), 1U);
    fs::rename(stick.path() / "in", stick.path() / "out");
    stick.folder("in");
    stick.file("in/dog.png");
    EXPECT_EQ(poll(), (Events{{StickNews::gone, root, ""}, {StickNews::ready, root, ""}}));
}

TEST_F(FolderPortTest, AChangeOfItsFilesIsTold) {
    stick.folder("in");
    stick.file("in/boat.png");
    EXPECT_EQ(poll().size(), 1U);
    fs::last_write_time(stick.path() / "in", fs::file_time_type());
    EXPECT_EQ(poll().size(), 2U);
    EXPECT_TRUE(poll().empty());
}

TEST_F(FolderPortTest, ItIsLookedAtTwiceASecond) {
    stick.folder("in");
    EXPECT_TRUE(port->poll(0).empty());
    stick.file("in/boat.png");
    EXPECT_TRUE(port->poll(499'999'999).empty());
    EXPECT_EQ(port->poll(500'000'000).size(), 1U);
}

TEST_F(FolderPortTest, AFileOfItsNameIsNoStick) {
    stick.file("in");
    EXPECT_TRUE(poll().empty());
    EXPECT_FALSE(port->is_watching());
}

TEST(OpenStickPort, TheSettingsDecide) {
    const auto of_folder = open_stick_port("/srv");
    const auto of_udisks = open_stick_port("");
    const StickPort& one = *of_folder;
    const StickPort& other = *of_udisks;
    EXPECT_NE(typeid(one), typeid(other));
}

}  // namespace
}  // namespace touchline
