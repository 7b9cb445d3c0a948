// A kiosk and its servo as real processes, with a device of any make, which the test emulates. No
// test here judges the machine's speed: limits of the wall clock are far off.
#pragma once

#include "app/isolation/process/child.h"
#include "config/types/pinned.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <string>

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>

namespace touchline {

class MakeKiosk : private Pinned {
  public:
    /// `look`: what the person at the handle does at each look, a thousand times a second, with the
    /// words that count now.
    MakeKiosk(const std::string& make, const std::string& port,
              std::function<void(const std::string& words)> look)
        : look_(std::move(look)),
          told_(std::filesystem::path(testing::TempDir()) /
                ("touchline-told-" + std::to_string(getpid()))) {
        // Servos of dead kiosks become children of this process.
        prctl(PR_SET_CHILD_SUBREAPER, 1UL, 0UL, 0UL, 0UL);
        kiosk_ = std::make_unique<Child>(
            Child::start(TOUCHLINE_SERVO_RIG, {"make-kiosk", make, port, told_.string()}, {},
                         StandardStreams::ours, {"LD_PRELOAD=" TOUCHLINE_SOCKET_TERMINAL})
                .value());
    }

    ~MakeKiosk() {
        const pid_t last = servo();
        kiosk_->kill();
        (void)kiosk_->reap();
        if (last != 0) kill(last, SIGKILL);
        while (waitpid(-1, nullptr, 0) > 0) {
        }
        std::filesystem::remove(told_);
    }

    [[nodiscard]] pid_t pid() const { return kiosk_->pid(); }

    /// The only child of the kiosk's guard; 0 if there is none.
    [[nodiscard]] pid_t servo() const {
        const std::string tasks = "/proc/" + std::to_string(pid()) + "/task";
        std::error_code error;
        for (const auto& task : std::filesystem::directory_iterator(tasks, error)) {
            std::ifstream children(task.path() / "children");
            if (pid_t child = 0; children >> child) return child;
        }
        return 0;
    }

    /// All that kiosk and servo said.
    [[nodiscard]] std::string told() const {
        std::ifstream file(told_);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    /// The device's words that count now; empty: nothing is to be done.
    [[nodiscard]] std::string words() const {
        constexpr std::string_view before = "words: ";
        const std::string all = told();
        const auto at = all.rfind(before);
        if (at == std::string::npos) return {};
        const auto from = at + before.size();
        return all.substr(from, all.find('\n', from) - from);
    }

    /// Looks until the condition holds, or about two minutes have passed: a guard that had to kill
    /// its servo on a busy machine waits longer each time.
    [[nodiscard]] bool looks_until(const std::function<bool()>& condition) const {
        constexpr int longest_wait_ms = 100'000;
        for (int i = 0; i < longest_wait_ms; ++i) {
            look_(words());
            if (condition()) return true;
            poll(nullptr, 0, 1);
        }
        return false;
    }

  private:
    std::function<void(const std::string&)> look_;
    std::filesystem::path told_;
    std::unique_ptr<Child> kiosk_;  // a pointer, since GCC 14 takes a Child in an optional for
                                    // uninitialised
};

}  // namespace touchline
