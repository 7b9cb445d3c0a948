#include "app/visit/keys/key_wizard.h"

#include <array>

namespace touchline {
namespace {

constexpr double patience_s = 20.0;

KeyRole asked_role(const KeyWizard& wizard) {
    return static_cast<KeyRole>(wizard.role);
}

bool is_done(const KeyWizard& wizard) {
    return wizard.role >= key_role_count;
}

std::string question(const KeyWizard& wizard, const Language& language) {
    const std::string role = role_in_words(asked_role(wizard), language);
    if (wizard.first) return language.text("keys", "Press it again.");
    return language.text("keys", "Press the key for {0} now.", {role});
}

WizardStep asked_again(KeyWizard wizard, const std::string& why, double now_s,
                       const Language& language) {
    wizard.first.reset();
    wizard.asked_s = now_s;
    return {wizard, why + ' ' + question(wizard, language), WizardEnd::none};
}

/// What is printed on the key is the same in all languages: "A", "F13".
std::string named_key_in_words(const std::string& name, const Language& language) {
    const bool is_printed =
        name.size() == 1 || (name[0] == 'F' && name[1] >= '0' && name[1] <= '9');
    if (is_printed) return name;
    const bool is_arrow = name == "left" || name == "right" || name == "up" || name == "down";
    return language.text("keys", is_arrow ? "arrow " + name : name);
}

WizardStep next_role(KeyWizard wizard, const std::string& said, double now_s,
                     const Language& language) {
    ++wizard.role;
    wizard.first.reset();
    wizard.asked_s = now_s;
    const std::string lead = said.empty() ? said : said + ' ';
    if (is_done(wizard))
        return {wizard, lead + language.text("keys", "All keys are assigned."), WizardEnd::learnt};
    return {wizard, lead + question(wizard, language), WizardEnd::none};
}

WizardStep learnt(KeyWizard wizard, const PhysicalKey& key, double now_s,
                  const Language& language) {
    wizard.learnt.bindings.push_back({key, asked_role(wizard)});
    const std::string said =
        language.text("keys", "{0} is now {1}.",
                      {key_in_words(key, language), role_in_words(asked_role(wizard), language)});
    return next_role(wizard, said, now_s, language);
}

}  // namespace

KeyWizard start_key_wizard(double now_s) {
    KeyWizard wizard;
    wizard.asked_s = now_s;
    return wizard;
}

WizardStep press_wizard_key(const KeyWizard& wizard, const PhysicalKey& key, double now_s,
                            const Language& language) {
    if (is_done(wizard)) return {wizard, "", WizardEnd::none};
    if (const auto role = role_of(wizard.learnt, key)) {
        const std::string why =
            language.text("keys", "{0} is {1} already.",
                          {key_in_words(key, language), role_in_words(*role, language)});
        return asked_again(wizard, why, now_s, language);
    }
    if (!wizard.first) {
        KeyWizard next = wizard;
        next.first = key;
        next.asked_s = now_s;
        return {next, question(next, language), WizardEnd::none};
    }
    if (*wizard.first == key) return learnt(wizard, key, now_s, language);
    return asked_again(wizard, language.text("keys", "That was another key."), now_s, language);
}

WizardStep wait_for_wizard_key(const KeyWizard& wizard, double now_s, const Language& language) {
    if (is_done(wizard) || now_s - wizard.asked_s < patience_s)
        return {wizard, "", WizardEnd::none};
    if (wizard.role >= needed_role_count) return next_role(wizard, "", now_s, language);
    return {wizard, language.text("keys", "No key was pressed. All keys are as they were before."),
            WizardEnd::given_up};
}

SpokenScreen wizard_screen(const KeyWizard& wizard, const Language& language) {
    SpokenScreen screen;
    screen.title = language.text("keys", "Assign the keys");
    screen.text = is_done(wizard) ? language.text("keys", "All keys are assigned.")
                                  : question(wizard, language) + ' ' +
                                        language.text("keys", "Wait 20 seconds to leave.");
    for (const KeyBinding& binding : wizard.learnt.bindings)
        screen.items.push_back({static_cast<int>(binding.role), ItemRole::text,
                                role_in_words(binding.role, language),
                                key_in_words(binding.key, language), ""});
    return screen;
}

std::string key_in_words(const PhysicalKey& key, const Language& language) {
    const std::string number = std::to_string(key.code);
    switch (key.source) {
        case KeySource::key:
            return named_key_in_words(name_of(key), language);
        case KeySource::scancode:
            return language.text("keys", "key number {0}", {number});
        case KeySource::joystick:
            return language.text("keys", "button {0} of the joystick", {number});
        case KeySource::handle:
            return language.text("keys", "button {0} of the handle", {number});
    }
    return {};
}

std::string role_in_words(KeyRole role, const Language& language) {
    constexpr std::array<const char*, key_role_count> names{"Up",     "Down", "Back",   "Repeat",
                                                            "Select", "Help", "Louder", "Softer"};
    return language.text("keys", names[static_cast<std::size_t>(role)]);
}

}  // namespace touchline
