// One file of a stick, copied into memory.
// Threads: any, each call by itself; a call waits for the stick.
#pragma once

#include "app/process/descriptor.h"
#include "app/sticks/refusal.h"
#include "config/types/result.h"

#include <cstddef>
#include <functional>
#include <string>

namespace touchline {

struct CopyLimits {
    std::size_t most_bytes = 0;
    std::function<bool()> is_time_up = [] { return false; };  // asked before every block
};

/// Copies `name` (in `folder` of the stick, as StickEntry has it) to the end of `output`. Only a
/// regular file is read: no link on the way is followed, and of anything else not a byte is asked
/// for. A file that grows or shrinks meanwhile is refused. After a refusal `output` may hold a
/// part. O(bytes).
[[nodiscard]] Result<void, StickRefusal> copy_from_stick(const Descriptor& root,
                                                         const std::string& folder,
                                                         const std::string& name,
                                                         const Descriptor& output,
                                                         const CopyLimits& limits);

}  // namespace touchline
