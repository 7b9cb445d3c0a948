#include "app/cli/tour.h"

#include "app/documents/decode/map_svg.h"
#include "app/documents/decode/picture.h"
#include "app/visit/proxy_radius.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr const char* circle_and_line = R"(<svg xmlns="http://www.w3.org/2000/svg"
 width="116mm" height="84mm" viewBox="0 0 116 84"><title>Ring</title>
 <circle cx="40" cy="42" r="20" fill="none" stroke="black"/>
 <path d="M80 20 L80 60" fill="none" stroke="black"/></svg>)";

struct Toured {
    TactileMap map;
    Scene scene;
    TourRun run;
};

Toured tour_of(std::string_view svg) {
    TactileMap map = *parse_map_svg(svg);
    map.version = 1;
    Scene scene = *build_scene(map, CurveOptions{.resample = true}, proxy_radius_m);
    TourRun run = take_tour(map, scene);
    return {std::move(map), std::move(scene), std::move(run)};
}

TEST(Tour, GoesToEveryOutlineAndAllTheWayAroundIt) {
    const Toured toured = tour_of(circle_and_line);
    EXPECT_EQ(toured.run.visited, 2);
    const Position centre{-0.018, 0.0};
    std::set<int> tenths_felt;
    for (const TourTick& tick : toured.run.ticks) {
        if (tick.hand.state == ContactState::free || tick.hand.outline != 0) continue;
        const Position from_centre = tick.hand.p_WH - centre;
        const double turn = std::atan2(from_centre.y, from_centre.x) / (2.0 * std::numbers::pi);
        tenths_felt.insert(static_cast<int>(std::floor(10.0 * turn)));
    }
    EXPECT_EQ(tenths_felt.size(), 10u);
}

TEST(Tour, TheProxyStaysOutsideWhereItIsFelt) {
    const Toured toured = tour_of(circle_and_line);
    for (const TourTick& tick : toured.run.ticks) {
        if (tick.hand.state == ContactState::free || tick.hand.outline != 0) continue;
        EXPECT_GT(norm(tick.hand.p_WP - Position{-0.018, 0.0}), 0.020);
    }
}

TEST(Tour, PressesLightly) {
    const TourRun run = tour_of(circle_and_line).run;
    EXPECT_GT(run.mean_force_N, 0.4);
    EXPECT_LT(run.mean_force_N, 1.3);
    EXPECT_LT(run.largest_force_N, 2.0);
    const double time_s = run.period_s * static_cast<double>(run.ticks.size());
    EXPECT_GT(run.contact_s, 0.5 * time_s);
}

TEST(Tour, NothingIsFeltWhileTheHandIsLifted) {
    const TourRun run = tour_of(circle_and_line).run;
    int lifted = 0;
    for (const TourTick& tick : run.ticks) {
        lifted = tick.is_lifted ? lifted + 1 : 0;
        const bool is_faded = lifted > 60;  // the fade takes 50 ms
        EXPECT_TRUE(!is_faded || norm(tick.hand.force) == 0.0);
    }
}

TEST(Tour, IsTheSameEveryTime) {
    const TourRun a = tour_of(circle_and_line).run;
    const TourRun b = tour_of(circle_and_line).run;
    ASSERT_EQ(a.ticks.size(), b.ticks.size());
    for (std::size_t i = 0; i < a.ticks.size(); ++i) {
        ASSERT_EQ(a.ticks[i].hand.p_WH, b.ticks[i].hand.p_WH);
        ASSERT_EQ(a.ticks[i].hand.force, b.ticks[i].hand.force);
    }
}

TEST(Tour, SaysWhatItCameTo) {
    TourRun run;
    run.period_s = 0.001;
    run.ticks.resize(20'000);
    run.outlines = 3;
    run.visited = 2;
    run.contact_s = 15.0;
    run.mean_force_N = 0.87;
    run.largest_force_N = 1.45;
    std::string text;
    for (const std::string& line : describe_tour(run)) text += line;
    for (const char* words : {"2 of 3", "20.0 s", "75 %", "0.87 N", "1.45 N"})
        EXPECT_NE(text.find(words), std::string::npos) << words;
}

class TourFiles : public testing::Test {
  protected:
    void SetUp() override { fs::create_directories(folder_); }

    void TearDown() override { fs::remove_all(folder_); }

    std::string write(const std::string& name, const std::string& text) {
        const fs::path path = folder_ / name;
        std::ofstream(path) << text;
        return path.string();
    }

    fs::path folder_ = fs::path(testing::TempDir()) /
                       testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(TourFiles, ThePictureOfTheTourIsWritten) {
    const std::string output = (folder_ / "run.png").string();
    ASSERT_TRUE(run_tour({write("ring.svg", circle_and_line), false, output}).has_value());
    const auto picture = read_picture(output);
    ASSERT_TRUE(picture.has_value());
    EXPECT_EQ(picture->width, 1600);
    EXPECT_GT(picture->height, 1160);
}

TEST_F(TourFiles, WhatIsNoMapGivesOneLineAndNoFile) {
    const std::string output = (folder_ / "run.png").string();
    const auto result = run_tour({write("bad.svg", "not an svg"), false, output});
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().line.find('\n'), std::string::npos);
    EXPECT_NE(result.error().line.find("bad.svg"), std::string::npos);
    EXPECT_FALSE(fs::exists(output));
}

TEST_F(TourFiles, WhereNothingCanBeWrittenIsOneLine) {
    const std::string output = (folder_ / "no-such-folder" / "run.png").string();
    const auto result = run_tour({write("ring.svg", circle_and_line), false, output});
    ASSERT_FALSE(result.has_value());
    EXPECT_NE(result.error().line.find("run.png"), std::string::npos);
}

}  // namespace
}  // namespace touchline
