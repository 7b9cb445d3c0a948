// Paths on a stick, opened so that nothing leads out of it: no link, no "..", no other file system.
// Threads: any.
#pragma once

#include "app/process/descriptor.h"
#include "app/sticks/refusal.h"

#include <string>

namespace touchline {

/// `name` in the open folder, for reading; -1 with the reason in errno. Never waits for a FIFO's
/// writer; does not mark the file as read where the file system lets us choose. `flags`:
/// O_DIRECTORY, or O_PATH for what is only to be looked at.
[[nodiscard]] Descriptor open_beneath(const Descriptor& folder, const std::string& name, int flags);

/// What an errno of the stick means for a visitor.
[[nodiscard]] StickRefusal refusal_of(int error);

}  // namespace touchline
