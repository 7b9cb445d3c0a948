// A kiosk and its servo as real processes, with a device of any make, which the test emulates. No
// test here judges the machine's speed: limits of the wall clock are far off.
#pragma once

#include "app/isolation/process/child.h"
#include "config/types/pinned.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include <sys/types.h>

namespace touchline {

class MakeKiosk : private Pinned {
  public:
    /// `look`: what the person at the handle does at each look, a thousand times a second, with the
    /// words that count now.
    MakeKiosk(const std::string& make, const std::string& port,
              std::function<void(const std::string& words)> look);

    ~MakeKiosk();

    [[nodiscard]] pid_t pid() const { return kiosk_->pid(); }

    /// The only child of the kiosk's guard; 0 if there is none.
    [[nodiscard]] pid_t servo() const;

    /// All that kiosk and servo said.
    [[nodiscard]] std::string told() const;

    /// The device's words that count now; empty: nothing is to be done.
    [[nodiscard]] std::string words() const;

    /// Looks until the condition holds, or about two minutes have passed: a guard that had to kill
    /// its servo on a busy machine waits longer each time.
    [[nodiscard]] bool looks_until(const std::function<bool()>& condition) const;

  private:
    std::function<void(const std::string&)> look_;
    std::filesystem::path told_;
    std::unique_ptr<Child> kiosk_;  // a pointer, since GCC 14 takes a Child in an optional for
                                    // uninitialised
};

}  // namespace touchline
