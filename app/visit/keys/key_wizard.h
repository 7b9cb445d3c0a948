// Learns which key has which role: "Press the key for Up now." Asks for the six roles, then for
// louder and softer, each twice to be sure. Threads: values and pure functions.
#pragma once

#include "app/visit/screen_model.h"
#include "config/settings/keys.h"

#include <optional>
#include <string>

namespace touchline {

struct KeyWizard {
    KeyTable learnt;
    std::size_t role = 0;              // the one asked for; key_role_count: all are learnt
    std::optional<PhysicalKey> first;  // pressed once; must be pressed again
    double asked_s = 0.0;
};

[[nodiscard]] KeyWizard start_key_wizard(double now_s);

enum class WizardEnd : std::uint8_t { none, learnt, given_up };

struct WizardStep {
    KeyWizard wizard;
    std::string said;
    WizardEnd end = WizardEnd::none;
};

/// A key went down. Refuses, by name, a key that has a role already. Another key at the second
/// press restarts this role.
[[nodiscard]] WizardStep press_wizard_key(const KeyWizard& wizard, const PhysicalKey& key,
                                          double now_s, const Language& language);

/// Time passes. After 20 s without a key, louder and softer stay without one; for any other role
/// everything stays as it was before.
[[nodiscard]] WizardStep wait_for_wizard_key(const KeyWizard& wizard, double now_s,
                                             const Language& language);

[[nodiscard]] SpokenScreen wizard_screen(const KeyWizard& wizard, const Language& language);

/// "Page up", "button 3 of the joystick", in that language.
[[nodiscard]] std::string key_in_words(const PhysicalKey& key, const Language& language);

/// "Up", "Help", in that language.
[[nodiscard]] std::string role_in_words(KeyRole role, const Language& language);

}  // namespace touchline
