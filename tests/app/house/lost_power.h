// A process that is gone at any of its steps on the disk, as when the power fails there.
// Threads: one.
#pragma once

#include <functional>

namespace touchline {

/// Runs `work` in a process of its own, which ends without a word before its step number `step`,
/// from 1: every call of the system that writes, flushes, makes, renames, links or removes is one.
/// True if it came to its end before.
[[nodiscard]] bool ends_before_step(int step, const std::function<void()>& work);

}  // namespace touchline
