// Sticks as they come and go, wherever that is known from.
// Threads: one.
#pragma once

#include "app/sticks/mount_options.h"

#include <cstdint>
#include <string>
#include <vector>

namespace touchline {

/// ready: files can be read below `root`. gone: no longer, whatever is being read. refused: a stick
/// is there that cannot be read; `sentence` says why and what to do.
enum class StickNews : std::uint8_t { ready, gone, refused };

struct StickEvent {
    StickNews news = StickNews::gone;
    std::string root;
    std::string sentence;

    friend bool operator==(const StickEvent&, const StickEvent&) = default;
};

/// One stick at a time: the one that came last. Another ready comes only after gone.
class StickPort {
  public:
    StickPort() = default;
    virtual ~StickPort() = default;
    StickPort(const StickPort&) = delete;
    StickPort(StickPort&&) = delete;
    StickPort& operator=(const StickPort&) = delete;
    StickPort& operator=(StickPort&&) = delete;

    /// What happened since, in order. `now_ns` of the monotonic clock. Never waits; to be called
    /// several times a second.
    [[nodiscard]] virtual std::vector<StickEvent> poll(std::int64_t now_ns) = 0;

    /// Which file systems are mounted from now on. Of no meaning where nothing is mounted.
    virtual void allow(FileSystems allowed) = 0;

    /// The visitor is done: the stick is let go, and not offered again before it was pulled out.
    virtual void end_session() = 0;

    /// False while sticks could come and nobody would tell; the operator has to be told that.
    [[nodiscard]] virtual bool is_watching() const = 0;
};

}  // namespace touchline
