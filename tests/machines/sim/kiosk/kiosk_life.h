// One kiosk process at a simulated site: the real kiosk with simulated sound, loader, stick and
// camera, and its end of the line to the servo. Threads: one.
#pragma once

#include "app/force/servo/running_servo.h"
#include "app/force/servo/servo_connection.h"
#include "app/kiosk/kiosk.h"
#include "tests/app/kiosk/read_line.h"
#include "tests/machines/sim/kiosk/due_jobs.h"
#include "tests/machines/sim/kiosk/house.h"
#include "tests/machines/sim/kiosk/line_servo.h"
#include "tests/machines/sim/kiosk/sim_printer.h"
#include "tests/machines/sim/kiosk/sim_sources.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

namespace touchline {

/// What the site gives a kiosk. All must outlive it.
struct KioskPlace {
    const double& now_s;           // site time
    std::filesystem::path folder;  // for the operator's files
    std::shared_ptr<Heard> heard;
    std::function<JobFate()> fate;
    std::function<int()> minute_of_day;
    SimPrinter* printer = nullptr;  // null: the site has none
    bool has_braille = false;
};

class KioskLife {
  public:
    explicit KioskLife(const KioskPlace& place);

    /// Presses a key of the staff's keyboard.
    void press(Key key) { strike({KeySource::key, static_cast<std::uint32_t>(key)}); }

    /// Presses a visitor's key.
    void press(KeyRole role) { strike(keys_of(default_keys(), role).at(0)); }

    ServoConnection line;
    Restart restart;  // of its servo
    // Owned by the kiosk:
    LineServo* servo = nullptr;
    SimFileSource* sticks = nullptr;
    SimCamera* camera = nullptr;
    DueJobs* jobs = nullptr;
    std::shared_ptr<ReadLine> braille;  // null: the site has none
    std::unique_ptr<Kiosk> kiosk;

  private:
    /// Strikes at site time, as a window stamps it: the kiosk's own time stands still while it
    /// hangs.
    void strike(const PhysicalKey& key);

    const double& now_s_;
};

}  // namespace touchline
