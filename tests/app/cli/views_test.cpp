// Tests that every command and the kiosk see the same view and the same lines of a picture.
#include "app/cli/options.h"
#include "app/cli/tour.h"
#include "app/documents/decode/files.h"
#include "app/documents/decode/map_svg.h"
#include "app/documents/decode/picture.h"
#include "app/kiosk/loading/kiosk_stages.h"
#include "tests/app/documents/decode/files_of_formats.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

// A part of a turned square, used a second time.
constexpr const char* svg_of_uses =
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 200 150'>"
    "<defs><clipPath id='c'><rect width='70' height='200'/></clipPath>"
    "<rect id='r' width='60' height='60' style='transform:rotate(20deg)'/></defs>"
    "<g clip-path='url(#c)'><use href='#r' x='30' y='40' fill='#207040'/></g>"
    "<use href='#r' transform='translate(130 40) scale(.7)' fill='none' stroke='black' "
    "stroke-width='3'/></svg>";

Picture disc() {
    Picture picture{160, 120, std::vector<std::uint8_t>(160 * 120 * 3, 255)};
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x)
            if (std::hypot(x - 80.0, y - 60.0) < 40.0)
                std::fill_n(picture.bgr.begin() + 3 * (160 * y + x), 3, 20);
    return picture;
}

/// Two figures; the first is so small that it is drawn again.
encoders::Bytes pdf_of_two_figures() {
    return drawn_pdf({{{100, 600, 150, 100}, {100, 100, 200, 300}}});
}

class Views : public testing::Test {
  protected:
    void SetUp() override {
        fs::create_directories(folder_);
        std::ofstream(path("uses.svg")) << svg_of_uses;
        ASSERT_TRUE(write_png(path("disc.png"), disc()));
        ASSERT_TRUE(write_whole_file(path("figures.pdf"), pdf_of_two_figures()));
        std::ofstream hand(path("hand.csv"));  // goes across the middle
        hand << "t_s,x_m,y_m\n";
        for (int i = 0; i < 300; ++i)
            hand << 0.001 * i << "," << 0.0003 * i - 0.045 << "," << 0.001 << "\n";
    }

    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] std::string path(const std::string& name) const {
        return (folder_ / name).string();
    }

    [[nodiscard]] std::string text_of(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream(path(name), std::ios::binary).rdbuf();
        return text.str();
    }

    /// Runs a command; names of files begin with "@".
    int run(std::vector<std::string> arguments) {
        for (std::string& argument : arguments)
            if (argument.starts_with("@")) argument = path(argument.substr(1));
        std::ostringstream out;
        std::ostringstream err;
        const Programs programs{[](const KioskArguments&) { return 0; }, run_tour};
        const int status = run_command_line(arguments, programs, out, err);
        err_ = err.str();
        return status;
    }

    /// Returns what the tour says about the hand's path.
    std::string tour_of(const std::vector<std::string>& arguments) {
        testing::internal::CaptureStdout();
        EXPECT_EQ(run(arguments), 0) << err_;
        const std::string said = testing::internal::GetCapturedStdout();
        const auto begin = said.find("A pen grip");
        return said.substr(begin, said.find("Drawn in") - begin);
    }

    std::string err_;

  private:
    fs::path folder_ =
        fs::path(testing::TempDir()) /
        (std::string("views-") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TactileMap felt_in_the_kiosk(const std::string& path, int view) {
    const KioskStages stages(default_profile());
    const FilePtr file = file_at(path);
    const auto page = stages.open(*file, 1);
    EXPECT_TRUE(page.has_value()) << page.error().line;
    const auto found = stages.find(*file, *page, view, {3});
    EXPECT_TRUE(found.has_value()) << found.error().line;
    const auto scene = stages.build(*file, **found, {3});
    EXPECT_TRUE(scene.has_value()) << scene.error().line;
    return *scene->felt.map;
}

void expect_same_lines(const TactileMap& a, const TactileMap& b) {
    ASSERT_EQ(a.outlines.size(), b.outlines.size());
    EXPECT_FALSE(a.outlines.empty());
    for (std::size_t i = 0; i < a.outlines.size(); ++i) {
        EXPECT_EQ(a.outlines[i].points, b.outlines[i].points) << i;
        EXPECT_EQ(a.outlines[i].is_closed, b.outlines[i].is_closed) << i;
        EXPECT_EQ(a.outlines[i].label, b.outlines[i].label) << i;
    }
}

TEST_F(Views, TraceGivesWhatTheKioskLetsAHandFeel) {
    for (const std::string name : {"uses.svg", "disc.png", "figures.pdf"}) {
        SCOPED_TRACE(name);
        ASSERT_EQ(run({"trace", "@" + name, "--detail", "3", "-o", "@map.svg"}), 0) << err_;
        expect_same_lines(read_map_svg(path("map.svg")).value(), felt_in_the_kiosk(path(name), 1));
    }
}

TEST_F(Views, AreNumberedAsInTheKioskAndTheFirstIsTakenByDefault) {
    std::vector<std::string> maps;
    for (const int view : {1, 2, 3}) {
        SCOPED_TRACE(view);
        ASSERT_EQ(run({"trace", "@figures.pdf", "--view", std::to_string(view), "-o", "@map.svg"}),
                  0)
            << err_;
        expect_same_lines(read_map_svg(path("map.svg")).value(),
                          felt_in_the_kiosk(path("figures.pdf"), view));
        maps.push_back(text_of("map.svg"));
    }
    EXPECT_NE(maps[0], maps[1]);
    EXPECT_NE(maps[1], maps[2]);
    EXPECT_NE(maps[0], maps[2]);
    ASSERT_EQ(run({"trace", "@figures.pdf", "-o", "@default.svg"}), 0) << err_;
    EXPECT_EQ(text_of("default.svg"), maps[0]);
}

TEST_F(Views, OneBeyondTheLastIsOneLineAndNoneIsWrongUsage) {
    EXPECT_EQ(run({"trace", "@figures.pdf", "--view", "4", "-o", "@map.svg"}), 1);
    EXPECT_NE(err_.find("3 views"), std::string::npos) << err_;
    EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
    EXPECT_EQ(run({"trace", "@disc.png", "--view", "2", "-o", "@map.svg"}), 1);
    EXPECT_NE(err_.find("one view"), std::string::npos) << err_;
    EXPECT_EQ(run({"trace", "@figures.pdf", "--view", "0", "-o", "@map.svg"}), 2);
    EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
    EXPECT_FALSE(fs::exists(path("map.svg")));
}

TEST_F(Views, OfAPictureAndOfItsTracedMapAreTheSameBitForBit) {
    for (const std::string name : {"uses.svg", "disc.png", "figures.pdf"}) {
        SCOPED_TRACE(name);
        ASSERT_EQ(run({"trace", "@" + name, "-o", "@map.svg"}), 0) << err_;
        for (const bool is_map : {false, true}) {
            const std::string input = is_map ? "@map.svg" : "@" + name;
            const std::string output = is_map ? "@of-map" : "@of-picture";
            std::vector<std::string> feel{"feel", input, "--path", "@hand.csv", "-o", output};
            std::vector<std::string> curve{"curve", input, "--level", "1.5", "-o", output + ".svg"};
            if (name == "uses.svg" && !is_map)
                for (auto* command : {&feel, &curve}) command->emplace_back("--picture");
            ASSERT_EQ(run(feel), 0) << err_;
            ASSERT_EQ(run(curve), 0) << err_;
        }
        EXPECT_EQ(text_of("of-picture"), text_of("of-map"));
        EXPECT_NE(text_of("of-map").find("edge"), std::string::npos);
        EXPECT_EQ(text_of("of-picture.svg"), text_of("of-map.svg"));
    }
}

TEST_F(Views, TheTourGoesRoundTheFirst) {
    ASSERT_EQ(run({"trace", "@figures.pdf", "-o", "@map.svg"}), 0) << err_;
    EXPECT_EQ(tour_of({"tour", "@figures.pdf", "-o", "@run.png"}),
              tour_of({"tour", "@map.svg", "-o", "@run.png"}));
}

}  // namespace
}  // namespace touchline
