// Tests what is said during homing: every step gives something to do, every remark a reason.
#include "app/force/device/device_words.h"

#include "app/force/servo/messages.h"
#include "app/visit/told_lines.h"

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
    HomingRemark::measured,   HomingRemark::no_such_scale, HomingRemark::other_kind,
    HomingRemark::either_kind};

/// Returns everything that is said about any kind of device.
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

/// Splits texts into sentences; a decimal point ends none.
std::set<std::string> sentences_in(const std::set<std::string>& all) {
    std::set<std::string> sentences;
    for (const std::string& words : all) {
        for (std::size_t at = 0; at < words.size();) {
            const std::size_t stop = std::min(words.find(". ", at), words.size() - 1);
            sentences.insert(words.substr(at, stop + 1 - at));
            at = stop + 2;
        }
    }
    return sentences;
}

/// The kiosk says the words sentence by sentence in other languages, so the catalogue must have
/// each one, including those with a measure.
TEST(DeviceWords, EverySentenceIsInTheCatalogue) {
    const auto codes = languages_in(TOUCHLINE_CATALOGUES).value();
    ASSERT_GE(codes.size(), 4U);
    std::set<std::string> sentences = sentences_in(all_words());
    sentences.merge(sentences_in({words_again("One moment.")}));
    ASSERT_GT(sentences.size(), 40U);
    for (const std::string& code : codes) {
        if (code == "en") continue;
        const Language language = Language::load(TOUCHLINE_CATALOGUES, code).value();
        const std::string general = language.text("trouble", std::string(device_trouble));
        for (const std::string& sentence : sentences) {
            const std::string told = told_of_device(sentence, language);
            EXPECT_NE(told, "") << code << ": " << sentence;
            EXPECT_NE(told, sentence) << code;
            EXPECT_NE(told, general) << code << ": " << sentence;
        }
    }
}

TEST(DeviceWords, AllReachTheKioskWhole) {
    for (const std::string& words : all_words())
        EXPECT_LE(words_again(words).size(), sizeof Message::line) << words;
}

/// After a wrong motor nothing moves until somebody starts again.
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
