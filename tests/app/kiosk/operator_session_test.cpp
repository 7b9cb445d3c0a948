// Tests OperatorSession on real files, through restarts of the kiosk.
#include "app/kiosk/operator_session.h"

#include "app/documents/decode/files.h"
#include "app/documents/models/networks.h"
#include "app/documents/sticks/listing.h"
#include "app/house/bundle_making.h"
#include "app/house/house_keys.h"
#include "app/kiosk/operator_house.h"
#include "app/operator/pin.h"
#include "tests/app/kiosk/kiosk_world.h"
#include "tests/machines/sim/kiosk/house.h"

#include <chrono>
#include <fstream>
#include <future>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

/// A kiosk that can be switched off at any moment; its clock restarts each time.
class PinAndPlug : public testing::Test {
  protected:
    PinAndPlug() {
        EXPECT_TRUE(keep_pin(files_.pin, "1234"));
        start();
    }

    void start() {
        now_s_ = 5.0;
        problems_.clear();
        operator_.emplace(files_, std::vector<Language>{Language()}, problems_);
        (void)operator_->apply(MomentPassed{}, language_, now_s_);
    }

    /// Starts a kiosk with the PIN 0001 that runs this script instead of touchline-import.
    void start_with_import(const std::string& script) {
        EXPECT_TRUE(keep_pin(files_.pin, "0001"));
        const fs::path program = world_.folder() / "import";
        std::ofstream(program) << "#!/bin/sh\n" << script << '\n';
        fs::permissions(program, fs::perms::owner_all);
        files_.import_program = program;
        start();
    }

    void press(KeyRole role) {
        now_s_ += 0.1;
        heard_.clear();
        const auto left = operator_->apply(KeyStruck{keys_of(default_keys(), role).at(0), role},
                                           language_, now_s_);
        for (const OperatorOrder& order : left)
            if (const auto* const say = std::get_if<Say>(&order))
                heard_ += (said_ = say->text) + '\n';
    }

    void type_pin(int last_digit) {
        for (int i = 0; i < 3; ++i) {
            press(KeyRole::down);
            press(KeyRole::select);
        }
        if (last_digit == 0) press(KeyRole::down);
        for (int i = 0; i < last_digit; ++i) press(KeyRole::up);
        press(KeyRole::select);
        press(KeyRole::select);
    }

    /// Opens the operator's screens from the visitors' screen and tries a PIN of zeros and this
    /// last digit. Ends in the menu, or outside.
    void try_pin(int last_digit) {
        for (const KeyRole role : {KeyRole::help, KeyRole::up, KeyRole::up, KeyRole::down,
                                   KeyRole::down, KeyRole::select})
            press(role);
        type_pin(last_digit);
        press(KeyRole::back);  // inside: from the first screen to the menu
        if (operator_->is_inside()) return;
        press(KeyRole::back);
    }

    /// Selects an item of the open screen; returns false if no item has that name.
    bool choose(const std::string& label) {
        for (int i = 0; i < 40; ++i) {
            const SpokenScreen screen = operator_->screen(language_);
            if (screen.focus && screen.items.at(*screen.focus).name == label) {
                press(KeyRole::select);
                return true;
            }
            press(KeyRole::down);
        }
        return false;
    }

    void wait(double time_s) {
        now_s_ += time_s;
        (void)operator_->apply(MomentPassed{}, language_, now_s_);
    }

    KioskWorld world_;
    OperatorFiles files_ = world_.site_files();
    Language language_;
    std::vector<std::string> problems_;
    std::optional<OperatorSession> operator_;
    double now_s_ = 0.0;
    std::string said_;   // last sentence
    std::string heard_;  // since the last key
};

TEST_F(PinAndPlug, PullingThePlugGivesNoTryForNothing) {
    ASSERT_TRUE(keep_pin(files_.pin, "0001"));
    for (int i = 1; i <= 5; ++i) {
        try_pin(9);
        EXPECT_EQ(read_pin_tries(pin_tries_file(files_.pin)), i);
        start();
    }
    try_pin(1);
    EXPECT_FALSE(operator_->is_inside()) << "the wait began anew with the restart";
    wait(50.0);
    try_pin(1);
    EXPECT_FALSE(operator_->is_inside());
    wait(10.0);
    try_pin(1);
    EXPECT_TRUE(operator_->is_inside()) << said_;
    EXPECT_EQ(read_pin_tries(pin_tries_file(files_.pin)), 0);
}

TEST_F(PinAndPlug, ADamagedCountWaitsAsLongAsCanBe) {
    ASSERT_TRUE(keep_pin(files_.pin, "0001"));
    std::ofstream(pin_tries_file(files_.pin)) << "wrong PINs: few\n";
    start();
    ASSERT_EQ(problems_.size(), 1U);
    try_pin(1);
    EXPECT_FALSE(operator_->is_inside());
    wait(3590.0);
    try_pin(1);
    EXPECT_FALSE(operator_->is_inside());
    wait(15.0);
    try_pin(1);
    EXPECT_TRUE(operator_->is_inside()) << said_;
    start();
    EXPECT_TRUE(problems_.empty()) << "the right one mended it";
}

TEST_F(PinAndPlug, WhereNothingCanBeNotedEachWrongOneCostsTime) {
    ASSERT_TRUE(keep_pin(files_.pin, "0001"));
    fs::create_directories(fs::path(pin_tries_file(files_.pin)).concat(".part") / "full");
    try_pin(9);
    EXPECT_NE(operator_->take_note().find("cannot be kept"), std::string::npos);
    try_pin(1);
    EXPECT_FALSE(operator_->is_inside());
    wait(61.0);
    try_pin(1);
    EXPECT_TRUE(operator_->is_inside()) << said_;
}

/// The operator hears what to do in their language; the log gets the line with its path.
TEST_F(PinAndPlug, WhatCannotBeReadOrKeptIsSaidAndItsLineIsTheLogs) {
    ASSERT_TRUE(keep_pin(files_.pin, "0001"));
    start();
    try_pin(1);
    ASSERT_TRUE(choose("Upkeep"));
    ASSERT_TRUE(choose("Backup of the settings"));
    std::ofstream(files_.copies) << "a file where the folder should be";
    for (const Language& language : all_languages()) {
        language_ = language;
        const auto words = [&](const char* text) { return language.text("operator", text); };
        (void)operator_->take_note();
        ASSERT_TRUE(choose(words("Bring the settings back from the copy"))) << language.code();
        ASSERT_TRUE(choose(language.text("test", "Yes"))) << language.code();
        EXPECT_NE(heard_.find(words("There is no copy that can be used. Copy the settings first.")),
                  std::string::npos)
            << heard_;
        EXPECT_NE(operator_->take_note().find(files_.copies.string()), std::string::npos);
        ASSERT_TRUE(choose(words("Copy the settings"))) << language.code();
        EXPECT_NE(heard_.find(words("The copy cannot be written. Make room on the disk.")),
                  std::string::npos)
            << heard_;
        EXPECT_EQ(heard_.find(files_.copies.string()), std::string::npos) << heard_;
        EXPECT_NE(operator_->take_note().find(files_.copies.string()), std::string::npos);
    }
}

/// A script replaces touchline-import: it leaves a mark and then hangs.
class StickOfTheOperator : public PinAndPlug {
  protected:
    StickOfTheOperator() {
        start_with_import("echo \"$1\" >'" + mark_.string() + "'\nexec sleep 1");
    }

    void follow() {
        operator_->put_stick("/a/stick");
        (void)operator_->poll_stick(language_);
    }

    fs::path mark_ = world_.folder() / "mark";
};

TEST_F(StickOfTheOperator, IsNotEvenListedBeforeThePinIsGiven) {
    for (int i = 0; i < 20; ++i) follow();
    try_pin(9);
    for (int i = 0; i < 20; ++i) {
        follow();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_FALSE(fs::exists(mark_));
    try_pin(1);
    ASSERT_TRUE(operator_->is_inside());
    for (int i = 0; i < 6000 && !fs::exists(mark_); ++i) {
        follow();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_TRUE(fs::exists(mark_));
}

/// A script replaces touchline-import: it lists one network that is damaged.
class NetworkOnTheStick : public PinAndPlug {
  protected:
    NetworkOnTheStick() {
        const StickListing listing{{{StickFileKind::network, "", "figure.onnx"}}, {}};
        const fs::path list = world_.folder() / "list";
        EXPECT_TRUE(write_whole_file(list.string(), bytes_of(listing)));
        start_with_import("case $1 in operator) cat '" + list.string() +
                          "' >&3 ;; read) echo damaged >&3 ;; *) exit 2 ;; esac");
        try_pin(1);
    }

    /// Waits for a sentence about the stick, which must come.
    std::string poll() {
        std::optional<std::string> line;
        for (int i = 0; !line && i < 6000; ++i) {
            operator_->put_stick("/a/stick");
            line = operator_->poll_stick(language_);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return line.value_or("");
    }
};

TEST_F(NetworkOnTheStick, IsTakenByItsChecksumAlone) {
    ASSERT_TRUE(choose("Upkeep"));
    ASSERT_TRUE(choose("Copy from a USB stick"));
    bool is_chosen = false;
    for (int i = 0; i < 6000 && !is_chosen; ++i) {
        operator_->put_stick("/a/stick");
        (void)operator_->poll_stick(language_);
        is_chosen = choose("figure");
    }
    ASSERT_TRUE(is_chosen);
    EXPECT_EQ(
        poll(),
        "figure is damaged, or made for another version of Touchline. Copy it to the USB stick "
        "again.");
    EXPECT_FALSE(is_installed(networks().front()));
}

/// A shell applies bundles beside the running kiosk.
class ShellBesideTheKiosk : public PinAndPlug {
  protected:
    ShellBesideTheKiosk() {
        const auto key = make_house_key(other_.house);
        EXPECT_TRUE(key && trust_house_key(files_.house, *key));
        EXPECT_TRUE(keep_pin(files_.pin, "0001"));
    }

    /// The other kiosk's settings and its profile "school", as a bundle that is applied here.
    void apply(const std::string& profile, const Settings& settings) {
        EXPECT_TRUE(keep_text(other_.house.profiles / "school.toml", profile));
        EXPECT_TRUE(keep_settings(other_.settings, settings));
        const auto bundle =
            make_bundle(other_.house, std::chrono::sys_seconds(std::chrono::hours(++made_)));
        ASSERT_TRUE(bundle.has_value()) << bundle.error().line;
        const auto plan = plan_of_bundle(*bundle, "all", files_.house, {});
        ASSERT_TRUE(plan.has_value()) << plan.error().line;
        ASSERT_TRUE(apply_plan(*plan, files_.house).has_value());
    }

    OperatorFiles other_ = site_files_in(world_.folder() / "other");
    int made_ = 0;
};

TEST_F(ShellBesideTheKiosk, BringsAProfileThatHoldsAtOnce) {
    Settings with_profile;
    with_profile.profile = "school";
    apply("[feel]\nforce_ceiling_N = 1.0\n", with_profile);
    ASSERT_TRUE(operator_->read_again());
    EXPECT_EQ(operator_->take_note(), "");
    EXPECT_EQ(operator_->settings().force_ceiling_N, 1.0);
    EXPECT_FALSE(operator_->read_again()) << "nothing is new";
    apply("[feel]\nforce_ceiling_N = 0.5\n", with_profile);
    ASSERT_TRUE(operator_->read_again()) << "the profile alone is another";
    EXPECT_EQ(operator_->settings().force_ceiling_N, 0.5);
    const auto way = find_way_back(files_.house);
    ASSERT_TRUE(way && go_back(*way, files_.house));
    ASSERT_TRUE(operator_->read_again()) << "what is taken back holds at once too";
    EXPECT_EQ(operator_->settings().force_ceiling_N, 1.0);
}

TEST_F(ShellBesideTheKiosk, CountsAtOnceAlsoWhileTheScreensAreOpen) {
    try_pin(1);
    ASSERT_TRUE(operator_->is_inside());
    Settings theirs;
    theirs.friction = 0.4;
    apply("[sound]\nspeech = true\n", theirs);
    ASSERT_TRUE(operator_->read_again());
    EXPECT_EQ(operator_->settings().friction, 0.4);
}

/// Each of the two changed something else, and both hold.
TEST_F(ShellBesideTheKiosk, LosesNothingToAValueThatIsTurnedMeanwhile) {
    try_pin(1);
    ASSERT_TRUE(choose("How it feels") && choose("Lines and force") && choose("Firmness"));
    press(KeyRole::down);
    EXPECT_EQ(operator_->settings().stiffness_N_per_m, 450.0) << "felt, and not kept yet";
    Settings theirs;
    theirs.friction = 0.4;
    apply("[sound]\nspeech = true\n", theirs);
    EXPECT_FALSE(operator_->read_again()) << "a value is being turned";
    press(KeyRole::select);
    EXPECT_EQ(said_, "Saved.");
    const Settings kept = read_settings(files_.settings).settings;
    EXPECT_EQ(kept.friction, 0.4);
    EXPECT_EQ(kept.stiffness_N_per_m, 450.0);
    EXPECT_EQ(operator_->settings(), kept);
    press(KeyRole::select);
    press(KeyRole::down);
    press(KeyRole::select);
    EXPECT_EQ(read_settings(files_.settings).settings.friction, 0.4);
    EXPECT_EQ(operator_->settings().stiffness_N_per_m, 400.0);
}

TEST_F(ShellBesideTheKiosk, AndTheOperatorMayNotContradictEachOther) {
    try_pin(1);
    ASSERT_TRUE(choose("How it feels") && choose("Levels") && choose("Finest level"));
    for (int i = 0; i < 3; ++i) press(KeyRole::up);
    Settings theirs;
    theirs.coarsest_level = 2.0;
    apply("[sound]\nspeech = true\n", theirs);
    press(KeyRole::select);
    EXPECT_EQ(said_, "That does not go together with another setting.");
    EXPECT_EQ(read_settings(files_.settings).settings, theirs);
    ASSERT_TRUE(operator_->read_again());
    EXPECT_EQ(operator_->settings(), theirs);
}

TEST_F(ShellBesideTheKiosk, IsOverwrittenByTheFactorySettings) {
    try_pin(1);
    ASSERT_TRUE(choose("Upkeep") && choose("Backup of the settings") && choose("Factory settings"));
    Settings theirs;
    theirs.friction = 0.4;
    apply("[sound]\nspeech = true\n", theirs);
    EXPECT_FALSE(operator_->read_again()) << "a question waits";
    ASSERT_TRUE(choose("Yes"));
    EXPECT_EQ(read_settings(files_.settings).settings, Settings{});
}

/// The other kiosk of the house made a bundle and its key; both are on the stick.
class BundleOnTheStick : public PinAndPlug {
  protected:
    BundleOnTheStick() {
        const OperatorFiles other = site_files_in(world_.folder() / "other");
        Settings settings;
        settings.stiffness_N_per_m = 400.0;
        settings.screen_inches = 10.0;
        EXPECT_TRUE(keep_settings(other.settings, settings));
        const auto key = make_house_key(other.house);
        const auto bundle =
            make_bundle(other.house, std::chrono::sys_seconds(std::chrono::hours(1)));
        EXPECT_TRUE(key && bundle);
        EXPECT_TRUE(keep_text(stick_ / "other.touchline-key", key_text(*key)));
        EXPECT_TRUE(write_whole_file((stick_ / "all.touchline-bundle").string(), *bundle));
        EXPECT_TRUE(keep_pin(files_.pin, "0001"));
        start();
        try_pin(1);
        EXPECT_TRUE(choose("Upkeep"));
        EXPECT_TRUE(choose("Several kiosks"));
    }

    /// Chooses an item, once it is there, and waits for what comes of it; returns what is said.
    std::string answer_to(const std::string& label) {
        bool is_chosen = false;
        for (int i = 0; i < 6000 && !is_chosen; ++i) {
            operator_->put_stick(stick_.string());
            (void)operator_->poll_stick(language_);
            is_chosen = choose(label);
            if (!is_chosen) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        EXPECT_TRUE(is_chosen) << label;
        return answer();
    }

    std::string answer() {
        std::vector<OperatorEvent> events;
        for (int i = 0; i < 6000 && events.empty(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            events = operator_->poll_house();
        }
        std::string said;
        for (const OperatorEvent& event : events)
            for (const OperatorOrder& order : operator_->apply(event, language_, now_s_))
                if (const auto* const say = std::get_if<Say>(&order)) said += say->text;
        return said;
    }

    void trust_key() {
        EXPECT_NE(answer_to("other").find("Compare these digits"), std::string::npos);
        ASSERT_TRUE(choose("Trust this house key"));
        type_pin(1);
        EXPECT_EQ(answer(), "Bundles of this house are taken from now on.");
    }

    fs::path stick_ = world_.folder() / "stick";
    std::string takes_a_moment_ = "This takes a moment. You hear when it is done.";
};

/// A bundle that waits for its stick is under way: what else is ordered is refused aloud.
TEST(OperatorHouse, RefusesAloudWhatComesMeanwhileAndTellsOfMemory) {
    const KioskWorld world;
    const OperatorFiles files = world.site_files();
    OperatorHouse house(files.house, files.copies);
    std::promise<void> may_end;
    const auto end = may_end.get_future().share();
    const auto read = [end]() -> Result<Mapping, Outcome> {
        end.wait();
        throw std::bad_alloc();
    };
    house.look_at({"all", false, read}, {}, Language());
    EXPECT_FALSE(house.poll().has_value());
    house.make(Language());
    const auto refused = house.poll();
    ASSERT_TRUE(refused.has_value());
    EXPECT_EQ(refused->outcome.said, "Something else is still being done. Wait.");
    may_end.set_value();
    std::optional<HouseNews> news;
    while (!news) news = house.poll();
    EXPECT_EQ(news->outcome.said, "Something cannot be read or saved here. The log says what.");
    EXPECT_FALSE(news->outcome.line.empty());
}

TEST_F(BundleOnTheStick, ChangesNothingWithoutTheHouseKey) {
    EXPECT_EQ(answer_to("all"), "This kiosk has no house key. Install the house key first.");
    EXPECT_FALSE(operator_->take_note().empty()) << "the log says more";
    EXPECT_FALSE(operator_->read_again());
}

TEST_F(BundleOnTheStick, IsToldAppliedAndTakenBack) {
    Settings own;
    own.screen_inches = 24.0;
    EXPECT_TRUE(keep_settings(files_.settings, own));
    trust_key();
    const std::string told = answer_to("all");
    EXPECT_NE(told.find("Firmness: from 500 newtons per metre to 400"), std::string::npos)
        << told << operator_->take_note();
    ASSERT_TRUE(choose("Apply the bundle"));
    ASSERT_TRUE(choose("Yes"));
    EXPECT_EQ(answer(), takes_a_moment_);
    EXPECT_EQ(answer(), "The bundle is applied.");
    ASSERT_TRUE(operator_->read_again());
    EXPECT_EQ(operator_->settings().stiffness_N_per_m, 400.0);
    EXPECT_EQ(operator_->settings().screen_inches, 24.0) << "the kiosk's own";
    EXPECT_NE(answer_to("Back to before the bundle").find("from 400 newtons per metre to 500"),
              std::string::npos);
    ASSERT_TRUE(choose("Go back"));
    ASSERT_TRUE(choose("Yes"));
    EXPECT_EQ(answer(), takes_a_moment_);
    EXPECT_EQ(answer(), "All is as before the bundle.");
    ASSERT_TRUE(operator_->read_again());
    EXPECT_EQ(operator_->settings(), own);
}

TEST_F(BundleOnTheStick, IsMadeBesideTheSettings) {
    EXPECT_NE(answer_to("House key of this kiosk").find("House key of this kiosk"),
              std::string::npos);
    press(KeyRole::back);
    EXPECT_EQ(answer_to("Make a bundle of this kiosk"), takes_a_moment_);
    EXPECT_EQ(answer(), "The bundle is in the folder copies, beside the settings.");
    EXPECT_TRUE(fs::exists(files_.copies / "house.touchline-bundle"));
    EXPECT_TRUE(fs::exists(files_.copies / "house.touchline-key"));
}

/// No call of OperatorSession waits for the stick, however slow it is.
TEST_F(StickOfTheOperator, KeepsNobodyWaiting) {
    try_pin(1);
    ASSERT_TRUE(operator_->is_inside());
    follow();
    int calls = 0;
    std::optional<std::string> line;
    for (; !line && calls < 60'000; ++calls) {
        operator_->put_stick("/a/stick");
        line = operator_->poll_stick(language_);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_TRUE(line.has_value());
    EXPECT_TRUE(line->starts_with("The USB stick was pulled out or is damaged.")) << *line;
    EXPECT_GT(calls, 50) << "the list took a second, and meanwhile the screen went on";
}

}  // namespace
}  // namespace touchline
