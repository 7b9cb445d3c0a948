// Drives a mocked board, with or without permission. Threads: one.
#pragma once

#include "config/types/pinned.h"
#include "haptics/device/board/pantograph_board.h"
#include "haptics/servo/real_time.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <unistd.h>

namespace touchline {

/// While it lives, this process is an ordinary user who cannot open the file.
class Unprivileged : private Pinned {
  public:
    Unprivileged(const std::string& file, const std::string& folder) : file_(file) {
        // umockdev's own sockets stay open to everybody.
        std::filesystem::permissions(folder, std::filesystem::perms(0755));
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder + "/ioctl"))
            std::filesystem::permissions(entry, std::filesystem::perms(0777));
        std::filesystem::permissions(file_, std::filesystem::perms::none);
        if (geteuid() == 0) (void)!seteuid(65534);
    }

    ~Unprivileged() {
        if (getuid() == 0) (void)!seteuid(0);
        std::filesystem::permissions(file_, std::filesystem::perms(0600));
    }

  private:
    std::string file_;
};

/// A driver through the library, ticked in real time.
class Drive {
  public:
    explicit Drive(std::unique_ptr<BoardLink> link,
                   const DeviceProfile& profile = default_profile())
        : driver(std::move(link), profile, {}), start_ns_(clock_.now_ns()) {}

    std::optional<JointAngles> tick(JointTorques torques) {
        clock_.sleep_until(start_ns_ + ++ticks_ * 1000000);
        const auto angles =
            driver.read_angles(1e-9 * static_cast<double>(clock_.now_ns() - start_ns_));
        is_written = driver.write_torques(angles ? torques : JointTorques{});
        return angles;
    }

    /// Ticks until angles came and torque went, at most 3 s.
    bool tick_until_good(JointTorques torques) {
        for (int k = 0; k < 3000; ++k)
            if (tick(torques) && is_written && driver.report().state == BoardState::ready)
                return true;
        return false;
    }

    PantographBoard driver;
    bool is_written = false;

  private:
    MonotonicClock clock_;
    std::int64_t start_ns_;
    std::int64_t ticks_ = 0;
};

}  // namespace touchline
