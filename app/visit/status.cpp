#include "app/visit/status.h"

#include "app/visit/page_place.h"
#include "app/visit/told_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace touchline {

namespace {

// In the order of their enumerations.
constexpr std::array reasons{"by speed",
                             "finer feels the same",
                             "the finest set",
                             "the coarsest set",
                             "the device tells no finer",
                             "finer than the proxy",
                             "finer takes too long",
                             "the coarsest safe"};
constexpr std::array contacts{"free", "on a line", "at a corner"};
constexpr std::array events{"touched a line", "left the line",       "passed a corner",
                            "crossed a line", "end of the line",     "another level",
                            "another line",   "back in the picture", "edge of the picture",
                            "pushed through"};
constexpr std::array<const char*, force_state_count> states{
    "off", "waiting until the hand is clear of lines", "coming on", "on", "stopped"};
constexpr std::array<const char*, limit_count> limits{
    "",
    "",
    "",
    "",
    "",
    "less: the motors are warm",
    "damped: it pushed too much",
    "less: the arms of the device are nearly straight",
    "only braking: the hand is fast",
    "fading: nobody seems to hold the handle",
    "none: out of reach",
    ""};

/// The name of an enumerator; empty for a number that is none.
template <class Enumerator, std::size_t count>
const char* name_in(const std::array<const char*, count>& names, Enumerator enumerator) {
    const auto at = static_cast<std::size_t>(enumerator);
    return at < count ? names[at] : "";
}

std::string detail_text(int detail, const Language& language) {
    return language.text(
        "panel", "{0} of {1}, {2}",
        {std::to_string(detail), "5",
         language.text("detail",
                       detail_names[static_cast<std::size_t>(std::clamp(detail, 1, 5) - 1)])});
}

/// A level, or one of its bounds, rounded to a tenth.
std::string level_number(double level, const Language& language) {
    const double tenths = std::round(level * 10.0) / 10.0;
    return language.number(tenths, tenths == std::round(tenths) ? 0 : 1);
}

/// The level felt, and why that one is wanted. A fixed level has no other reason, and is called
/// fixed only once it is reached.
std::string level_words(int coarsest_level, const HandState& hand, const Language& language) {
    const LevelChoice wanted = choose_level(hand.level_terms);
    const bool is_fixed = !hand.is_level_auto && wanted.level == hand.level_terms.coarsest;
    return language.text(
        "panel", "{0} of {1}, {2}",
        {level_number(hand.level, language), std::to_string(coarsest_level),
         language.text("level", is_fixed ? "fixed" : name_in(reasons, wanted.by))});
}

/// All terms of the level, for the operator.
std::string terms_words(const LevelTerms& terms, const Language& language) {
    const auto told = [&](double level) { return level_number(level, language); };
    return language.text(
        "level", "speed {0}, touch {1}, set {2} to {3}, device {4}, proxy {5}, time {6}, safe {7}",
        {told(terms.speed), told(terms.percept), told(terms.finest),
         told(std::min(terms.coarsest, terms.safe)), told(terms.encoder), told(terms.radius),
         told(terms.cost), told(terms.safe)});
}

/// The stiffness felt. It rises slowly, so that it cannot push the hand.
std::string stiffness_words(const HandState& hand, const Language& language) {
    return language.measured("unit", "{0} newton per metre", "{0} newtons per metre",
                             std::round(hand.stiffness_N_per_m));
}

std::string force_words(const HandState& hand, const ForceStatus& status,
                        const Language& language) {
    const std::string force = language.number(norm(hand.force), 1);
    if (const auto why = words_of(status.limit); !why.empty())
        return language.text("force", "{0} N, {1}",
                             {force, language.text("force", std::string(why))});
    if (hand.spring_gain >= 1.0) return language.text("force", "{0} N", {force});
    return language.text("force", "{0} N, softened to {1} %: it vibrated",
                         {force, language.number(100.0 * hand.spring_gain, 0)});
}

/// "a bar, -4.2 mN m": torque on the hand, counter-clockwise.
std::string shape_words(const HandState& hand, const Language& language) {
    const std::string name =
        language.text("shape", shape_names[static_cast<std::size_t>(hand.shape)]);
    if (!hand.is_shape_placed) return language.text("panel", "{0}, a line goes through it", {name});
    return language.text("panel", "{0}, {1} mN m",
                         {name, language.number(1000.0 * hand.torque_Nm, 1)});
}

std::string mode_words(const HandState& hand, bool has_pop_through, const Language& language) {
    const bool is_soft = hand.mode == Mode::wall && has_pop_through;
    return language.text("mode", words_of(hand.mode)) +
           (is_soft ? language.text("mode", ", gives way to a push") : "");
}

}  // namespace

std::string words_of(Mode mode) {
    return name_in(mode_names, mode);
}

std::string words_of(ContactState state) {
    return name_in(contacts, state);
}

std::string words_of(ContactEventKind kind) {
    return name_in(events, kind);
}

std::string_view words_of(ForceState state) {
    return name_in(states, state);
}

std::string_view words_of(Limit limit) {
    return name_in(limits, limit);
}

Status describe(const LiveFacts& facts, const HandState& hand, const ForceStatus& force,
                const Language& language) {
    const auto say = [&](const char* context, std::string_view english) {
        return language.text(context, std::string(english));
    };
    Status status;
    status.title = facts.title.empty() ? say("panel", "No picture yet") : facts.title;
    const auto add = [&](const char* name, std::string value) {
        status.lines.push_back({say("panel", name), std::move(value)});
    };
    add("Contact", say("contact", words_of(hand.state)));
    add("Last", say("event", facts.last ? words_of(facts.last->kind) : "nothing yet"));
    add("Level", level_words(facts.coarsest_level, hand, language));
    add("Terms", terms_words(hand.level_terms, language));
    add("Force", force_words(hand, force, language));
    add("Motors", say("force", words_of(force.state)));
    add("Kind of line", mode_words(hand, facts.has_pop_through, language));
    add("Firmness", stiffness_words(hand, language));
    add("Detail", detail_text(facts.detail, language));
    if (hand.shape != HeldShape::none) add("Shape", shape_words(hand, language));
    if (std::string page = words_of(facts.place, language); !page.empty())
        add("Picture", std::move(page));
    if (!facts.hand_words.empty())
        add("Hand", language.text("panel", facts.hand_words, {facts.hand_name}));
    status.message =
        force.fault == Fault::none ? facts.message : staffs_fault(force.fault, language);
    return status;
}

}  // namespace touchline
