// What a stick offers, as sticks come and go. This is the interface between the kiosk and the real
// sticks (stick_source.h). Threads: one; no call waits.
#pragma once

#include "app/loading/stages.h"
#include "app/sticks/listing.h"
#include "app/sticks/mount_options.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// The files that a stick offers now. None: it was removed, or offers nothing.
struct FilesChange {
    std::vector<FilePtr> files;
    std::string sentence;  // why there are no files, for the person; may be empty
    StickRest rest = {};   // what the stick holds beside the files
    bool is_read = false;  // the search for files has ended; if there are none, the stick has none
};

class FileSource {
  public:
    FileSource() = default;
    virtual ~FileSource() = default;
    FileSource(const FileSource&) = delete;
    FileSource(FileSource&&) = delete;
    FileSource& operator=(const FileSource&) = delete;
    FileSource& operator=(FileSource&&) = delete;

    /// Returns the latest change. Called several times a second; `now_ns` is of the monotonic
    /// clock.
    [[nodiscard]] virtual std::optional<FilesChange> poll(std::int64_t now_ns) = 0;

    /// True while a stick's files are being listed.
    [[nodiscard]] virtual bool is_listing() const = 0;

    /// See StickPort.
    virtual void allow(FileSystems allowed) = 0;

    /// The visitor is done. See StickPort.
    virtual void end_session() = 0;

    /// The root of the plugged-in stick; empty: none.
    [[nodiscard]] virtual const std::string& root() const = 0;

    /// False while sticks could come unnoticed.
    [[nodiscard]] virtual bool is_watching() const = 0;
};

}  // namespace touchline
