#include "app/visit/keys/two_switches.h"

#include "app/visit/keys/key_wizard.h"

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

SwitchStep moved(const SwitchScan& scan, const SpokenScreen& screen, const Language& language) {
    if (!scan.role) {
        if (is_at_last_item(screen)) return onto_role(scan, roles_after_items.front(), language);
        return {scan, KeyRole::down, ""};
    }
    for (std::size_t i = 0; i + 1 < roles_after_items.size(); ++i)
        if (*scan.role == roles_after_items[i])
            return onto_role(scan, roles_after_items[i + 1], language);
    return round_again(scan, screen, language);
}

/// The choice stays under the switch, because it may be wanted again.
SwitchStep selected(SwitchScan scan, const SpokenScreen& screen) {
    const bool is_on_items = !scan.role && !screen.items.empty();
    const KeyRole role = scan.role.value_or(is_on_items ? KeyRole::select : KeyRole::repeat);
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
