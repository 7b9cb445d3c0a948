// Reports sticks as they come and go, however they are detected.
// Threads: one.
#pragma once

#include "app/sticks/mount_options.h"

#include <cstdint>
#include <string>
#include <vector>

namespace touchline {

/// ready: files can be read below `root`. gone: they cannot be read any more, not even a file being
/// read. refused: a stick cannot be read; `sentence` says why and what to do.
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

    /// What has happened since the last call, in order. `now_ns` is of the monotonic clock. Never
    /// waits; call it several times a second.
    [[nodiscard]] virtual std::vector<StickEvent> poll(std::int64_t now_ns) = 0;

    /// Sets the file systems that are mounted from now on. Has no effect if nothing is mounted.
    virtual void allow(FileSystems allowed) = 0;

    /// The visitor is done: the stick is released, and not offered again before it was pulled out.
    virtual void end_session() = 0;

    /// False while sticks could come unnoticed; the operator must be told.
    [[nodiscard]] virtual bool is_watching() const = 0;
};

}  // namespace touchline
