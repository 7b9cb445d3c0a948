// The servo's recording, from which somebody could draw what a visitor felt. It stays in memory: a
// fault holds it, and the visit's end overwrites it. It becomes a file only when the operator asks.
// Threads: all calls from one thread; it writes on another.
#pragma once

#include "config/types/hand_state.h"
#include "config/types/result.h"
#include "haptics/servo/recording.h"

#include <cstddef>
#include <functional>
#include <future>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// A minute, and room for what may lie before the first step that a file keeps.
inline constexpr double recorded_s = 65.0;

/// The beginning of the line about a file, and of the line if there is none.
inline constexpr std::string_view recording_kept = "a recording was kept: ";
inline constexpr std::string_view recording_not_kept = "a recording was not kept: ";

[[nodiscard]] inline std::size_t recorded_ticks(double period_s) {
    return static_cast<std::size_t>(recorded_s / period_s);
}

/// TOUCHLINE_RECORDINGS of the environment if it is set, else touchline/ in the user's state folder
/// (XDG_STATE_HOME or .local/state). Empty: there is none.
[[nodiscard]] std::string recordings_folder();

class BlackBox {
  public:
    /// `tell` receives one line for every file that was asked for. The newest eight files are kept.
    BlackBox(std::string folder, std::string profile, std::function<void(const std::string&)> tell);

    /// Called when a map is about to be felt.
    void remember(const RecordedMap& map);

    /// The last minute stays unchanged in memory until it is kept or forgotten.
    void hold() { is_hold_wanted_ = true; }

    /// The operator wants the recording as a file. It begins anew after that.
    void keep() { is_keep_wanted_ = true; }

    /// The visitor is gone: the recording is overwritten and begins anew. A file that was asked for
    /// is not written, unless its writing has begun.
    void forget();

    /// Called some times a second. A new fault holds the recording.
    void update(Recorder& recorder, Fault fault);

  private:
    void do_what_is_wanted(Recorder& recorder);
    void let_go(Recorder& recorder);
    void wipe(Recorder& recorder);
    void begin_writing(Recorder& recorder);
    void finish_writing(Recorder& recorder);

    std::string folder_;
    std::string profile_;
    std::function<void(const std::string&)> tell_;
    std::vector<RecordedMap> maps_;
    bool is_hold_wanted_ = false;
    bool is_keep_wanted_ = false;
    bool is_forget_wanted_ = false;
    bool is_holding_ = false;  // the recorder was asked to hold
    Fault last_fault_ = Fault::none;
    std::future<Result<std::string>> writing_;  // gives the path
};

}  // namespace touchline
