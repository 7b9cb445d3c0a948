// What a stick offers, as it comes and goes, wherever that is known from: the seam between the
// kiosk and the real sticks (stick_source.h). Threads: one; no call waits.
#pragma once

#include "app/loading/stages.h"
#include "app/sticks/listing.h"
#include "app/sticks/mount_options.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// The files that a stick offers now; none: it went, or offers nothing.
struct FilesChange {
    std::vector<FilePtr> files;
    std::string sentence;  // why there are none, for the person; may be empty
    StickRest rest = {};   // what the stick has beyond the files
    bool is_read = false;  // its files were looked for: where there are none, it has none
};

class FileSource {
  public:
    FileSource() = default;
    virtual ~FileSource() = default;
    FileSource(const FileSource&) = delete;
    FileSource(FileSource&&) = delete;
    FileSource& operator=(const FileSource&) = delete;
    FileSource& operator=(FileSource&&) = delete;

    /// The last thing that changed. Several times a second; `now_ns` of the monotonic clock.
    [[nodiscard]] virtual std::optional<FilesChange> poll(std::int64_t now_ns) = 0;

    /// Files of a stick are being looked for.
    [[nodiscard]] virtual bool is_listing() const = 0;

    /// See StickPort.
    virtual void allow(FileSystems allowed) = 0;

    /// The visitor is done: see StickPort.
    virtual void end_session() = 0;

    /// Of the stick that is there; empty: none.
    [[nodiscard]] virtual const std::string& root() const = 0;

    /// False while sticks could come and nobody would tell.
    [[nodiscard]] virtual bool is_watching() const = 0;
};

}  // namespace touchline
