// What is said during homing: every step has something to do, every remark a reason.
#include "app/device/device_words.h"

#include "app/servo/messages.h"
#include "tests/audio-cues/words/po_file.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr std::array steps{
    HomingStep::to_home,       HomingStep::to_check,       HomingStep::to_left,
    HomingStep::to_home_again, HomingStep::to_check_again, HomingStep::to_answer,
    HomingStep::done};
constexpr std::array remarks{
    HomingRemark::none,       HomingRemark::silent,        HomingRemark::not_moved,
    HomingRemark::misfit,     HomingRemark::starting_over, HomingRemark::reversed,
    HomingRemark::lost_count, HomingRemark::replugged,     HomingRemark::not_left,
    HomingRemark::measured,   HomingRemark::no_such_scale, HomingRemark::other_kind};

/// Everything that is said of the device, of whatever kind it is.
std::set<std::string> all_words() {
    std::set<std::string> all;
    for (const DeviceProfile& profile : device_profiles()) {
        const BoardFrame frame(profile, {});
        for (const HomingStep step : steps)
            for (const HomingRemark remark : remarks)
                all.insert(words_of({step, remark, 0.0, 0.1234, 11.71, 0}, profile));
        for (int verdict = 0; verdict <= static_cast<int>(NudgeVerdict::silent); ++verdict)
            all.insert(words_of(static_cast<NudgeVerdict>(verdict), frame));
        all.insert(words_outside_the_middle(frame));
        const std::string done =
            words_of({HomingStep::done, HomingRemark::measured, 0.0, 0.0, 1.0, 0}, profile);
        all.insert(done + " " + words_of(NudgeVerdict::running, frame));
    }
    return all;
}

TEST(DeviceWords, EveryStepAndRemarkSaysSomethingOfItsOwn) {
    for (const DeviceProfile& profile : device_profiles()) {
        std::set<std::string> all;
        for (const HomingStep step : steps)
            for (const HomingRemark remark : remarks)
                all.insert(words_of({step, remark, 0.0, 0.012, 1.17, 0}, profile));
        EXPECT_EQ(all.size(), steps.size() * remarks.size()) << profile.name;
        for (const std::string& words : all) {
            EXPECT_EQ(words.back(), '.');
            EXPECT_EQ(words.find('\n'), std::string::npos);
        }
    }
}

TEST(DeviceWords, LeadTheHandAwayFirstOnAGen31AndTowardsFirstOnAGen3) {
    const auto first = [](const char* name) {
        return words_of(HomingView{}, find_profile(name).value());
    };
    EXPECT_NE(first("2diy-gen3.1").find("away from you"), std::string::npos);
    EXPECT_NE(first("2diy-gen3").find("towards you"), std::string::npos);
}

TEST(DeviceWords, AMisfitIsToldInMillimetres) {
    const HomingView view{HomingStep::to_check, HomingRemark::misfit, 1.0, 0.0123, 1.0, 0};
    EXPECT_EQ(words_of(view, default_profile()),
              "Not there yet. It is 12 millimetres off. Pull the handle towards you until it "
              "stops. Hold it still there.");
}

/// The kiosk says it sentence by sentence in other languages: so must the catalogue have it.
TEST(DeviceWords, EverySentenceButThoseWithAMeasureIsInTheCatalogue) {
    const PoFile english =
        read_po(TOUCHLINE_SOURCE_DIR "/audio-cues/words/catalogue/touchline.pot");
    for (std::string words : all_words()) {
        words = words_again(words);
        for (std::size_t stop = 0; !words.empty(); words.erase(0, stop + 2)) {
            stop = std::min(words.find(". "), words.size() - 1);
            const std::string sentence = words.substr(0, stop + 1);
            const bool has_measure = sentence.find("millimetres") != std::string::npos ||
                                     sentence.find("percent") != std::string::npos;
            EXPECT_NE(english.contains({"device", sentence}), has_measure) << sentence;
            if (stop + 1 == words.size()) break;
        }
    }
}

TEST(DeviceWords, AllReachTheKioskWhole) {
    for (const std::string& words : all_words())
        EXPECT_LE(words_again(words).size(), sizeof Message::line) << words;
}

/// In other languages what is left of a sentence with a measure still says what is wrong.
TEST(DeviceWords, ARemarkWithAMeasureHasASentenceWithout) {
    for (const HomingRemark remark : {HomingRemark::misfit, HomingRemark::no_such_scale}) {
        const std::string with =
            words_of({HomingStep::to_home, remark, 0.0, 0.012, 1.17, 0}, default_profile());
        const std::string first = with.substr(0, with.find(". "));
        EXPECT_EQ(first.find_first_of("0123456789"), std::string::npos) << first;
    }
}

/// Nothing moves after a motor that is wrong until somebody begins anew.
TEST(DeviceWords, EveryVerdictSaysWhatToDo) {
    const std::string next = "Then find the handle’s starting point again.";
    std::set<std::string> all;
    for (int i = 0; i <= static_cast<int>(NudgeVerdict::silent); ++i) {
        const auto verdict = static_cast<NudgeVerdict>(i);
        const std::string words = words_of(verdict, BoardFrame(default_profile(), {}));
        all.insert(words);
        EXPECT_EQ(words.find(next) != std::string::npos, is_wrong(verdict)) << words;
    }
    EXPECT_EQ(all.size(), static_cast<std::size_t>(NudgeVerdict::silent) + 1U);
}

}  // namespace
}  // namespace touchline
