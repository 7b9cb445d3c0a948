// Tests touchline models, as a user types it.
#include "app/cli/command_line.h"
#include "app/models/networks.h"

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

namespace fs = std::filesystem;

struct Answer {
    int status;
    std::string out;
    std::string err;
};

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

    static Answer say(const std::vector<std::string>& words) {
        std::ostringstream out;
        std::ostringstream err;
        const int status = run_command_line(words, {}, out, err);
        return {status, out.str(), err.str()};
    }

    fs::path folder_ =
        fs::path(testing::TempDir()) / ("touchline-models-" + std::to_string(::getpid()));
};

TEST_F(ModelsCommand, ListsEachWithItsJobSourceAndLicence) {
    const Answer listed = say({"models", "list"});
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
    const Answer without = say({"models", "check"});
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
    const Answer damaged = say({"models", "check"});
    EXPECT_EQ(damaged.status, 1);
    EXPECT_EQ(damaged.err, "touchline: " + (folder_ / "figure.onnx").string() +
                               ": the network is damaged, or of another version; 'touchline "
                               "models get figure' brings it\n");
}

TEST_F(ModelsCommand, NobodyGetsWhatShips) {
    const Answer got = say({"models", "get", "nanodet", "--yes"});
    EXPECT_EQ(got.status, 0);
    EXPECT_EQ(got.out, "nanodet is installed already.\n");
    EXPECT_FALSE(fs::exists(folder_));
    EXPECT_EQ(say({"models", "get", "nobody"}).status, 1);
}

}  // namespace
}  // namespace touchline
