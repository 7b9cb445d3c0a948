// Reports sticks as they come and go, however they are detected, and says how their file systems
// are mounted: strictly read-only.
// Threads: a port by one; mount_options() is a pure function.
#pragma once

#include "config/types/pinned.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// usual: FAT and exFAT. more: also ext4 and NTFS, which only the operator allows, because their
/// parsers are large and rarely tried with hostile sticks.
enum class FileSystems : std::uint8_t { usual, more };

/// The options for udisks2 and mount(8), by a file system's kernel name; nothing if it is not
/// mounted.
[[nodiscard]] std::optional<std::string> mount_options(std::string_view file_system,
                                                       FileSystems allowed);

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
class StickPort : public Interface {
  public:
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

/// The watched folder if the settings name one, else udisks2. The folder may be missing. What is
/// mounted on it or put into it is offered; a change of its files is reported as gone and ready. It
/// is checked twice a second, so it should be local: a check of a network folder may wait.
[[nodiscard]] std::unique_ptr<StickPort> open_stick_port(const std::string& watched_folder);

}  // namespace touchline
