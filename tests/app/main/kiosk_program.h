// The program itself, in a window on a virtual display, driven by keys. No test depends on the
// machine's speed: each waits for something to happen, with a limit far off.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
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
    /// `keys KEY ...` presses keys in its window, `wait_for PATTERN FILE` waits for words and
    /// ends the script with 98 if they never come, `quit` asks to quit and says yes, and `finish`
    /// ends with the program's status.
    int run_script(const std::string& script, bool has_display = true);

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
};

}  // namespace touchline
