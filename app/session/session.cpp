#include "app/session/session.h"

#include <algorithm>
#include <cmath>

namespace touchline {

namespace {

/// What is wanted now, as a new job.
Step load(Session session) {
    if (session.picture_count == 0 && session.is_listed) return {std::move(session), {}};
    ++session.request;
    session.is_loading = true;
    session.message.clear();
    return {std::move(session), {.load = true}};
}

Step load_picture(Session session, int picture) {
    if (session.picture_count == 0) return {std::move(session), {}};
    session.picture = (picture + session.picture_count) % session.picture_count;
    session.is_listed = true;
    session.place = {};
    return load(std::move(session));
}

/// The next (+1) or previous (-1) of the list; where the wanted one is no longer in it, the first
/// or the last.
Step step_picture(const Session& session, int change) {
    if (session.is_listed) return load_picture(session, session.picture + change);
    return load_picture(session, change > 0 ? 0 : -1);
}

Step load_detail(Session session, int detail) {
    session.detail = detail;
    return load(std::move(session));
}

Step tell_end(Session session, const char* line) {
    session.message = line;
    return {std::move(session), {}};
}

/// `view` of the page `change` pages on.
Step step_page(Session session, int change, int view) {
    const int page = session.place.page + change;
    if (page < 1) return tell_end(std::move(session), "This is the first page.");
    if (page > session.place.page_count)
        return tell_end(std::move(session), "This is the last page.");
    session.place = {page, session.place.page_count, view, 0};
    return load(std::move(session));
}

/// Through the views of a page, and on to those of the next. While nobody knows how many there are
/// every number may be one.
Step step_view(Session session, int change) {
    PagePlace& place = session.place;
    const bool is_unknown = place.view_count == 0 && session.is_loading;
    const int last = is_unknown ? last_view : std::max(place.view_count, 1);
    const int view = std::min(place.view, last) + change;
    if (view < 1) return step_page(std::move(session), -1, last_view);
    if (view > last) return step_page(std::move(session), +1, 1);
    place.view = view;
    return load(std::move(session));
}

Step fix_level(Session session, double level) {
    const double coarsest = session.shown.coarsest_level;
    const double whole = std::isfinite(level) ? std::clamp(std::round(level), 0.0, coarsest) : 0.0;
    session.is_level_automatic = false;
    session.fixed_level = static_cast<int>(whole);
    return {std::move(session), {.feel = true}};
}

/// One level coarser (+1) or finer (-1) than what is felt or fixed now.
Step step_level(const Session& session, double felt_level, int change) {
    const double now = session.is_level_automatic ? std::round(felt_level) : session.fixed_level;
    return fix_level(session, now + change);
}

Step toggle_level_automatic(Session session, double felt_level) {
    if (session.is_level_automatic) return fix_level(std::move(session), felt_level);
    session.is_level_automatic = true;
    return {std::move(session), {.feel = true}};
}

/// Stays at the end of the steps rather than wrapping: firm must never turn soft under a hand.
Step change_stiffness(Session session, int change) {
    const int last = static_cast<int>(stiffness_steps.size()) - 1;
    const int step = std::clamp(static_cast<int>(session.stiffness) + change, 0, last);
    session.stiffness = static_cast<std::size_t>(step);
    return {std::move(session), {.feel = true}};
}

Step next_mode(Session session) {
    constexpr std::array order{Mode::wall, Mode::groove, Mode::ridge, Mode::stay};
    session.mode = order[(static_cast<std::size_t>(session.mode) + 1) % order.size()];
    return {std::move(session), {.feel = true}};
}

Step toggle_pop_through(Session session) {
    session.is_pop_through = !session.is_pop_through;
    return {std::move(session), {.feel = true}};
}

Step toggle_force(Session session) {
    session.is_force_wanted = !session.is_force_wanted;
    return {std::move(session), {.feel = true}};
}

Step emergency_stop(Session session) {
    session.is_emergency_stop = true;
    return {std::move(session), {.feel = true}};
}

Step clear_fault(Session session) {
    session.is_emergency_stop = false;
    ++session.faults_cleared;
    return {std::move(session), {.feel = true}};
}

Step toggle(Session session, bool Session::*flag) {
    session.*flag = !(session.*flag);
    return {std::move(session), {}};
}

}  // namespace

Step start_session(int picture_count, double loop_N_per_m, const Settings& settings) {
    Session session;
    session.stiffness = first_stiffness(std::min(loop_N_per_m, settings.stiffness_N_per_m));
    session.mode = static_cast<Mode>(settings.mode);
    session.detail = settings.detail;
    session.is_pop_through = settings.gives_way;
    session.is_level_automatic = settings.is_level_automatic;
    session.fixed_level = settings.fixed_level;
    session.picture_count = picture_count;
    Step step = load_picture(std::move(session), 0);
    step.commands.feel = true;
    return step;
}

Step press_key(const Session& session, Key key, double felt_level) {
    const auto pressed = action_of(key);
    if (!pressed) return {session, {}};
    switch (pressed->action) {
        case Action::next_picture:
            return step_picture(session, +1);
        case Action::previous_picture:
            return step_picture(session, -1);
        case Action::next_view:
            return step_view(session, +1);
        case Action::previous_view:
            return step_view(session, -1);
        case Action::next_page:
            return step_page(session, +1, 1);
        case Action::previous_page:
            return step_page(session, -1, 1);
        case Action::set_detail:
            return load_detail(session, coarsest_detail + pressed->argument);
        case Action::toggle_level_automatic:
            return toggle_level_automatic(session, felt_level);
        case Action::coarser_level:
            return step_level(session, felt_level, +1);
        case Action::finer_level:
            return step_level(session, felt_level, -1);
        case Action::firmer:
            return change_stiffness(session, +1);
        case Action::softer:
            return change_stiffness(session, -1);
        case Action::next_mode:
            return next_mode(session);
        case Action::toggle_pop_through:
            return toggle_pop_through(session);
        case Action::toggle_force:
            return toggle_force(session);
        case Action::emergency_stop:
            return emergency_stop(session);
        case Action::clear_fault:
            return clear_fault(session);
        case Action::keep_recording:
            return {session, {.keep_recording = true}};
        case Action::home_again:
            return {session, {.home_again = true}};
        case Action::toggle_boxes:
            return toggle(session, &Session::shows_boxes);
        case Action::toggle_keys:
            return toggle(session, &Session::shows_keys);
        case Action::next_sounds:
        case Action::toggle_speech:
        case Action::repeat_speech:
        case Action::stop_speech:
        case Action::pause_speech:
        case Action::slower_speech:
        case Action::faster_speech:
        case Action::softer_sound:
        case Action::louder_sound:
        case Action::next_language:
        case Action::headphones_in:
        case Action::headphones_out:
            return {session, {.sound = pressed->action}};
        case Action::quit:
            return {session, {.quit = true}};
    }
    return {session, {}};
}

Step picture_ready(const Session& session, std::uint64_t request, const LoadedFacts& facts) {
    if (request != session.request) return {session, {}};
    Session next = session;
    next.is_loading = false;
    if (!facts.note.empty()) next.message = facts.note;  // what was told meanwhile stays
    next.place = facts.place;
    next.shown = {session.is_listed ? session.picture + 1 : 0,
                  facts.place,
                  session.detail,
                  facts.title,
                  facts.outline_count,
                  facts.coarsest_level};
    next.fixed_level = std::min(session.fixed_level, facts.coarsest_level);
    return {std::move(next), {.feel = true}};
}

Step picture_failed(const Session& session, std::uint64_t request, std::string line,
                    const PagePlace& place) {
    if (request != session.request) return {session, {}};
    Session next = session;
    next.is_loading = false;
    next.message = std::move(line);
    next.place.page_count = std::max(session.place.page_count, place.page_count);
    next.place.view_count = std::max(session.place.view_count, place.view_count);
    return {std::move(next), {}};
}

Step list_changed(const Session& session, const ListChange& change) {
    Session next = session;
    next.picture_count = change.picture_count;
    next.is_listed = change.wanted.has_value();
    next.picture = change.wanted.value_or(0);
    if (session.shown.number > 0 || change.shown)
        next.shown.number = change.shown ? *change.shown + 1 : 0;
    return {std::move(next), {}};
}

Step choose_picture(const Session& session, int picture) {
    return load_picture(session, picture);
}

Step tell(const Session& session, std::string line) {
    Session next = session;
    next.message = std::move(line);
    return {std::move(next), {}};
}

}  // namespace touchline
