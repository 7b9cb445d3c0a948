// Tests a real brltty with a real BrlAPI between the kiosk's line and a display of no make.
#include "app/braille/braille_line.h"
#include "tests/app/braille/virtual_display.h"

#include <chrono>
#include <cstdlib>
#include <optional>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

class BrailleDisplay : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_FALSE(Brltty::program().empty()) << "the package brltty is not installed";
        folder_ = fs::temp_directory_path() / ("line-" + std::to_string(getpid()));
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        // A place below BrlAPI's own folder that no other test has.
        host_ = ":" + std::to_string(1000 + getpid() % 60000);
        setenv("BRLAPI_HOST", host_.c_str(), 1);
        setenv("BRLAPI_AUTH", "none", 1);
    }

    void TearDown() override {
        unsetenv("BRLAPI_HOST");
        unsetenv("BRLAPI_AUTH");
        fs::remove_all(folder_);
    }

    std::optional<LineEvent> next_event(BrailleLine& line, double most_s = 10.0) {
        for (double waited_s = 0.0; waited_s < most_s; waited_s += 0.01) {
            if (auto event = line.next_event()) return event;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return std::nullopt;
    }

    fs::path folder_;
    std::string host_;
};

template <class Event>
bool is(const std::optional<LineEvent>& event) {
    return event && std::holds_alternative<Event>(*event);
}

bool is_role(const std::optional<LineEvent>& event, KeyRole role) {
    return is<KeyRole>(event) && std::get<KeyRole>(*event) == role;
}

TEST_F(BrailleDisplay, HA3_FromTheTextToTheDotsAndFromTheKeyToTheRole) {
    VirtualDisplay display(folder_, 20);
    const Brltty brltty(folder_, host_, display.socket());
    BrailleLine line(BrailleUse::uncontracted);
    line.say({"en", "the house stands on a hill by the sea"}, LineUse::now);
    ASSERT_TRUE(display.shows("THE HOUSE STANDS ON")) << display.shown();
    EXPECT_TRUE(line.is_there());

    struct Press {
        const char* command;
        KeyRole role;
    };

    for (const Press& press :
         {Press{"LnUp", KeyRole::up}, Press{"LnDn", KeyRole::down}, Press{"Top", KeyRole::back},
          Press{"Home", KeyRole::repeat}, Press{"Bot", KeyRole::help},
          Press{"Route 1", KeyRole::select}, Press{"Route 20", KeyRole::select}}) {
        display.press(press.command);
        EXPECT_TRUE(is_role(next_event(line), press.role)) << press.command;
    }
    display.press("PrefMenu");  // brltty's own menu stays closed
    EXPECT_TRUE(is<DeadLineKey>(next_event(line)));
    EXPECT_TRUE(display.shows("THE HOUSE STANDS ON")) << display.shown();
}

TEST_F(BrailleDisplay, HA3_PagesAreTurnedByTheDisplaysOwnKeys) {
    VirtualDisplay display(folder_, 20);
    const Brltty brltty(folder_, host_, display.socket());
    BrailleLine line(BrailleUse::uncontracted);
    line.say({"en", "the house stands on a hill by the sea"}, LineUse::now);
    ASSERT_TRUE(display.shows("THE HOUSE STANDS ON")) << display.shown();
    display.press("FwinRt");
    EXPECT_TRUE(display.shows("A HILL BY THE SEA")) << display.shown();
    const auto turned = next_event(line);
    ASSERT_TRUE(is<LineTurned>(turned));
    EXPECT_FALSE(std::get<LineTurned>(*turned).is_at_end);
    display.press("FwinRt");
    const auto at_end = next_event(line);
    ASSERT_TRUE(is<LineTurned>(at_end));
    EXPECT_TRUE(std::get<LineTurned>(*at_end).is_at_end);
    display.press("FwinLt");
    EXPECT_TRUE(display.shows("THE HOUSE STANDS ON")) << display.shown();
}

TEST_F(BrailleDisplay, HA3_TheLanguageAndTheGradeAreThoseOfTheKiosk) {
    VirtualDisplay display(folder_, 40);
    const Brltty brltty(folder_, host_, display.socket());
    BrailleLine line(BrailleUse::contracted);
    line.say({"de", "das Haus"}, LineUse::now);
    ASSERT_TRUE(display.shows("D H*S")) << display.shown();
    line.choose(BrailleUse::uncontracted);
    EXPECT_TRUE(display.shows("DAS HAUS")) << display.shown();
    line.say({"en", "the house"}, LineUse::now);
    line.choose(BrailleUse::contracted);
    EXPECT_TRUE(display.shows("! H\\SE")) << display.shown();
    line.forget();
    EXPECT_TRUE(display.shows("")) << display.shown();
}

TEST_F(BrailleDisplay, HA3_TheLineComesAndGoesWhileTheKioskRuns) {
    BrailleLine line(BrailleUse::uncontracted);
    line.say({"en", "one"}, LineUse::now);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_FALSE(line.is_there());
    {
        VirtualDisplay display(folder_, 20);
        Brltty brltty(folder_, host_, display.socket());
        ASSERT_TRUE(display.shows("ONE", 30.0)) << display.shown();
        brltty.stop();
        for (int i = 0; i < 1000 && line.is_there(); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        EXPECT_FALSE(line.is_there());
        EXPECT_EQ(line.take_report(), "the braille line is gone");
        line.say({"en", "two"}, LineUse::now);
    }
    VirtualDisplay display(folder_, 30);
    const Brltty brltty(folder_, host_, display.socket());
    EXPECT_TRUE(display.shows("TWO", 30.0)) << display.shown();
    EXPECT_EQ(line.take_report(), "the braille line has 30 cells");
}

/// The display alone is pulled out, or switched off: brltty stays.
TEST_F(BrailleDisplay, HA3_TheDisplayComesAndGoesUnderABrlttyThatStays) {
    auto display = std::make_unique<VirtualDisplay>(folder_, 20);
    const Brltty brltty(folder_, host_, display->socket());
    BrailleLine line(BrailleUse::uncontracted);
    line.say({"en", "one two three four"}, LineUse::now);
    ASSERT_TRUE(display->shows("ONE TWO THREE FOUR")) << display->shown();
    display.reset();
    std::this_thread::sleep_for(std::chrono::seconds(2));
    display = std::make_unique<VirtualDisplay>(folder_, 9);  // another one
    EXPECT_TRUE(display->shows("ONE TWO", 30.0)) << display->shown();
    line.say({"en", "two"}, LineUse::now);
    EXPECT_TRUE(display->shows("TWO")) << display->shown();
    display->press("LnDn");
    EXPECT_TRUE(is_role(next_event(line), KeyRole::down));
}

double thread_time_s() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

TEST_F(BrailleDisplay, WithoutALineNothingIsSpent) {
    for (const BrailleUse use : {BrailleUse::off, BrailleUse::contracted}) {
        BrailleLine line(use);
        line.say({"de", "das Haus"}, LineUse::now);
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        rusage before{};
        getrusage(RUSAGE_SELF, &before);
        const double since_s = thread_time_s();
        std::this_thread::sleep_for(std::chrono::seconds(12));
        rusage after{};
        getrusage(RUSAGE_SELF, &after);
        EXPECT_LT(thread_time_s() - since_s, 0.02);
        // Two looks at most, and a few turns of this thread.
        EXPECT_LE(after.ru_nvcsw - before.ru_nvcsw, 20);
        EXPECT_FALSE(line.is_there());
    }
}

}  // namespace
}  // namespace touchline
