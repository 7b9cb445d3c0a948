// The keys of a kiosk: which of their changes count, and what each stands for. kiosk_keys.cpp says
// what a key does for whom.
// Threads: plain values.
#pragma once

#include "app/visit/keys.h"
#include "app/visit/keys/key_filter.h"
#include "app/visit/keys/two_switches.h"
#include "config/settings/keys.h"

#include <optional>

namespace touchline {

/// A key may have a role by the site's table, an action by the staff's table, both or none.
struct KeyMeaning {
    std::optional<KeyRole> role;
    std::optional<Action> action;
};

/// The site's keys, and what is remembered between two presses.
struct KioskKeys {
    KeyTable table;
    KeyFilter filter;
    SwitchScan scan = {};
    double held_since_s = 0.0;  // when the key was pressed that is held, or told last
    bool are_free = false;      // as KioskParts::are_keys_free

    [[nodiscard]] KeyMeaning meaning_of(const PhysicalKey& key) const {
        return {role_of(table, key),
                key.source == KeySource::key ? action_of(Key{key.code}) : std::nullopt};
    }
};

}  // namespace touchline
