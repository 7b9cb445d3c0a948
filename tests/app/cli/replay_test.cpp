// Tests feel --replay on recordings of a servo that felt a picture of the gallery.

#include "app/cli/load.h"
#include "app/cli/options.h"
#include "app/documents/decode/files.h"
#include "app/documents/gallery/gallery.h"
#include "app/force/servo/scene_order.h"
#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/servo/recording.h"
#include "haptics/servo/servo_loop.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr const char* fish = "06-fish.svg";

/// A hand that wanders over the fish for three seconds.
Recording record_fish(bool as_visitors) {
    TactileMap map = load_drawing(gallery_folder() + "/" + fish, 3).value();
    map.version = 5;
    const auto scene =
        std::make_shared<const Scene>(build_scene(map, felt_order(default_profile())).value());
    std::vector<WaypointPath::Waypoint> way{{0.0, {0.05, 0.038}}, {0.8, {0.05, 0.038}}};
    for (int i = 1; i < 10; ++i)
        way.push_back({0.8 + 0.3 * i, {0.03 * std::sin(1.3 * i), 0.02 * std::cos(2.1 * i)}});
    SimulatedPantograph device(default_profile(), {}, std::make_shared<WaypointPath>(way));
    ServoExchange exchange;
    exchange.feel(scene);
    Recorder recorder(4000);
    ServoLoop loop(device, default_profile(), 1e-3, exchange, recorder);
    for (int k = 0; k < 3000; ++k) loop.tick(1e-3 * k, 0);
    return make_recording(recorder, std::string(default_profile().name),
                          {{5, as_visitors ? "" : fish, 3, hash_of(map)}});
}

class Replay : public testing::Test {
  protected:
    void SetUp() override { fs::create_directories(folder_); }

    void TearDown() override { fs::remove_all(folder_); }

    int replay(const Recording& recording) {
        EXPECT_TRUE(write_whole_file(box_, bytes_of(recording)).has_value());
        return replay_file();
    }

    int replay_file() {
        return run_command_line({"feel", "--replay", box_, "-o", run_}, {}, out_, err_);
    }

    [[nodiscard]] int rows() const {
        std::ifstream file(run_);
        std::string line;
        int count = -1;  // the first line names the columns
        while (std::getline(file, line)) ++count;
        return count;
    }

    fs::path folder_ = fs::path(testing::TempDir()) /
                       testing::UnitTest::GetInstance()->current_test_info()->name();
    std::string box_ = folder_ / "box.rec";
    std::string run_ = folder_ / "run.csv";
    std::ostringstream out_;
    std::ostringstream err_;
};

TEST_F(Replay, OfAGalleryPictureIsTheSameBitForBit) {
    const Recording recording = record_fish(false);
    EXPECT_TRUE(std::any_of(recording.ticks.begin(), recording.ticks.end(),
                            [](const TickRecord& tick) { return norm(tick.force) > 0.3; }));
    EXPECT_EQ(replay(recording), 0) << err_.str();
    EXPECT_EQ(out_.str(), "3000 ticks run again: the same, bit for bit\n");
    EXPECT_EQ(rows(), 3000);
}

TEST_F(Replay, WhatIsNotTheSameIsSaidAndTheTableWritten) {
    Recording recording = record_fish(false);
    recording.ticks[2000].p_WP.x += 1e-12;
    EXPECT_EQ(replay(recording), 1);
    EXPECT_NE(err_.str().find("not the same from 2 s on"), std::string::npos) << err_.str();
    EXPECT_EQ(rows(), 3000);
}

TEST_F(Replay, OfAVisitorsPictureTheRowsAreThoseRecorded) {
    EXPECT_EQ(replay(record_fish(true)), 0);
    EXPECT_NE(out_.str().find("not run again"), std::string::npos);
    EXPECT_EQ(rows(), 3000);
}

TEST_F(Replay, WhatCannotBeRunAgainIsOneLineAndNoFile) {
    const Recording good = record_fish(false);
    for (int kind = 0; kind < 5; ++kind) {
        Recording bad = good;
        if (kind == 0) bad.maps[0].hash += 1;
        if (kind == 1) bad.maps[0].gallery_file = "../pictures/06-fish.svg";
        if (kind == 2) bad.maps[0].gallery_file = "none.svg";
        if (kind == 3) bad.maps.clear();
        if (kind == 4) bad.profile = "none";
        err_.str("");
        EXPECT_EQ(replay(bad), 1) << kind;
        const std::string said = err_.str();
        EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
        EXPECT_FALSE(fs::exists(run_)) << kind;
    }
    std::ofstream(box_) << "no recording";
    EXPECT_EQ(replay_file(), 1);
    EXPECT_NE(err_.str().find(box_), std::string::npos);
}

TEST_F(Replay, TakesNoPictureAndNoPathBesides) {
    for (const auto& more : {std::vector<std::string>{"map.svg"}, {"--path", "hand.csv"}}) {
        std::vector<std::string> words{"feel", "--replay", box_, "-o", run_};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(run_command_line(words, {}, out_, err_), 2);
    }
    EXPECT_EQ(run_command_line({"feel", "-o", run_}, {}, out_, err_), 2);
}

}  // namespace
}  // namespace touchline
