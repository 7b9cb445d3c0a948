// Tests the packs on the operator's stick with the real touchline-import.
#include "app/kiosk/operator_stick.h"

#include "tests/app/sticks/stick_folder.h"

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using Names = std::vector<std::string>;

class OperatorStickTest : public testing::Test {
  protected:
    /// Waits until there are `count` names, which must come.
    void wait_for_names(std::size_t count) {
        for (int i = 0; i < 6000 && packs.names().size() != count; ++i) {
            EXPECT_EQ(packs.poll(), "");
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        ASSERT_EQ(packs.names().size(), count);
    }

    StickFolder stick;
    OperatorStick packs{TOUCHLINE_IMPORT};
};

TEST_F(OperatorStickTest, AreListedByNamesThatAreSafeAndRead) {
    stick.file("letters.zip", "of letters");
    stick.file("castles\n\x1b[2J.zip", "of castles");
    packs.look_at(stick.root());
    ASSERT_NO_FATAL_FAILURE(wait_for_names(2));
    EXPECT_EQ(packs.names()[0].find_first_of("\n\x1b"), std::string::npos);
    EXPECT_EQ(packs.names()[1], "letters");
    const auto read = packs.reader_of(1);
    const auto bytes = read();
    ASSERT_TRUE(bytes.has_value());
    EXPECT_EQ(bytes->bytes().size(), std::string("of letters").size());
}

TEST_F(OperatorStickTest, AreForgottenWithTheirStick) {
    stick.file("letters.zip");
    packs.look_at(stick.root());
    ASSERT_NO_FATAL_FAILURE(wait_for_names(1));
    const auto read = packs.reader_of(0);
    packs.look_at("");
    EXPECT_EQ(packs.names(), Names{});
    const StickFolder other;
    other.file("a.zip");
    other.file("b.zip");
    packs.look_at(stick.root());  // pulled while it is being listed
    (void)packs.poll();
    packs.look_at(other.root());
    ASSERT_NO_FATAL_FAILURE(wait_for_names(2));
    EXPECT_EQ(packs.names(), (Names{"a", "b"}));
}

TEST_F(OperatorStickTest, OfAStickThatIsGoneAreOneSentence) {
    packs.look_at(stick.root() + "/gone");
    std::string sentence;
    for (int i = 0; i < 6000 && sentence.empty(); ++i) {
        sentence = packs.poll();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_EQ(sentence,
              "The stick cannot be read because the stick was pulled out; put it in again");
}

}  // namespace
}  // namespace touchline
