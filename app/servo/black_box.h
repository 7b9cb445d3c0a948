// Keeps the servo's recordings as files: after each fault, and when somebody asks.
// Threads: all calls from one thread; it writes on another.
#pragma once

#include "config/types/force_status.h"
#include "config/types/result.h"
#include "haptics/servo/recording.h"

#include <cstddef>
#include <functional>
#include <future>
#include <string>
#include <vector>

namespace touchline {

/// A minute, and as much as may lie before the first step that is kept in it.
inline constexpr double recorded_s = 65.0;

[[nodiscard]] inline std::size_t recorded_ticks(double period_s) {
    return static_cast<std::size_t>(recorded_s / period_s);
}

/// TOUCHLINE_RECORDINGS of the environment if it is set, else touchline/ in the user's folder for
/// such things (XDG_STATE_HOME or .local/state); empty: there is none.
[[nodiscard]] std::string recordings_folder();

class BlackBox {
  public:
    /// `tell` is given one line for every file, written or not. Eight are kept, the newest.
    BlackBox(std::string folder, std::string profile, std::function<void(const std::string&)> tell);

    /// A map is about to be felt.
    void remember(const RecordedMap& map);

    /// The last minute is wanted as a file.
    void keep() { is_wanted_ = true; }

    /// Now and then, some times a second. A fault that was not there before asks for a file. The
    /// recorder is held while it is read, and begins anew after it.
    void update(Recorder& recorder, Fault fault);

  private:
    void finish(Recorder& recorder);

    std::string folder_;
    std::string profile_;
    std::function<void(const std::string&)> tell_;
    std::vector<RecordedMap> maps_;
    bool is_wanted_ = false;
    bool is_holding_ = false;
    Fault last_fault_ = Fault::none;
    std::future<Result<std::string>> writing_;  // the path
};

}  // namespace touchline
