// The program itself, in a window on a virtual display, driven by keys. No test depends on the
// machine's speed: each waits for something to happen, with a limit far off.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchline {

class KioskProgram : public testing::Test {
  protected:
    /// Uses a folder as the stick, since there is no bus here and the kiosk would say so.
    void SetUp() override {
        std::filesystem::create_directories(folder_ / "stick");
        std::ofstream(folder_ / "kiosk.toml")
            << "[stick]\nwatched_folder = '" << (folder_ / "stick").string() << "'\n";
    }

    void TearDown() override { std::filesystem::remove_all(folder_); }

    /// Runs a script and returns its exit status. In it, `kiosk ARGUMENTS` starts the program,
    /// `keys KEY ...` presses keys in its window, `wait_for PATTERN FILE` waits for words, `quit`
    /// asks to quit and says yes, and `finish` ends with the program's status.
    int run_script(const std::string& script, bool has_display = true) {
        const std::filesystem::path path = folder_ / "script.sh";
        std::ofstream(path) << "cd '" << folder_.string() << "'\n" << tools << script << '\n';
        const std::string settings =
            "TOUCHLINE_SETTINGS='" + (folder_ / "kiosk.toml").string() + "' ";
        const std::string display = has_display
                                        ? "LP_NUM_THREADS=1 xvfb-run -a -s '-screen 0 1024x768x24' "
                                        : "env -u DISPLAY -u WAYLAND_DISPLAY ";
        const int status =
            std::system((settings + display + "timeout 240 bash '" + path.string() + "'").c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    [[nodiscard]] std::string text_of(const char* name) const {
        std::ifstream file(folder_ / name);
        std::stringstream text;
        text << file.rdbuf();
        return text.str();
    }

    /// Returns the program's complaints, except about parts that a test machine may lack.
    [[nodiscard]] std::string complaints() const {
        std::ifstream file(folder_ / "err.txt");
        std::string text;
        for (std::string line; std::getline(file, line);)
            if (line.find("touchline: there is no ") != 0) text += line + '\n';
        return text;
    }

    std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) /
                                    (std::to_string(getpid()) + "-" +
                                     testing::UnitTest::GetInstance()->current_test_info()->name());

  private:
    static constexpr const char* tools = "program='" TOUCHLINE_PROGRAM
                                         "'\n"
                                         "export TOUCHLINE_GALLERY='" TOUCHLINE_SOURCE_DIR
                                         "/app/documents/gallery/pictures'\n"
                                         "export TOUCHLINE_RECORDINGS=kept\n"
                                         R"(
kiosk() { "$program" "$@" >out.txt 2>err.txt & pid=$!; }
keys() { timeout 100 xdotool search --sync --name '^Touchline$' key --delay 150 "$@" >/dev/null 2>&1; }
wait_for() { for _ in $(seq 1000); do grep -q "$1" "$2" && return; sleep 0.1; done; }
finish() { wait "$pid"; exit $?; }
quit() { keys q Down Return; finish; }
)";
};

}  // namespace touchline
