// Tests every option of trace, curve and feel through the command line, as a user types it.
#include "app/cli/hand_csv.h"
#include "app/cli/options.h"
#include "app/documents/decode/files.h"
#include "app/documents/decode/map_svg.h"
#include "app/documents/decode/picture.h"
#include "haptics/contact/contact_machine.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using Row = std::map<std::string, std::string>;

double number(const std::string& text) {
    double value = std::nan("");
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

/// A separate folder for each test, and a command line that works in it.
class Cli : public testing::Test {
  protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() /
                  (std::string("touchline-cli-") + info->name() + "-" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
        write("map.svg",
              "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 116 84'><path id='wall' "
              "d='M 8 42 L 108 42'/><path id='ring' data-detail='2' d='M 58 20 m -10 0 a 10 10 0 1 "
              "0 20 0 "
              "a 10 10 0 1 0 -20 0 z'/></svg>");
        // Goes down onto the wall at y = 0, along it, and off again.
        std::string hand = "t_s,x_m,y_m\n";
        for (int i = 0; i < 300; ++i) {
            const double y =
                i < 100 ? 0.005 - 0.00008 * i : (i < 200 ? -0.003 : -0.003 + 0.00008 * (i - 200));
            hand += std::to_string(0.001 * i) + "," + std::to_string(0.0001 * i - 0.02) + "," +
                    std::to_string(y) + "\n";
        }
        write("hand.csv", hand);
    }

    void TearDown() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::string path(const std::string& name) const {
        return (folder_ / name).string();
    }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name), std::ios::binary) << text;
    }

    [[nodiscard]] std::string text_of(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream(path(name), std::ios::binary).rdbuf();
        return text.str();
    }

    [[nodiscard]] bool exists(const std::string& name) const {
        return std::filesystem::exists(folder_ / name);
    }

    int run(std::vector<std::string> arguments) {
        for (std::string& argument : arguments) {
            if (argument.starts_with("@")) argument = path(argument.substr(1));
        }
        out_.str("");
        err_.str("");
        const Programs programs{[this](const KioskArguments& kiosk) {
                                    kiosk_ = kiosk;
                                    return 0;
                                },
                                [this](const TourArguments& tour) {
                                    tour_ = tour;
                                    return Result<void>{};
                                }};
        return run_command_line(arguments, programs, out_, err_);
    }

    int feel(std::vector<std::string> options, const std::string& output = "run.csv") {
        std::vector<std::string> arguments{"feel",      "@map.svg", "--path",
                                           "@hand.csv", "-o",       "@" + output};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return run(arguments);
    }

    [[nodiscard]] std::vector<Row> rows(const std::string& name = "run.csv") const {
        std::istringstream text(text_of(name));
        std::string line;
        std::getline(text, line);
        const auto names = split(line);
        std::vector<Row> all;
        while (std::getline(text, line)) {
            const auto values = split(line);
            EXPECT_EQ(values.size(), names.size());
            Row row;
            for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = values[i];
            all.push_back(row);
        }
        return all;
    }

    /// Writes a disc on white, 160 x 120.
    void write_disc() const {
        Picture picture{160, 120, std::vector<std::uint8_t>(160 * 120 * 3, 255)};
        for (int y = 0; y < 120; ++y) {
            for (int x = 0; x < 160; ++x) {
                if (std::hypot(x - 80.0, y - 60.0) > 40.0) continue;
                for (int c = 0; c < 3; ++c)
                    picture.bgr[static_cast<std::size_t>((y * 160 + x) * 3 + c)] = 20;
            }
        }
        ASSERT_TRUE(write_png(path("disc.png"), picture));
    }

    [[nodiscard]] std::string err() const { return err_.str(); }

    [[nodiscard]] std::ptrdiff_t lines_of_err() const {
        const std::string text = err();
        return std::count(text.begin(), text.end(), '\n');
    }

    [[nodiscard]] std::string out() const { return out_.str(); }

    KioskArguments kiosk_;
    TourArguments tour_;

  private:
    static std::vector<std::string> split(const std::string& line) {
        std::vector<std::string> parts{""};
        for (const char c : line) {
            if (c == ',') {
                parts.emplace_back();
            } else {
                parts.back() += c;
            }
        }
        return parts;
    }

    std::filesystem::path folder_;
    std::ostringstream out_;
    std::ostringstream err_;
};

TEST_F(Cli, FeelWritesTheColumnsOfTheContractOneRowARow) {
    ASSERT_EQ(feel({"--level", "0"}), 0) << err();
    EXPECT_TRUE(text_of("run.csv").starts_with(
        "t_s,x_m,y_m,proxy_x_m,proxy_y_m,fx_N,fy_N,state,level,outline,parameter,side,transitions,"
        "carried_m,nodes,clear\n"));
    const auto run = rows();
    ASSERT_EQ(run.size(), 300U);
    EXPECT_EQ(run[0].at("state"), "free");
    EXPECT_EQ(run[0].at("outline"), "");
    EXPECT_EQ(run[150].at("state"), "edge");
    EXPECT_EQ(run[150].at("outline"), "0");
    EXPECT_EQ(run[150].at("side"), "left");
    EXPECT_EQ(run[150].at("transitions"), "1");
    EXPECT_NEAR(number(run[150].at("fy_N")), 1.5, 1e-6);
    EXPECT_EQ(run[150].at("carried_m"), "0");
    EXPECT_EQ(run[150].at("clear"), "1");
    for (const Row& row : run) {
        const double x = 500.0 * (number(row.at("proxy_x_m")) - number(row.at("x_m")));
        const double y = 500.0 * (number(row.at("proxy_y_m")) - number(row.at("y_m")));
        ASSERT_NEAR(number(row.at("fx_N")), x, 1e-9);
        ASSERT_NEAR(number(row.at("fy_N")), y, 1e-9);
    }
    EXPECT_EQ(run[299].at("state"), "free");
}

TEST_F(Cli, FeelIsTheSameEveryTimeButForTiming) {
    ASSERT_EQ(feel({}, "a.csv"), 0);
    ASSERT_EQ(feel({}, "b.csv"), 0);
    EXPECT_EQ(text_of("a.csv"), text_of("b.csv"));
    ASSERT_EQ(feel({"--timing"}, "c.csv"), 0);
    EXPECT_GT(number(rows("c.csv")[50].at("step_ns")), 0.0);
}

TEST_F(Cli, FeelTakesStiffnessFrictionRadiusAndCapture) {
    ASSERT_EQ(feel({"--stiffness", "1000"}), 0);
    EXPECT_NEAR(number(rows()[150].at("fy_N")), 3.0, 1e-6);
    ASSERT_EQ(feel({"--friction", "0.5"}), 0);
    EXPECT_NEAR(number(rows()[199].at("fx_N")), -0.5 * 1.5, 1e-6);
    ASSERT_EQ(feel({"--radius", "0.002"}), 0);
    EXPECT_NEAR(number(rows()[150].at("proxy_y_m")), 0.002, 1e-12);
    ASSERT_EQ(feel({"--mode", "groove", "--capture", "0.002"}), 0);
    EXPECT_EQ(number(rows()[150].at("fy_N")), 0.0);  // 3 mm away
}

TEST_F(Cli, FeelWithAShapeAddsAngleAndTorque) {
    write("bar.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 30 30'>"
          "<path d='M 5 14 L 25 14 L 25 16 L 5 16 Z'/></svg>");
    std::string hand = "t_s,x_m,y_m,angle_rad\n";  // goes down onto the wall, tilted, and off again
    for (int i = 0; i < 300; ++i) {
        const double y = i < 150 ? 0.008 - 0.00008 * i : -0.004 + 0.00008 * (i - 150);
        hand += std::to_string(0.001 * i) + ",-0.02," + std::to_string(y) + ",0.2\n";
    }
    write("hand.csv", hand);
    ASSERT_EQ(feel({"--probe", path("bar.svg"), "--level", "0"}), 0) << err();
    EXPECT_TRUE(text_of("run.csv").starts_with(
        "t_s,x_m,y_m,proxy_x_m,proxy_y_m,fx_N,fy_N,state,level,outline,parameter,side,transitions,"
        "carried_m,nodes,clear,angle_rad,proxy_angle_rad,torque_Nm\n"));
    const auto run = rows();
    ASSERT_EQ(run.size(), 300U);
    EXPECT_EQ(run[0].at("state"), "free");
    EXPECT_EQ(number(run[0].at("torque_Nm")), 0.0);
    EXPECT_EQ(number(run[0].at("angle_rad")), 0.2);
    const Row& deep = run[150];
    EXPECT_EQ(deep.at("state"), "vertex");  // it has turned until it lies on the wall
    EXPECT_EQ(deep.at("outline"), "0");
    EXPECT_EQ(deep.at("side"), "left");
    EXPECT_NEAR(number(deep.at("proxy_angle_rad")), 0.0, 1e-6);
    EXPECT_NEAR(number(deep.at("proxy_y_m")), 0.001, 1e-6);
    EXPECT_NEAR(number(deep.at("fy_N")), 500.0 * 0.005, 1e-3);
    const double r_m = std::hypot(0.01, 0.001);
    EXPECT_NEAR(number(deep.at("torque_Nm")), -0.2 * 500.0 * r_m * r_m, 1e-6);
    EXPECT_EQ(run[299].at("state"), "free");
    ASSERT_EQ(feel({"--probe", path("bar.svg")}, "auto.csv"), 0) << err();
    EXPECT_EQ(rows("auto.csv").size(), 300U);
    ASSERT_EQ(feel({"--probe", path("bar.svg"), "--timing"}, "timed.csv"), 0) << err();
    EXPECT_GT(number(rows("timed.csv")[50].at("step_ns")), 0.0);
}

TEST_F(Cli, FeelSaysWhatIsWrongWithAShape) {
    write("bar.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 30 30'>"
          "<path d='M 5 14 L 25 14 L 25 16 L 5 16 Z'/></svg>");
    EXPECT_EQ(feel({"--probe", path("bar.svg")}), 1);  // the path has no angle
    EXPECT_NE(err().find("angle_rad"), std::string::npos) << err();
    write("hand.csv", "t_s,x_m,y_m,angle_rad\n0,0,0.02,0\n");
    EXPECT_EQ(feel({"--probe", path("bar.svg")}), 0) << err();
    EXPECT_EQ(feel({"--probe", path("missing.svg")}, "b.csv"), 1);
    EXPECT_EQ(lines_of_err(), 1) << err();
    write("far.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 300'>"
          "<path d='M 5 14 L 25 14'/></svg>");
    EXPECT_EQ(feel({"--probe", path("far.svg")}, "b.csv"), 1);
    EXPECT_NE(err().find("far.svg"), std::string::npos) << err();
    EXPECT_FALSE(exists("b.csv"));
    EXPECT_EQ(feel({"--probe", path("bar.svg"), "--friction", "0.1"}, "b.csv"), 2);
    EXPECT_EQ(feel({"--probe", path("bar.svg"), "--mode", "groove"}, "b.csv"), 2);
    write("hand.csv", "t_s,x_m,y_m,angle_rad\n0,0,0.02,2000\n");
    EXPECT_EQ(feel({"--probe", path("bar.svg")}, "b.csv"), 1);
}

TEST_F(Cli, FeelHasFourModes) {
    std::map<std::string, double> force;
    for (const std::string mode : {"wall", "groove", "ridge", "stay"}) {
        ASSERT_EQ(feel({"--mode", mode, "--capture", "0.006"}), 0) << err();
        force[mode] = number(rows()[150].at("fy_N"));
    }
    EXPECT_NEAR(force["wall"], 1.5, 1e-6);
    EXPECT_NEAR(force["groove"], 1.5 * std::pow(0.75, 2), 1e-9);
    EXPECT_NEAR(force["ridge"], -force["groove"], 1e-12);
    EXPECT_NEAR(force["stay"], 1.5 * (1.0 - std::pow(0.5, 8)), 1e-9);
}

TEST_F(Cli, FeelTakesAFixedLevelAFractionAndAuto) {
    ASSERT_EQ(feel({"--level", "1.5"}), 0);
    EXPECT_EQ(rows()[0].at("level"), "1.5");
    ASSERT_EQ(feel({"--level", "99"}), 0);
    const double coarsest = number(rows()[0].at("level"));
    EXPECT_GT(coarsest, 1.0);
    EXPECT_LT(coarsest, 99.0);
    ASSERT_EQ(feel({"--level", "auto", "--h0", "0.0001"}), 0);
    EXPECT_GE(number(rows()[50].at("level")), 1.0);  // the default device cannot resolve 0.1 mm
    ASSERT_EQ(feel({"--level", "auto", "--h0", "0.0001", "--profile", "mk2"}), 0);
    EXPECT_EQ(number(rows()[0].at("level")), 0.0);
}

TEST_F(Cli, FeelResamplesAndBudgets) {
    ASSERT_EQ(feel({"--resample"}), 0);
    EXPECT_NEAR(number(rows()[150].at("fy_N")), 1.5, 1e-6);
    for (const double budget : {0.0, 2.0}) {
        ASSERT_EQ(feel({"--budget", budget > 0.0 ? "2" : "0"}), 0);
        bool is_carried = false;
        for (const Row& row : rows()) {
            EXPECT_LE(number(row.at("nodes")), budget);
            is_carried = is_carried || number(row.at("carried_m")) > 0.0;
        }
        EXPECT_EQ(is_carried, budget == 0.0);  // a straight line is one box
    }
    ASSERT_EQ(feel({"--deadline-us", "100000"}), 0);
    EXPECT_NEAR(number(rows()[150].at("fy_N")), 1.5, 1e-6);
}

TEST_F(Cli, FeelOfAPictureEqualsFeelOfItsTracedMapBitForBit) {
    write_disc();
    std::string hand = "t_s,x_m,y_m\n";  // goes across the whole disc
    for (int i = 0; i < 300; ++i) {
        hand += std::to_string(0.001 * i) + "," + std::to_string(0.0003 * i - 0.045) + ",0.001\n";
    }
    write("hand.csv", hand);
    ASSERT_EQ(run({"trace", "@disc.png", "-o", "@disc.svg"}), 0) << err();
    ASSERT_EQ(run({"feel", "@disc.png", "--path", "@hand.csv", "-o", "@a.csv"}), 0) << err();
    ASSERT_EQ(run({"feel", "@disc.svg", "--path", "@hand.csv", "-o", "@b.csv"}), 0) << err();
    EXPECT_EQ(text_of("a.csv"), text_of("b.csv"));
    EXPECT_NE(text_of("a.csv").find("edge"), std::string::npos);
    ASSERT_EQ(run({"feel", "@map.svg", "--picture", "--path", "@hand.csv", "-o", "@c.csv"}), 0)
        << err();
}

TEST_F(Cli, FeelSaysWhatIsWrongWithAPath) {
    for (const std::string bad :
         {"", "t_s,x_m\n0,0\n", "t_s,x_m,y_m\n", "t_s,x_m,y_m\n0,nan,0\n", "t_s,x_m,y_m\n0,0\n",
          "t_s,x_m,y_m\n0,0,0\n0,0,0\n", "t_s,x_m,y_m\n0,1.01,0\n", "t_s,x_m,y_m\n0,1e400,0\n",
          "t_s,x_m,y_m\n0,0,0 m\n"}) {
        write("hand.csv", bad);
        EXPECT_EQ(feel({}), 1) << bad;
        EXPECT_EQ(lines_of_err(), 1) << err();
        EXPECT_FALSE(exists("run.csv"));
    }
    write("hand.csv", "\xEF\xBB\xBFt_s,x_m,y_m\n0,+0.01,0\n");
    EXPECT_EQ(feel({}), 0) << err();
    write("hand.csv", "x_m, y_m, note, t_s\r\n0.01,0.02,hello,0\r\n0.01,0.02,,0.5\r\n\r\n");
    EXPECT_EQ(feel({}), 0) << err();
    EXPECT_EQ(rows().size(), 2U);
}

TEST_F(Cli, WrongUsageIsStatusTwoAndOneLine) {
    const std::vector<std::vector<std::string>> wrong{
        {"feel", "@map.svg", "-o", "@run.csv"},
        {"feel", "@map.svg", "--path", "@hand.csv", "-o", "@run.csv", "--mode", "wal"},
        {"feel", "@map.svg", "--path", "@hand.csv", "-o", "@run.csv", "--level", "-1"},
        {"feel", "@map.svg", "--path", "@hand.csv", "-o", "@run.csv", "--level", "nan"},
        {"feel", "@map.svg", "--path", "@hand.csv", "-o", "@run.csv", "--stiffness", "0"},
        {"feel", "@map.svg", "--path", "@hand.csv", "-o", "@run.csv", "--stiffness", "nan"},
        {"feel", "@map.svg", "--path", "@hand.csv", "-o", "@run.csv", "--radius", "nan"},
        {"feel", "@map.svg", "--path", "@hand.csv", "-o", "@run.csv", "--friction", "2"},
        {"feel", "@map.svg", "--path", "@hand.csv", "-o", "@run.csv", "--profile", "none"},
        {"feel", "@map.svg", "--path", "@hand.csv", "-o", "@run.csv", "--budget", "-3"},
        {"feel", "@map.svg", "--path", "@hand.csv", "-o", "@run.csv", "--budget", "3",
         "--deadline-us", "5"},
        {"trace", "@map.svg", "-o", "@out.svg", "--detail", "6"},
        {"trace", "@map.svg", "-o", "@out.svg", "--area", "116"},
        {"trace", "@map.svg", "-o", "@out.svg", "--area", "0x84"},
        {"curve", "@map.svg", "-o", "@out.svg"},
        {"curve", "@map.svg", "-o", "@out.svg", "--level", "0", "--keep-details", "1.5"},
        {"@not-there.png"}};
    for (const auto& arguments : wrong) {
        EXPECT_EQ(run(arguments), 2) << arguments.back();
        EXPECT_EQ(lines_of_err(), 1) << err();
        EXPECT_FALSE(exists("run.csv") || exists("out.svg"));
    }
    EXPECT_EQ(run({"feel", "--help"}), 0);
    EXPECT_NE(out().find("--stiffness"), std::string::npos);
}

TEST_F(Cli, TellsItsVersion) {
    EXPECT_EQ(run({"--version"}), 0);
    EXPECT_EQ(out(), "touchline " TOUCHLINE_VERSION "\n");
    EXPECT_EQ(err(), "");
}

TEST_F(Cli, InputThatCannotBeUsedIsStatusOneOneLineAndNoFile) {
    write("broken.svg", "<svg");
    write("empty.png", "");
    write("white.txt", "not a picture");
    for (const std::string name : {"broken.svg", "empty.png", "white.txt", "missing.png"}) {
        EXPECT_EQ(run({"feel", "@" + name, "--path", "@hand.csv", "-o", "@run.csv"}), 1) << name;
        EXPECT_EQ(run({"curve", "@" + name, "--level", "0", "-o", "@out.svg"}), 1) << name;
        EXPECT_EQ(run({"trace", "@" + name, "-o", "@out.svg"}), 1) << name;
        EXPECT_EQ(lines_of_err(), 1) << err();
        EXPECT_NE(err().find(name), std::string::npos) << err();
        EXPECT_FALSE(exists("run.csv") || exists("out.svg"));
    }
}

TEST_F(Cli, TraceWritesMapReportAndEdges) {
    write_disc();
    ASSERT_EQ(run({"trace", "@disc.png", "-o", "@out.svg", "--json", "@report.json", "--edges",
                   "@edges.png", "--detail", "1", "--area", "80x60"}),
              0)
        << err();
    const auto map = read_map_svg(path("out.svg"));
    ASSERT_TRUE(map);
    EXPECT_EQ(map->area, (Area{0.08, 0.06}));
    ASSERT_EQ(map->outlines.size(), 1U);
    EXPECT_TRUE(map->outlines[0].is_closed);
    for (const Position p : map->outlines[0].points) EXPECT_NEAR(norm(p), 0.020, 0.0005);
    EXPECT_NE(text_of("report.json").find("\"outlines\": 1"), std::string::npos);
    const auto edges = read_picture(path("edges.png"));
    ASSERT_TRUE(edges);
    EXPECT_EQ(edges->width, 160);
}

TEST_F(Cli, TraceSaysWhyThereIsNothingToFeel) {
    ASSERT_TRUE(
        write_png(path("white.png"), Picture{40, 30, std::vector<std::uint8_t>(40 * 30 * 3, 255)}));
    ASSERT_TRUE(write_png(path("dot.png"), Picture{1, 1, {0, 0, 0}}));
    for (const std::string name : {"white.png", "dot.png"}) {
        EXPECT_EQ(run({"trace", "@" + name, "-o", "@out.svg"}), 1);
        EXPECT_NE(err().find("no outline found, because"), std::string::npos) << err();
        EXPECT_FALSE(exists("out.svg"));
    }
}

TEST_F(Cli, CurveWritesThePolylinesThatFeelUses) {
    ASSERT_EQ(
        run({"curve", "@map.svg", "--level", "1.5", "-o", "@out.svg", "--json", "@report.json"}), 0)
        << err();
    const auto drawn = read_map_svg(path("out.svg"));
    const auto map = read_map_svg(path("map.svg"));
    ASSERT_TRUE(drawn && map);
    const CurveSet curves = CurveSet::build(*map, {}).value();
    ASSERT_EQ(drawn->outlines.size(), curves.pieces().size());
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        const auto& points = drawn->outlines[static_cast<std::size_t>(piece)].points;
        ASSERT_EQ(static_cast<int>(points.size()),
                  curves.rendered_count(piece, 1.5) +
                      (curves.pieces()[static_cast<std::size_t>(piece)].is_closed ? 0 : 1));
        for (int i = 0; i < static_cast<int>(points.size()); ++i) {
            EXPECT_LE(
                norm(points[static_cast<std::size_t>(i)] - curves.rendered_point(piece, 1.5, i)),
                1e-16);
        }
    }
    const std::string svg = text_of("out.svg");
    EXPECT_NE(svg.find("data-outline=\"1\" data-piece=\"1\" data-level=\"1.5\""),
              std::string::npos);
    const std::string report = text_of("report.json");
    for (const char* key :
         {"points_in", "points_kept", "why", "rms_m", "hausdorff_m", "slope_rms_rad"}) {
        EXPECT_NE(report.find(key), std::string::npos) << key;
    }
}

TEST_F(Cli, CurveDrawsBoxesResamplesDenoisesAndCompresses) {
    ASSERT_EQ(run({"curve", "@map.svg", "--level", "2", "-o", "@out.svg", "--boxes"}), 0);
    EXPECT_NE(text_of("out.svg").find("class=\"box\""), std::string::npos);
    const auto points_kept = [this] {
        const std::string report = text_of("report.json");
        const auto last = report.rfind("\"points_kept\": ");
        return number(report.substr(last + 15, report.find(',', last) - last - 15));
    };
    ASSERT_EQ(
        run({"curve", "@map.svg", "--level", "0", "-o", "@out.svg", "--json", "@report.json"}), 0);
    const double kept = points_kept();
    ASSERT_EQ(run({"curve", "@map.svg", "--level", "0", "-o", "@out.svg", "--json", "@report.json",
                   "--resample"}),
              0);
    EXPECT_LT(points_kept(), kept);
    EXPECT_NE(text_of("report.json").find("\"shrunk_max_m\": 0,"), std::string::npos);
    for (const auto& shrink :
         {std::vector<std::string>{"--keep-details", "0"}, {"--denoise", "0.2"}}) {
        std::vector<std::string> arguments{"curve", "@map.svg", "--level", "0",
                                           "-o",    "@out.svg", "--json",  "@report.json"};
        arguments.insert(arguments.end(), shrink.begin(), shrink.end());
        ASSERT_EQ(run(arguments), 0) << err();
        const std::string report = text_of("report.json");
        EXPECT_EQ(report.find("\"shrunk_max_m\": 0,", report.find("\"outline\": 1")),
                  std::string::npos);
    }
}

TEST_F(Cli, TheKioskAndTheTourGetWhatWasSaid) {
    ASSERT_EQ(run({"--window", "--measure", "2.5", "@map.svg"}), 0);
    EXPECT_TRUE(kiosk_.in_window);
    EXPECT_EQ(kiosk_.measure_s, 2.5);
    EXPECT_EQ(kiosk_.files, (std::vector<std::string>{path("map.svg")}));
    ASSERT_EQ(run({"@"}), 0) << "a folder of pictures";
    EXPECT_EQ(kiosk_.files, (std::vector<std::string>{path("")}));
    ASSERT_EQ(run({"tour", "@map.svg", "--picture", "-o", "@run.png"}), 0);
    EXPECT_EQ(tour_.input, path("map.svg"));
    EXPECT_EQ(tour_.output, path("run.png"));
    EXPECT_TRUE(tour_.as_picture);
}

}  // namespace
}  // namespace touchline
