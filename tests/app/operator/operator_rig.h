// An operator with six keys at a kiosk that carries the orders out, with real files in a separate
// folder, on a clock that only the test moves.
#pragma once

#include "app/operator/operator.h"
#include "app/operator/settings_files.h"
#include "config/types/pinned.h"

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

class OperatorRig : private Pinned {
  public:
    explicit OperatorRig(Language words = {});
    ~OperatorRig();

    /// Lets half a second pass before each key.
    void press(std::initializer_list<KeyRole> roles);

    void press(KeyRole role) { press({role}); }

    void press_key(const PhysicalKey& key);
    void wait(double time_s);  // in ticks of a second
    void take(const OperatorEvent& event);

    /// Presses the keys that open the operator's screens.
    void enter();
    void enter_pin(const std::string& pin);

    /// Enters with a new PIN, and goes from the first screen back to the menu. Forgets what was
    /// heard.
    void open_menu();

    /// Presses Down until the item with this name has the focus; returns false if there is none.
    bool find(const std::string& name);

    /// Calls find() and presses Select for each name.
    bool open(std::initializer_list<const char*> names);

    [[nodiscard]] OperatorWorld world() const;
    [[nodiscard]] SpokenScreen screen() const;

    /// Returns all that was said since the last call, a line each.
    std::string heard();

    template <class Order>
    [[nodiscard]] int count() const {
        int found = 0;
        for (const OperatorOrder& order : orders)
            found += std::holds_alternative<Order>(order) ? 1 : 0;
        return found;
    }

    Operator state;
    std::vector<OperatorOrder> orders;  // all orders so far
    Language language;
    double now_s = 1000.0;
    bool is_private = true;
    std::string shown;  // of what was said last, or instead of it
    bool answers_tests = true;
    bool passes_tests = true;
    bool is_device_allowed = true;
    std::optional<Settings> in_memory;  // replaces the settings file
    Settings felt;                      // the servo's settings
    SoundSettings sound;
    KeyTable keys = default_keys();
    std::chrono::sys_days today{std::chrono::year(2026) / 3 / 1};
    CountedDays days;
    std::vector<std::string> packs{"Castles", "Letters"};
    std::vector<std::string> house_files{"all kiosks", "house"};
    std::vector<std::string> house_lines;
    std::optional<std::string> kind = "2diy-gen3.1";
    FeltBounds bounds;
    std::string device_words;
    KioskHealth health;
    std::filesystem::path folder;
    std::filesystem::path stick;
    SettingsFiles files;
    std::vector<Profile> profiles;

  private:
    void carry_out(const OperatorOrder& order);

    std::string heard_;
};

}  // namespace touchline
