#include "tests/app/force/servo/make_kiosk.h"

#include "tests/app/signal_one.h"
#include "tests/app/wait_until.h"

#include <csignal>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchline {

MakeKiosk::MakeKiosk(const std::string& make, const std::string& port,
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

MakeKiosk::~MakeKiosk() {
    const pid_t last = servo();
    kiosk_->kill();
    (void)kiosk_->reap();
    if (last != 0) signal_one(last, SIGKILL);
    while (waitpid(-1, nullptr, 0) > 0) {
    }
    std::filesystem::remove(told_);
}

pid_t MakeKiosk::servo() const {
    const std::string tasks = "/proc/" + std::to_string(pid()) + "/task";
    std::error_code error;
    for (const auto& task : std::filesystem::directory_iterator(tasks, error)) {
        std::ifstream children(task.path() / "children");
        if (pid_t child = 0; children >> child) return child;
    }
    return 0;
}

std::string MakeKiosk::told() const {
    std::ifstream file(told_);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string MakeKiosk::words() const {
    constexpr std::string_view before = "words: ";
    const std::string all = told();
    const auto at = all.rfind(before);
    if (at == std::string::npos) return {};
    const auto from = at + before.size();
    return all.substr(from, all.find('\n', from) - from);
}

bool MakeKiosk::looks_until(const std::function<bool()>& condition) const {
    return wait_until([&] {
        look_(words());
        return condition();
    });
}

}  // namespace touchline
