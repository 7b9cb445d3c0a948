// The terms that bound the level of resolution, and the one that decides.
// Threads: plain values and pure functions.
#pragma once

#include <cstdint>

namespace touchline {

enum class LevelTerm : std::uint8_t {
    speed,
    percept,
    finest,
    coarsest,
    encoder,
    radius,
    cost,
    safe
};

/// Levels: 0 is the finest. Levels that the rule computes are whole; the operator's may be
/// fractional.
struct LevelTerms {
    double speed = 0.0;      // at least this coarse for the speed of the hand
    double percept = 0.0;    // coarsest level that no finger can tell from level 0
    double finest = 0.0;     // the operator's bounds; both the same: a fixed level
    double coarsest = 16.0;  //
    double encoder = 0.0;    // finest level that the device can tell
    double radius = 0.0;     // finest level that the proxy's radius does not smooth away
    double cost = 0.0;       // finest level that the tick has time for
    double safe = 16.0;  // coarsest level at which no two outlines meet that did not meet before

    friend bool operator==(const LevelTerms&, const LevelTerms&) = default;
};

struct LevelChoice {
    double level = 0.0;
    LevelTerm by = LevelTerm::speed;
};

/// Returns min(safe, max(encoder, radius, cost, min(coarsest, max(speed, percept, finest)))): if
/// the operator's coarsest is no finer than encoder, radius and cost allow, that is the least of
/// safe, coarsest and the largest of the rest. `by` is the last term that changed the level. A NaN
/// term bounds nothing.
[[nodiscard]] constexpr LevelChoice choose_level(const LevelTerms& terms) {
    LevelChoice chosen;
    const auto at_least = [&chosen](double level, LevelTerm term) {
        if (level > chosen.level) chosen = {level, term};
    };
    const auto at_most = [&chosen](double level, LevelTerm term) {
        if (level < chosen.level) chosen = {level, term};
    };
    at_least(terms.speed, LevelTerm::speed);
    at_least(terms.percept, LevelTerm::percept);
    at_least(terms.finest, LevelTerm::finest);
    at_most(terms.coarsest, LevelTerm::coarsest);
    at_least(terms.encoder, LevelTerm::encoder);
    at_least(terms.radius, LevelTerm::radius);
    at_least(terms.cost, LevelTerm::cost);
    at_most(terms.safe, LevelTerm::safe);
    return chosen;
}

}  // namespace touchline
