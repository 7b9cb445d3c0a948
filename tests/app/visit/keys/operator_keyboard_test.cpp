// Tests reading an input device byte for byte; a FIFO stands for the device.
#include "app/visit/keys/operator_keyboard.h"

#include <filesystem>
#include <string>
#include <utility>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/input.h>
#include <sys/stat.h>
#include <unistd.h>

namespace touchline {
namespace {

class OperatorKeyboardTest : public testing::Test {
  protected:
    OperatorKeyboardTest() { mkfifo(path_.c_str(), 0600); }

    ~OperatorKeyboardTest() override {
        if (device_ >= 0) close(device_);
        std::filesystem::remove(path_);
    }

    void plug_in() { device_ = open(path_.c_str(), O_RDWR | O_CLOEXEC); }

    void give(std::uint16_t type, std::uint16_t code, std::int32_t value) const {
        input_event event{};
        event.type = type;
        event.code = code;
        event.value = value;
        ASSERT_EQ(write(device_, &event, sizeof event), ssize_t{sizeof event});
    }

    std::string path_ = std::filesystem::path(testing::TempDir()) /
                        ("keyboard-" + std::to_string(getpid()) + "-" +
                         testing::UnitTest::GetInstance()->current_test_info()->name());
    int device_ = -1;
};

TEST_F(OperatorKeyboardTest, TellsPressesWithoutRepeatsAndReleases) {
    plug_in();
    OperatorKeyboard keyboard(path_);
    EXPECT_EQ(keyboard.problem(), "");
    EXPECT_TRUE(keyboard.take_presses().empty());
    give(EV_KEY, KEY_UP, 1);
    give(EV_SYN, 0, 0);
    give(EV_KEY, KEY_UP, 2);
    give(EV_KEY, KEY_UP, 0);
    give(EV_KEY, KEY_F24, 1);
    const auto presses = keyboard.take_presses();
    ASSERT_EQ(presses.size(), 2U);
    EXPECT_EQ(name_of(presses[0]), "up");
    EXPECT_EQ(name_of(presses[1]), "F24");
    EXPECT_TRUE(keyboard.take_presses().empty());
}

TEST_F(OperatorKeyboardTest, EveryRoleOfTheShippedKeysCanBeReached) {
    const KeyTable table = default_keys();
    std::array<bool, key_role_count> reached{};
    for (int code = 1; code < KEY_CNT; ++code) {
        const auto role = role_of(table, key_of_code(static_cast<std::uint16_t>(code)));
        if (role) reached.at(static_cast<std::size_t>(*role)) = true;
    }
    for (const bool is_reached : reached) EXPECT_TRUE(is_reached);
    EXPECT_EQ(key_of_code(KEY_VOLUMEUP).source, KeySource::scancode);
    EXPECT_EQ(role_of(table, key_of_code(KEY_VOLUMEUP)), KeyRole::louder);
}

TEST_F(OperatorKeyboardTest, OneThatIsNotThereIsOneLineAndIsLookedForAgain) {
    std::filesystem::remove(path_);
    OperatorKeyboard keyboard(path_);
    EXPECT_NE(keyboard.problem().find(path_), std::string::npos);
    EXPECT_TRUE(keyboard.take_presses().empty());
    mkfifo(path_.c_str(), 0600);
    plug_in();
    for (int i = 0; i < 100; ++i) (void)keyboard.take_presses();
    EXPECT_EQ(keyboard.problem(), "");
    give(EV_KEY, KEY_ENTER, 1);
    EXPECT_EQ(keyboard.take_presses().size(), 1U);
}

TEST_F(OperatorKeyboardTest, NoneIsNoProblem) {
    OperatorKeyboard keyboard{std::string()};
    EXPECT_EQ(keyboard.problem(), "");
    EXPECT_TRUE(keyboard.take_presses().empty());
    OperatorKeyboard moved(std::move(keyboard));
    EXPECT_TRUE(moved.take_presses().empty());
}

}  // namespace
}  // namespace touchline
