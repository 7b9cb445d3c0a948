// Reads paths of a stick so that nothing leads out of it: no link, no "..", no other file system.
// Threads: any, each call by itself; a call waits for the stick.
#pragma once

#include "app/process/descriptor.h"
#include "app/sticks/listing.h"
#include "config/types/result.h"

#include <cstddef>
#include <functional>
#include <string>

namespace touchline {

/// Opens `name` in the open folder for reading; -1 with the reason in errno. Never waits for a
/// FIFO's writer. Does not change the file's access time if the file system allows that. `flags`:
/// O_DIRECTORY, or O_PATH to examine the file only.
[[nodiscard]] Descriptor open_beneath(const Descriptor& folder, const std::string& name, int flags);

/// The meaning of a stick's errno for a visitor.
[[nodiscard]] StickRefusal refusal_of(int error);

struct CopyLimits {
    std::size_t most_bytes = 0;
    std::function<bool()> is_time_up = [] { return false; };  // called before every block
};

/// Copies `name` (in `folder` of the stick, as in StickEntry) to the end of `output`. Reads only a
/// regular file: follows no link on the way, and reads not a byte of anything else. Refuses a file
/// that grows or shrinks meanwhile. After a refusal `output` may hold a part. O(bytes).
[[nodiscard]] Result<void, StickRefusal> copy_from_stick(const Descriptor& root,
                                                         const std::string& folder,
                                                         const std::string& name,
                                                         const Descriptor& output,
                                                         const CopyLimits& limits);

}  // namespace touchline
