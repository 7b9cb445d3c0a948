// Tests the wizard that learns the keys: whatever is pressed, its table has all six roles or none
// is kept.
#include "app/visit/keys/key_wizard.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

const Language english;

PhysicalKey key(std::uint32_t number) {
    return {KeySource::scancode, number};
}

WizardStep press_twice(const KeyWizard& wizard, std::uint32_t number) {
    const WizardStep once = press_wizard_key(wizard, key(number), 0.0, english);
    EXPECT_EQ(once.said, "Press it again.");
    return press_wizard_key(once.wizard, key(number), 0.0, english);
}

TEST(KeyWizard, LearnsEightRolesByTwoPressesEach) {
    KeyWizard wizard = start_key_wizard(0.0);
    EXPECT_EQ(wizard_screen(wizard, english).text,
              "Press the key for Up now. Wait 20 seconds to leave.");
    for (std::uint32_t i = 0; i < key_role_count; ++i) {
        const WizardStep step = press_twice(wizard, 100 + i);
        const bool is_last = i + 1 == key_role_count;
        EXPECT_EQ(step.end, is_last ? WizardEnd::learnt : WizardEnd::none);
        wizard = step.wizard;
    }
    EXPECT_FALSE(role_without_key(wizard.learnt));
    EXPECT_EQ(role_of(wizard.learnt, key(104)), KeyRole::select);
    EXPECT_TRUE(parse_keys(keys_text(wizard.learnt), "f").has_value());
}

TEST(KeyWizard, NamesAConflict) {
    const WizardStep learnt = press_twice(start_key_wizard(0.0), 30);
    EXPECT_EQ(learnt.said, "key number 30 is now Up. Press the key for Down now.");
    const WizardStep again = press_wizard_key(learnt.wizard, key(30), 0.0, english);
    EXPECT_EQ(again.said, "key number 30 is Up already. Press the key for Down now.");
    EXPECT_EQ(again.wizard.learnt.bindings.size(), 1U);
}

TEST(KeyWizard, AnotherKeyTheSecondTimeBeginsTheRoleAnew) {
    const WizardStep once = press_wizard_key(start_key_wizard(0.0), key(1), 0.0, english);
    const WizardStep other = press_wizard_key(once.wizard, key(2), 0.0, english);
    EXPECT_EQ(other.said, "That was another key. Press the key for Up now.");
    EXPECT_TRUE(other.wizard.learnt.bindings.empty());
}

TEST(KeyWizard, WithoutAKeyANeededRoleEndsItAndLouderIsPassedOver) {
    const KeyWizard wizard = start_key_wizard(0.0);
    EXPECT_EQ(wait_for_wizard_key(wizard, 19.0, english).end, WizardEnd::none);
    const WizardStep over = wait_for_wizard_key(wizard, 20.0, english);
    EXPECT_EQ(over.end, WizardEnd::given_up);
    EXPECT_EQ(over.said, "No key was pressed. All keys are as they were before.");
    KeyWizard six = wizard;
    for (std::uint32_t i = 0; i < needed_role_count; ++i) six = press_twice(six, 1 + i).wizard;
    const WizardStep without_louder = wait_for_wizard_key(six, 20.0, english);
    EXPECT_EQ(without_louder.end, WizardEnd::none);
    const WizardStep done = wait_for_wizard_key(without_louder.wizard, 40.0, english);
    EXPECT_EQ(done.end, WizardEnd::learnt);
    EXPECT_FALSE(role_without_key(done.wizard.learnt));
}

TEST(KeyWizard, KeysHaveNamesForTheEar) {
    EXPECT_EQ(key_in_words(*key_named("H"), english), "H");
    EXPECT_EQ(key_in_words(*key_named("F13"), english), "F13");
    EXPECT_EQ(key_in_words(*key_named("up"), english), "arrow up");
    EXPECT_EQ(key_in_words(*key_named("page up"), english), "page up");
    EXPECT_EQ(key_in_words(*key_named("joystick 2"), english), "button 2 of the joystick");
    EXPECT_EQ(key_in_words(*key_named("handle 0"), english), "button 0 of the handle");
}

RC_GTEST_PROP(KeyWizard, OfAnyKeysIsSoundOrNothing, ()) {
    KeyWizard wizard = start_key_wizard(0.0);
    double now_s = 0.0;
    WizardEnd end = WizardEnd::none;
    for (int i = 0; i < 300 && end == WizardEnd::none; ++i) {
        const bool waits = *rc::gen::inRange(0, 20) == 0;
        now_s += waits ? 25.0 : 0.1;
        const auto number = static_cast<std::uint32_t>(*rc::gen::inRange(1, 12));
        const WizardStep step = waits ? wait_for_wizard_key(wizard, now_s, english)
                                      : press_wizard_key(wizard, key(number), now_s, english);
        RC_ASSERT(!step.said.empty() || waits);
        wizard = step.wizard;
        end = step.end;
    }
    if (end == WizardEnd::learnt) RC_ASSERT(!role_without_key(wizard.learnt).has_value());
    for (const KeyBinding& binding : wizard.learnt.bindings)
        RC_ASSERT(role_of(wizard.learnt, binding.key) == binding.role);
}

}  // namespace
}  // namespace touchline
