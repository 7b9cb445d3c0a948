#include "tests/app/kiosk/kiosk_world.h"

#include "app/documents/sticks/stick_port.h"
#include "app/isolation/process/places.h"
#include "app/kiosk/stick_source.h"
#include "tests/machines/sim/kiosk/due_jobs.h"
#include "vision/camera/folder_camera.h"

#include <chrono>
#include <thread>
#include <utility>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr double frame_s = 1.0 / 60.0;

Result<cv::Mat> read_bgr(const fs::path& file) {
    auto picture = read_picture(file.string());
    if (!picture) return tl::unexpected(picture.error());
    return cv::Mat(picture->height, picture->width, CV_8UC3, picture->bgr.data()).clone();
}

/// Each test has its own folder, as tests may run at once.
fs::path own_folder_of_test() {
    const auto* const info = testing::UnitTest::GetInstance()->current_test_info();
    return fs::path(testing::TempDir()) / (std::to_string(getpid()) + "-" + info->name());
}

}  // namespace

KioskWorld::KioskWorld(bool is_in_window, Gallery gallery, ThingFinder finder,
                       const SoundMaker& make_sound)
    : folder_(own_folder_of_test()) {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "camera");
    auto servo = std::make_unique<SteppedServo>();
    servo_ = servo.get();
    KioskParts parts;
    parts.languages = all_languages();
    parts.gallery = std::move(gallery);
    parts.servo = std::move(servo);
    parts.sound = make_sound ? make_sound(heard_) : std::make_unique<HeardSound>(heard_);
    parts.braille = std::make_unique<ReadBraille>(line_);
    parts.profile = default_profile();
    parts.loader = std::make_unique<Loader>(
        std::make_shared<const KioskStages>(parts.profile, PageReader(), std::move(finder)),
        std::make_unique<DueJobs>(now_s_));
    parts.sticks = std::make_unique<StickSource>(open_stick_port((folder_ / "stick").string()),
                                                 companion("touchline-import"));
    parts.photos = std::make_unique<PhotoCapture>(
        std::make_unique<FolderCamera>(folder_ / "camera", read_bgr));
    parts.printer = std::make_unique<SheetPrinter>(
        Printing{[this](const TactileMap& map, const PrintOrder& order,
                        const std::stop_token& stop) { return printing.print(map, order, stop); },
                 [this](const std::string& queue, const std::stop_token& stop) {
                     return printing.check(queue, stop);
                 }});
    std::vector<std::string> problems;
    parts.operator_session =
        std::make_unique<OperatorSession>(site_files(), parts.languages, problems);
    EXPECT_TRUE(problems.empty()) << problems.front();
    parts.are_keys_free = is_in_window;
    parts.settings = parts.operator_session->settings();
    parts.keys = parts.operator_session->keys();
    parts.minute_of_day = [this] { return minute_of_day; };
    parts.today = [this] { return today; };
    kiosk_ = std::make_unique<Kiosk>(std::move(parts));
}

OperatorFiles KioskWorld::site_files() const {
    return site_files_in(folder_ / "site");
}

KioskWorld::~KioskWorld() {
    kiosk_.reset();
    fs::remove_all(folder_);
}

void KioskWorld::run(double for_s) {
    const double end_s = now_s_ + for_s;
    while (now_s_ < end_s) {
        now_s_ += frame_s;
        heard_->now_s = line_->now_s = now_s_;
        servo_->run_until(now_s_);
        kiosk_->step(static_cast<std::int64_t>(1e9 * now_s_));
    }
}

void KioskWorld::press(KeyRole role) {
    kiosk_->press(role);
    run(frame_s);
}

void KioskWorld::put_stick(const std::vector<fs::path>& files) {
    fs::create_directories(folder_ / "arriving");
    for (const fs::path& file : files)
        fs::copy(file, folder_ / "arriving" / file.filename(), fs::copy_options::recursive);
    fs::rename(folder_ / "arriving", folder_ / "stick");
    // A process watches and lists the folder in real time.
    for (int i = 0; i < 200 && !kiosk_->visit().visitor.stick_list; ++i) {
        run(0.2);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

void KioskWorld::pull_stick() {
    fs::remove_all(folder_ / "stick");
    run(3.0);
}

void KioskWorld::lay(const fs::path& picture) {
    for (const auto& old : fs::directory_iterator(folder_ / "camera")) fs::remove(old.path());
    fs::copy(picture, folder_ / "camera" / picture.filename());
    run(3.0);
}

}  // namespace touchline
