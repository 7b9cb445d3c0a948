// Opens paths on a stick so that nothing leads out of it: no link, no "..", no other file system.
// Threads: any.
#pragma once

#include "app/process/descriptor.h"
#include "app/sticks/refusal.h"

#include <string>

namespace touchline {

/// Opens `name` in the open folder for reading; -1 with the reason in errno. Never waits for a
/// FIFO's writer. Does not change the file's access time if the file system allows that. `flags`:
/// O_DIRECTORY, or O_PATH to examine the file only.
[[nodiscard]] Descriptor open_beneath(const Descriptor& folder, const std::string& name, int flags);

/// The meaning of a stick's errno for a visitor.
[[nodiscard]] StickRefusal refusal_of(int error);

}  // namespace touchline
