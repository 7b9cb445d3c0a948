#include "app/session/fault_words.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(FaultWords, EveryFaultSaysWhyAndWhatToDo) {
    std::set<std::string_view> reasons;
    for (std::size_t i = 1; i < fault_count; ++i) {
        const auto fault = static_cast<Fault>(i);
        const FaultWords words = words_of(fault);
        for (const auto sentence : {words.why, words.visitor_does, words.staff_does}) {
            ASSERT_FALSE(sentence.empty()) << i;
            EXPECT_EQ(sentence.back(), '.') << sentence;
        }
        reasons.insert(words.why);
        EXPECT_EQ(spoken_fault(fault, Language()), "The force is off. " + std::string(words.why) +
                                                       ' ' + std::string(words.visitor_does));
    }
    EXPECT_EQ(reasons.size(), fault_count - 1);
    EXPECT_EQ(spoken_fault(Fault::none, Language()), "");
    EXPECT_EQ(staffs_fault(Fault::none, Language()), "");
}

TEST(FaultWords, EveryStateHasItsOwn) {
    std::set<std::string_view> words;
    for (std::size_t i = 0; i < force_state_count; ++i)
        words.insert(words_of(static_cast<ForceState>(i)));
    EXPECT_EQ(words.size(), force_state_count);
    EXPECT_FALSE(words.contains(""));
}

}  // namespace
}  // namespace touchline
