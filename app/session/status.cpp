#include "app/session/status.h"

#include "app/session/fault_words.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace touchline {

namespace {

constexpr std::array<std::string_view, 5> details{"silhouette", "main parts", "parts", "fine parts",
                                                  "everything"};

/// Empty where there is one page that is felt as a whole.
std::string page_words(const PagePlace& place) {
    const std::string page = fmt::format("{} of {}", place.page, place.page_count);
    if (place.view_count <= 1) return place.page_count > 1 ? page : "";
    const bool is_of_things = place.things == ThingSearch::found;
    if (place.view == place.view_count)
        return page + (is_of_things ? ", the whole photograph" : ", the whole page");
    if (is_of_things)
        return fmt::format("{}, main thing {} of {}", page, place.view, place.view_count - 1);
    return fmt::format("{}, picture {} of {}", page, place.view, place.view_count - 1);
}

std::string detail_text(int detail) {
    return fmt::format("{} of 5, {}", detail, detail_words(detail));
}

std::string reason_words(LevelTerm term) {
    switch (term) {
        case LevelTerm::speed:
            return "by speed";
        case LevelTerm::percept:
            return "finer feels the same";
        case LevelTerm::finest:
            return "the finest set";
        case LevelTerm::coarsest:
            return "the coarsest set";
        case LevelTerm::encoder:
            return "the device tells no finer";
        case LevelTerm::radius:
            return "finer than the proxy";
        case LevelTerm::cost:
            return "finer takes too long";
        case LevelTerm::safe:
            return "the coarsest safe";
    }
    return {};
}

double tenths(double level) {
    return std::round(level * 10.0) / 10.0;
}

/// The level felt, and why that one is wanted. A fixed level is not said to be by anything else,
/// nor to be fixed where it is not reached.
std::string level_words(int coarsest_level, const HandState& hand) {
    const LevelChoice wanted = choose_level(hand.level_terms);
    const bool is_fixed = !hand.is_level_auto && wanted.level == hand.level_terms.coarsest;
    return fmt::format("{} of {}, {}", tenths(hand.level), coarsest_level,
                       is_fixed ? "fixed" : reason_words(wanted.by));
}

/// All terms of the level, for the operator.
std::string terms_words(const LevelTerms& terms) {
    return fmt::format("speed {}, touch {}, set {} to {}, device {}, proxy {}, time {}, safe {}",
                       terms.speed, terms.percept, tenths(terms.finest),
                       tenths(std::min(terms.coarsest, terms.safe)), terms.encoder, terms.radius,
                       terms.cost, terms.safe);
}

/// What is felt: a rise is slow, so that it cannot push the hand.
std::string stiffness_words(const HandState& hand) {
    return fmt::format("{:.0f} N/m", hand.stiffness_N_per_m);
}

std::string force_words(const HandState& hand, const ForceStatus& status) {
    const std::string force = fmt::format("{:.1f} N", norm(hand.force));
    if (const auto why = words_of(status.limit); !why.empty()) {
        return fmt::format("{}, {}", force, why);
    }
    if (hand.spring_gain >= 1.0) return force;
    return fmt::format("{}, softened to {:.0f} %: it vibrated", force, 100.0 * hand.spring_gain);
}

/// "bar, -4.2 mN m": torque on the hand, counter-clockwise.
std::string shape_words(const HandState& hand) {
    constexpr std::array names{"point", "disc", "bar", "angle", "key"};
    const char* const name = names[static_cast<std::size_t>(hand.shape)];
    if (!hand.is_shape_placed) return fmt::format("{}, a line goes through it", name);
    return fmt::format("{}, {:.1f} mN m", name, 1000.0 * hand.torque_Nm);
}

std::string mode_words(const HandState& hand, bool gives_way) {
    const bool is_soft = hand.mode == Mode::wall && gives_way;
    return words_of(hand.mode) + (is_soft ? ", gives way to a push" : "");
}

}  // namespace

std::string_view detail_words(int detail) {
    return details[static_cast<std::size_t>(std::clamp(detail, 1, 5) - 1)];
}

std::string words_of(Mode mode) {
    switch (mode) {
        case Mode::wall:
            return "wall";
        case Mode::groove:
            return "groove";
        case Mode::ridge:
            return "ridge";
        case Mode::stay:
            return "stay on line";
    }
    return {};
}

std::string words_of(ContactState state) {
    switch (state) {
        case ContactState::free:
            return "free";
        case ContactState::edge:
            return "on a line";
        case ContactState::vertex:
            return "at a corner";
    }
    return {};
}

std::string words_of(ContactEventKind kind) {
    switch (kind) {
        case ContactEventKind::contact_made:
            return "touched a line";
        case ContactEventKind::contact_lost:
            return "left the line";
        case ContactEventKind::vertex_passed:
            return "passed a corner";
        case ContactEventKind::line_crossed:
            return "crossed a line";
        case ContactEventKind::end_reached:
            return "end of the line";
        case ContactEventKind::level_changed:
            return "another level";
        case ContactEventKind::outline_changed:
            return "another line";
        case ContactEventKind::area_entered:
            return "back in the picture";
        case ContactEventKind::area_left:
            return "edge of the picture";
        case ContactEventKind::popped_through:
            return "pushed through";
    }
    return {};
}

Status describe(const LiveFacts& facts, const HandState& hand, const ForceStatus& force) {
    Status status;
    status.title = facts.title.empty() ? "No picture yet" : facts.title;
    status.lines = {
        {"Contact", words_of(hand.state)},
        {"Last", facts.last ? words_of(facts.last->kind) : "nothing yet"},
        {"Level", level_words(facts.coarsest_level, hand)},
        {"Terms", terms_words(hand.level_terms)},
        {"Force", force_words(hand, force)},
        {"Motors", std::string(words_of(force.state))},
        {"Kind of line", mode_words(hand, facts.gives_way)},
        {"Firmness", stiffness_words(hand)},
        {"Detail", detail_text(facts.detail)},
        {"Hand", facts.hand_words},
    };
    if (hand.shape != HeldShape::none)
        status.lines.insert(status.lines.end() - 1, {"Shape", shape_words(hand)});
    if (const std::string page = page_words(facts.place); !page.empty())
        status.lines.insert(status.lines.end() - 1, {"Page", page});
    status.message = force.fault == Fault::none ? facts.message : announcement_of(force.fault);
    return status;
}

}  // namespace touchline
