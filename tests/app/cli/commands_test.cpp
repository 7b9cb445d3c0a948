// Tests touchline settings and touchline models, as a user types them.
#include "app/cli/options.h"
#include "app/documents/models/networks.h"
#include "config/settings/settings_text.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

namespace touchline {
namespace {

struct Said {
    int status;
    std::string out;
    std::string err;
};

Said say(const std::vector<std::string>& words) {
    std::ostringstream out;
    std::ostringstream err;
    const int status = run_command_line(words, {}, out, err);
    return {status, out.str(), err.str()};
}

class SettingsCommand : public testing::Test {
  protected:
    SettingsCommand() {
        ::setenv("TOUCHLINE_SETTINGS", file.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
    }

    ~SettingsCommand() override {
        ::unsetenv("TOUCHLINE_SETTINGS");  // NOLINT(concurrency-mt-unsafe)
        std::filesystem::remove(file);
    }

    std::string file = testing::TempDir() + "touchline-site-" + std::to_string(getpid()) + ".toml";
};

TEST_F(SettingsCommand, WithoutAFileTheProgramsOwnHold) {
    const Said checked = say({"settings", "check"});
    EXPECT_EQ(checked.status, 0);
    EXPECT_EQ(checked.out, file + ": is not there; the program's own settings hold\n");
    EXPECT_EQ(say({"settings", "print"}).out, settings_text(Settings{}));
}

TEST_F(SettingsCommand, AGoodFileIsCountedAndPrinted) {
    std::ofstream(file) << "[feel]\nfriction = 0.2\nstiffness_N_per_m = 500\n";
    EXPECT_EQ(say({"settings", "check"}).out, file + ": can be used; 1 of " +
                                                  std::to_string(setting_rows().size()) +
                                                  " settings differ from the program's own\n");
    EXPECT_EQ(say({"settings", "check", file}).out, say({"settings", "check"}).out);
    EXPECT_NE(say({"settings", "print"}).out.find("friction = 0.2\n"), std::string::npos);
}

TEST_F(SettingsCommand, AWrongOneIsOneLineAndAStatus) {
    std::ofstream(file) << "[feel]\nfriction = 7\n";
    for (const char* action : {"check", "print"}) {
        const Said said = say({"settings", action, file});
        EXPECT_EQ(said.status, 1);
        EXPECT_EQ(said.out, "");
        EXPECT_EQ(said.err,
                  "touchline: " + file + ":2: 'feel.friction' must be a number from 0 to 1\n");
    }
    EXPECT_EQ(say({"settings", "check", "/nowhere/kiosk.toml"}).status, 1);
    EXPECT_EQ(say({"settings"}).status, 2);
}

TEST_F(SettingsCommand, EveryFaultIsALineOfItsOwn) {
    std::ofstream(file) << "[feel]\nfriction = 7\nmode = groove\n[language]\noffered = 'en xx'\n";
    const Said said = say({"settings", "check", file});
    EXPECT_EQ(said.status, 1);
    EXPECT_EQ(said.out, "");
    std::istringstream lines(said.err);
    std::vector<std::string> told;
    for (std::string line; std::getline(lines, line);) told.push_back(line);
    ASSERT_EQ(told.size(), 3U) << said.err;
    for (std::size_t i = 0; i < told.size(); ++i) {
        const std::string place = "touchline: " + file + ':' + std::array{"2", "3", "5"}[i] + ": ";
        EXPECT_TRUE(told[i].starts_with(place)) << told[i];
    }
    EXPECT_NE(told[2].find("'xx'"), std::string::npos);
}

namespace fs = std::filesystem;

/// The user has no network yet.
class ModelsCommand : public ::testing::Test {
  protected:
    ModelsCommand() {
        ::setenv("TOUCHLINE_MODELS", folder_.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
    }

    ~ModelsCommand() override {
        ::unsetenv("TOUCHLINE_MODELS");  // NOLINT(concurrency-mt-unsafe)
        fs::remove_all(folder_);
    }

    fs::path folder_ =
        fs::path(testing::TempDir()) / ("touchline-models-" + std::to_string(::getpid()));
};

TEST_F(ModelsCommand, ListsEachWithItsJobSourceAndLicence) {
    const Said listed = say({"models", "list"});
    EXPECT_EQ(listed.status, 0);
    for (const Network& network : networks()) {
        const auto name = std::string(network.name);
        EXPECT_NE(listed.out.find(name + ": " + std::string(network.job)), std::string::npos);
        EXPECT_NE(
            listed.out.find(std::string(network.package) + " " + std::string(network.version) +
                            ", licence " + std::string(network.licence)),
            std::string::npos);
        const std::string where = network.ships
                                      ? "comes with Touchline: " + installed_file(network).string()
                                      : "not here: touchline models get " + name;
        EXPECT_NE(listed.out.find("  " + where + "\n"), std::string::npos) << where;
    }
}

TEST_F(ModelsCommand, ChecksWhatShipsAndWhatIsHere) {
    const Said without = say({"models", "check"});
    EXPECT_EQ(without.status, 0);
    std::string expected;
    for (const Network& network : networks())
        expected += std::string(network.name) +
                    (network.ships ? ": whole, in " + installed_file(network).string()
                                   : ": not installed here") +
                    "\n";
    EXPECT_EQ(without.out, expected);

    fs::create_directories(folder_);
    std::ofstream(folder_ / "figure.onnx") << "damaged";
    const Said damaged = say({"models", "check"});
    EXPECT_EQ(damaged.status, 1);
    EXPECT_EQ(damaged.err, "touchline: " + (folder_ / "figure.onnx").string() +
                               ": the network is damaged, or of another version; 'touchline "
                               "models get figure' brings it\n");
}

TEST_F(ModelsCommand, NobodyGetsWhatShips) {
    const Said got = say({"models", "get", "nanodet", "--yes"});
    EXPECT_EQ(got.status, 0);
    EXPECT_EQ(got.out, "nanodet is installed already.\n");
    EXPECT_FALSE(fs::exists(folder_));
    EXPECT_EQ(say({"models", "get", "nobody"}).status, 1);
}

}  // namespace
}  // namespace touchline
