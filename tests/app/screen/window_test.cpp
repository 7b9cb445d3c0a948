// Tests the window on a bare display, without a window manager, and what OpenGL makes of a screen.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

class BareDisplay : public testing::Test {
  protected:
    void SetUp() override { fs::create_directories(folder_); }

    void TearDown() override { fs::remove_all(folder_); }

    /// Runs the script while the window shows its screen. drawn.png is what it drew, root.png what
    /// the display shows.
    int run_script(const std::string& display_size, const std::string& script) {
        const fs::path path = folder_ / "script.sh";
        std::ofstream(path) << "cd '" << folder_.string() << "'\nmkfifo end\n"
                            << "'" TOUCHLINE_WINDOW_PROBE "' drawn.png <end >out.txt 2>err.txt &\n"
                            << "exec 3>end\n"
                            << "for _ in $(seq 600); do grep -q ready out.txt && break; "
                               "kill -0 $! || exit 8; sleep 0.1; done\n"
                            << "import -window root root.png\n"
                            << script << "\nexec 3>&-\nwait $!\n";
        const std::string command = "LP_NUM_THREADS=1 xvfb-run -a -s '-screen 0 " + display_size +
                                    "x24' timeout 120 bash '" + path.string() + "'";
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    [[nodiscard]] std::string text_of(const char* name) const {
        std::ifstream file(folder_ / name);
        std::stringstream text;
        text << file.rdbuf();
        return text.str();
    }

    fs::path folder_ = fs::path(testing::TempDir()) /
                       (std::to_string(getpid()) + "-" +
                        testing::UnitTest::GetInstance()->current_test_info()->name());
};

/// Compares pixel for pixel: no border, no gap, nothing in front.
constexpr const char* compare =
    "compare -metric AE drawn.png root.png null: 2>differing.txt;"
    "identify -format '%wx%h' root.png >size.txt";

TEST_F(BareDisplay, TheWindowCoversAWideMonitor) {
    EXPECT_EQ(run_script("1280x800", compare), 0) << text_of("err.txt");
    EXPECT_EQ(text_of("size.txt"), "1280x800");
    EXPECT_EQ(text_of("differing.txt"), "0");
}

TEST_F(BareDisplay, DrawsNoFrameThatWouldLookTheSame) {
    EXPECT_EQ(run_script("800x600", ":"), 0) << text_of("err.txt");
    EXPECT_NE(text_of("out.txt").find("the same again: not drawn"), std::string::npos)
        << text_of("out.txt");
}

/// Buttons of the pointer, as a mouse and a tablet's pen have them; the stroke is drawn while the
/// button is still down.
TEST_F(BareDisplay, AStrokeOfThePointerIsSeenAsItIsDrawn) {
    const std::string draw = R"(
        xdotool mousemove 100 300 mousedown 1
        for x in 150 200 250 300 350 400; do xdotool mousemove $x 300; sleep 0.1; done
        sleep 1
        import -window root root.png
        xdotool mouseup 1 click 3
        sleep 1
        convert root.png -fuzz 30% -crop 200x20+150+290 +repage -fill black +opaque '#5CC7FF' \
            -fill white -opaque '#5CC7FF' -format '%[fx:mean]' info: >pen.txt
    )";
    ASSERT_EQ(run_script("1280x800", draw), 0) << text_of("err.txt");
    EXPECT_GT(std::stod(text_of("pen.txt")), 0.03);
    EXPECT_NE(text_of("out.txt").find("first down\nfirst up\nsecond down\nsecond up\n"),
              std::string::npos)
        << text_of("out.txt");
}

TEST_F(BareDisplay, TheWindowCoversAnUprightMonitor) {
    EXPECT_EQ(run_script("1080x1920", compare), 0) << text_of("err.txt");
    EXPECT_EQ(text_of("size.txt"), "1080x1920");
    EXPECT_EQ(text_of("differing.txt"), "0");
}

/// Compares the window's last frame with the display after the screen has changed.
std::string after(const std::string& change) {
    return change + R"(
        sleep 3
        import -window root root.png
        exec 3>&-
        wait $!
        identify -format '%wx%h' root.png >size.txt
        compare -metric AE drawn.png root.png null: 2>differing.txt
    )";
}

constexpr const char* smaller_mode = R"(
    xrandr --newmode small 74.5 1280 1344 1472 1664 720 723 728 748
    xrandr --addmode screen small
    xrandr --output screen --mode small
)";

TEST_F(BareDisplay, TheWindowFollowsAChangeOfTheMode) {
    EXPECT_EQ(run_script("1920x1080", after(smaller_mode)), 0) << text_of("err.txt");
    EXPECT_EQ(text_of("size.txt"), "1280x720");
    EXPECT_EQ(text_of("differing.txt"), "0");
}

TEST_F(BareDisplay, TheWindowComesBackToTheFirstMode) {
    EXPECT_EQ(run_script("1920x1080", after(std::string(smaller_mode) +
                                            "sleep 2\nxrandr --output screen --mode 1920x1080")),
              0)
        << text_of("err.txt");
    EXPECT_EQ(text_of("size.txt"), "1920x1080");
    EXPECT_EQ(text_of("differing.txt"), "0");
}

TEST_F(BareDisplay, TheWindowOutlivesAScreenThatIsUnpluggedAndComesBackAnother) {
    EXPECT_EQ(run_script("1920x1080", after("xrandr --fb 1920x1080 --output screen --off\nsleep 2" +
                                            std::string(smaller_mode))),
              0)
        << text_of("err.txt");
    EXPECT_EQ(text_of("size.txt"), "1280x720");
    EXPECT_EQ(text_of("differing.txt"), "0");
}

/// Computes the share of a part of the picture that has a colour.
std::string share_of(const std::string& colour, const std::string& crop, const std::string& file) {
    return "convert drawn.png -crop " + crop + " +repage -fill black +opaque '" + colour +
           "' -fill white -opaque '" + colour + "' -format '%[fx:mean]' info: >" + file + ";";
}

TEST_F(BareDisplay, OutlinesAndHandLieInThePictureAndNotOverTheSheet) {
    ASSERT_EQ(run_script("1280x800", share_of("#FFD400", "700x500+0+0", "outline.txt") +
                                         share_of("#2EF2C7", "700x500+0+0", "proxy.txt") +
                                         share_of("#2EF2C7", "400x800+880+0", "sheet.txt")),
              0)
        << text_of("err.txt");
    EXPECT_GT(std::stod(text_of("outline.txt")), 1e-3);
    EXPECT_GT(std::stod(text_of("proxy.txt")), 1e-5);
    EXPECT_EQ(std::stod(text_of("sheet.txt")), 0.0);
}

}  // namespace
}  // namespace touchline
