// What the kiosk is doing: a pure state machine. A key or the end of a loading job comes in, the
// new state and what has to be done about it come out. Threads: values and pure functions.
#pragma once

#include "app/session/keys.h"
#include "app/session/page_place.h"
#include "config/settings/settings.h"
#include "config/types/hand_state.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace touchline {

/// A named step of stiffness, as an operator chooses it.
struct StiffnessStep {
    double stiffness_N_per_m;
    std::string_view name;
};

/// Softest first. The firmest stays below the stability limit of a light hand at 1 kHz (733 N/m).
inline constexpr std::array stiffness_steps{
    StiffnessStep{200.0, "very soft"}, StiffnessStep{350.0, "soft"}, StiffnessStep{500.0, "medium"},
    StiffnessStep{700.0, "firm"}};

/// At this stiffness a groove of the ordinary capture width, 3 mm, holds by 0.5 N at most; more
/// would lead the hand rather than tell it of the line.
inline constexpr double groove_N_per_m = 580.0;

/// Where the operator has not chosen: the firmest step that suits the loop (loop_settings.h) and a
/// groove, at least the softest.
[[nodiscard]] constexpr std::size_t first_stiffness(double loop_N_per_m) {
    std::size_t step = 0;
    while (step + 1 < stiffness_steps.size() &&
           stiffness_steps[step + 1].stiffness_N_per_m <= std::min(loop_N_per_m, groove_N_per_m)) {
        ++step;
    }
    return step;
}

/// Radius of the proxy: 1.4 F / K at 0.7 N and 700 N/m, so that the force stays continuous around
/// corners at every step of stiffness in ordinary exploration.
inline constexpr double proxy_radius_m = 0.0014;

inline constexpr int coarsest_detail = 1;
inline constexpr int finest_detail = 5;

/// The picture that is felt and shown.
struct ShownPicture {
    int number = 0;  // 1 ... picture_count; 0: none yet, or no longer in the list
    PagePlace place;
    int detail = 3;
    std::string title;
    int outline_count = 0;
    int coarsest_level = 0;
};

struct Session {
    int picture_count = 0;  // of the list
    int picture = 0;        // wanted, from 0
    bool is_listed = true;  // false: the wanted one has left the list; what comes next is its first
    PagePlace place;        // wanted, of the picture
    int detail = 3;         // wanted, 1 ... 5
    std::uint64_t request = 0;  // number of the last loading job asked for
    bool is_loading = false;
    ShownPicture shown;
    std::string message;  // one line; empty: nothing to say

    bool is_level_automatic = true;
    int fixed_level = 0;                                      // 0 ... shown.coarsest_level
    std::size_t stiffness = first_stiffness(groove_N_per_m);  // in stiffness_steps
    Mode mode = Mode::groove;
    bool is_pop_through = false;  // a wall gives way to a push that is meant
    bool is_force_wanted = true;
    bool is_emergency_stop = false;    // until the operator clears it
    std::uint32_t faults_cleared = 0;  // counts up
    bool shows_boxes = false;
    bool shows_keys = false;
};

/// What has to be done after a step.
struct Commands {
    bool load = false;  // picture, place and detail that are wanted, as job session.request
    bool feel = false;  // hand level, stiffness, mode, pop-through and force to the servo
    bool keep_recording = false;                 // of the last minute
    bool home_again = false;                     // the handle's home is to be found anew
    std::optional<Action> sound = std::nullopt;  // a key for sound or speech (app/sound)
    bool quit = false;
};

struct Step {
    Session session;
    Commands commands;
};

/// Asks for the first picture of the list. `picture_count` >= 0; `loop_N_per_m`: the stiffness that
/// the loop suggests to start with.
[[nodiscard]] Step start_session(int picture_count, double loop_N_per_m = groove_N_per_m,
                                 const Settings& settings = {});

/// A key went down while the hand felt `felt_level`: a level that becomes fixed stays where it was.
[[nodiscard]] Step press_key(const Session& session, Key key, double felt_level);

/// Loading job `request` is done and its map is felt. A job that is no longer wanted changes
/// nothing.
[[nodiscard]] Step picture_ready(const Session& session, std::uint64_t request,
                                 const LoadedFacts& facts);

/// Loading job `request` failed: what was felt and shown before stays, and `line` says what
/// happened. `place`: what is known of the document by now.
[[nodiscard]] Step picture_failed(const Session& session, std::uint64_t request, std::string line,
                                  const PagePlace& place = {});

/// Another list of `picture_count` pictures; where the wanted and the shown one are in it, from 0,
/// if they are.
struct ListChange {
    int picture_count = 0;
    std::optional<int> wanted;
    std::optional<int> shown;
};

/// What is felt stays.
[[nodiscard]] Step list_changed(const Session& session, const ListChange& change);

/// Asks for a picture of the list, from 0.
[[nodiscard]] Step choose_picture(const Session& session, int picture);

/// One sentence for the person, e.g. of a stick.
[[nodiscard]] Step tell(const Session& session, std::string line);

}  // namespace touchline
