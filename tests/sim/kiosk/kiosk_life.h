// One kiosk process in a simulated house: the real kiosk with sound, loader, stick and camera that
// a simulation leads, and its end of the line to the servo.
// Threads: one.
#pragma once

#include "app/kiosk/kiosk.h"
#include "app/servo/restart.h"
#include "app/servo/servo_connection.h"
#include "tests/sim/kiosk/due_jobs.h"
#include "tests/sim/kiosk/heard.h"
#include "tests/sim/kiosk/line_servo.h"
#include "tests/sim/kiosk/sim_camera.h"
#include "tests/sim/kiosk/sim_file_source.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

namespace touchline {

/// What a kiosk has of the house. All must outlive it.
struct KioskPlace {
    const double& now_s;           // of the house
    std::filesystem::path folder;  // of the operator's files
    std::shared_ptr<Heard> heard;
    std::function<JobFate()> fate;
    std::function<int()> minute_of_day;
};

class KioskLife {
  public:
    explicit KioskLife(const KioskPlace& place);

    /// A key of the staff's keyboard.
    void press(Key key) { strike({KeySource::key, static_cast<std::uint32_t>(key)}); }

    /// A visitor's key.
    void press(KeyRole role) { strike(keys_of(default_keys(), role).at(0)); }

    ServoConnection line;
    Restart restart;  // of its servo
    // Within the kiosk:
    LineServo* servo = nullptr;
    SimFileSource* sticks = nullptr;
    SimCamera* camera = nullptr;
    DueJobs* jobs = nullptr;
    std::unique_ptr<Kiosk> kiosk;

  private:
    /// Now by the house's time, as a window stamps it: the kiosk's own stands while it hangs.
    void strike(const PhysicalKey& key);

    const double& now_s_;
};

}  // namespace touchline
