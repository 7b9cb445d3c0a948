// The whole kiosk without its window on a virtual clock: real gallery, real workers, a folder as
// the stick, a camera of pictures, a simulated pantograph. Threads: one.
#pragma once

#include "app/kiosk/kiosk.h"
#include "app/kiosk/loading/kiosk_stages.h"
#include "config/types/pinned.h"
#include "tests/app/kiosk/read_line.h"
#include "tests/app/kiosk/stepped_servo.h"
#include "tests/machines/sim/kiosk/house.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace touchline {

using SoundMaker =
    std::function<std::unique_ptr<VisitorSound>(const std::shared_ptr<Heard>& heard)>;

class KioskWorld : private Pinned {
  public:
    /// Speaks all languages. `is_in_window`: runs in a desktop window. `gallery`: in these
    /// languages. `finder`: finds main things; empty: there is no network. `make_sound`: what is
    /// heard instead of a sound that only tells heard().
    explicit KioskWorld(bool is_in_window = false, Gallery gallery = whole_gallery(all_languages()),
                        ThingFinder finder = {}, const SoundMaker& make_sound = {});
    ~KioskWorld();

    /// Passes time, frame by frame.
    void run(double for_s);

    /// Presses a key, then steps one frame.
    void press(KeyRole role);

    /// Puts in a stick with these files, and folders with all their contents.
    void put_stick(const std::vector<std::filesystem::path>& files);
    void pull_stick();

    /// Lays this picture under the camera.
    void lay(const std::filesystem::path& picture);

    [[nodiscard]] double now_s() const { return now_s_; }

    [[nodiscard]] Heard& heard() { return *heard_; }

    /// The kiosk's braille line. It is not plugged in at first.
    [[nodiscard]] ReadLine& line() { return *line_; }

    [[nodiscard]] SteppedServo& servo() { return *servo_; }

    [[nodiscard]] Kiosk& kiosk() { return *kiosk_; }

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

    /// The operator's files, in a folder of this world.
    [[nodiscard]] OperatorFiles site_files() const;

    /// The site's printer, once the settings name one. Called on another thread.
    Printing printing{[](const TactileMap&, const PrintOrder&, const std::stop_token&) {
                          return PrintEnd::printed;
                      },
                      [](const std::string&, const std::stop_token&) { return PrintEnd::printed; }};

    int minute_of_day = 12 * 60;
    std::chrono::sys_days today{std::chrono::year(2026) / 3 / 1};

  private:
    double now_s_ = 0.0;
    std::filesystem::path folder_;
    std::shared_ptr<Heard> heard_ = std::make_shared<Heard>();
    std::shared_ptr<ReadLine> line_ = std::make_shared<ReadLine>();
    SteppedServo* servo_ = nullptr;  // owned by the kiosk
    std::unique_ptr<Kiosk> kiosk_;
};

}  // namespace touchline
