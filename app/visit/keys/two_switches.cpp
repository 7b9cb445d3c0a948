#include "app/visit/keys/two_switches.h"

#include "app/visit/keys/key_wizard.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

constexpr std::array roles_after_items{KeyRole::repeat, KeyRole::back, KeyRole::help};
constexpr int rounds_by_itself = 2;

bool is_at_last_item(const SpokenScreen& screen) {
    return screen.items.empty() || (screen.focus && *screen.focus + 1 == screen.items.size());
}

SwitchStep onto_role(SwitchScan scan, KeyRole role, const Language& language) {
    scan.role = role;
    return {scan, std::nullopt, role_in_words(role, language)};
}

/// Past the last role: goes to the first item, or to the first role if there are no items.
SwitchStep round_again(SwitchScan scan, const SpokenScreen& screen, const Language& language) {
    ++scan.rounds;
    if (screen.items.empty()) return onto_role(scan, roles_after_items.front(), language);
    scan.role.reset();
    return {scan, KeyRole::down, ""};
}

/// An item of that name, which is always the last one, sounds like the key and does the same.
bool has_item_back(const SpokenScreen& screen, const Language& language) {
    return !screen.items.empty() &&
           screen.items.back().name == role_in_words(KeyRole::back, language);
}

SwitchStep moved(const SwitchScan& scan, const SpokenScreen& screen, const Language& language) {
    if (!scan.role && !is_at_last_item(screen)) return {scan, KeyRole::down, ""};
    const auto* next = roles_after_items.begin();
    if (scan.role) next = std::ranges::find(roles_after_items, *scan.role) + 1;
    if (next == roles_after_items.end()) return round_again(scan, screen, language);
    if (*next == KeyRole::back && has_item_back(screen, language)) ++next;
    return onto_role(scan, *next, language);
}

/// Whatever the role does, the item that has the focus is heard last, so the next press is for it.
/// Without items the role stays, because it may be wanted again.
SwitchStep selected(SwitchScan scan, const SpokenScreen& screen) {
    const KeyRole on_items = screen.items.empty() ? KeyRole::repeat : KeyRole::select;
    const KeyRole role = scan.role.value_or(on_items);
    if (!screen.items.empty()) scan.role.reset();
    return {scan, role, ""};
}

}  // namespace

SwitchStep step_switches(const SwitchScan& scan, SwitchEvent event, const SpokenScreen& screen,
                         double scan_s, double now_s, const Language& language) {
    SwitchScan next = scan;
    if (next.title != screen.title) next.role.reset();
    next.title = screen.title;
    if (event == SwitchEvent::tick) {
        const bool is_due = scan_s > 0.0 && now_s - scan.since_s >= scan_s;
        if (screen.takes_any_key) next.since_s = now_s;
        if (!is_due || screen.takes_any_key || scan.rounds >= rounds_by_itself)
            return {next, std::nullopt, ""};
        next.since_s = now_s;
        return moved(next, screen, language);
    }
    next.since_s = now_s;
    next.rounds = 0;
    if (screen.takes_any_key) return {next, KeyRole::select, ""};
    return event == SwitchEvent::move ? moved(next, screen, language) : selected(next, screen);
}

}  // namespace touchline
