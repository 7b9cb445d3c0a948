// Tests that what is installed for sticks agrees with the program, and does what it says.
#include "app/documents/sticks/stick_port.h"
#include "config/settings/boards.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using Words = std::vector<std::string>;

std::string installed(const std::string& name) {
    std::ifstream in(std::string(TOUCHLINE_SOURCE_DIR) + "/config/defaults/" + name);
    std::string text(std::istreambuf_iterator<char>(in), {});
    EXPECT_FALSE(text.empty()) << name;
    return text;
}

TEST(InstalledForSticks, UdevLeavesThoseThatAreMounted) {
    const std::string rules = installed("71-touchline-sticks.rules");
    const auto begin = rules.find("ENV{ID_FS_TYPE}==\"") + 18;
    std::istringstream list(rules.substr(begin, rules.find('"', begin) - begin));
    int count = 0;
    for (std::string one; std::getline(list, one, '|'); ++count)
        EXPECT_TRUE(mount_options(one, FileSystems::more).has_value()) << one;
    EXPECT_EQ(count, 4);
}

TEST(InstalledForSticks, NoModuleThatIsMountedIsBarred) {
    std::istringstream lines(installed("touchline-modprobe.conf"));
    int count = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with('#')) continue;
        std::istringstream words(line);
        std::string install;
        std::string module;
        std::string instead;
        words >> install >> module >> instead;
        EXPECT_EQ(install, "install");
        EXPECT_EQ(instead, "/bin/false");
        EXPECT_FALSE(mount_options(module, FileSystems::usual).has_value()) << module;
        ++count;
    }
    EXPECT_GT(count, 10);
}

/// A USB device as USBGuard sees it.
struct Device {
    std::string id;
    Words interfaces;
};

/// Returns true if a value fits a pattern: "08:06:50" fits "08:*:*".
bool fits(const std::string& value, const std::string& pattern) {
    const std::size_t star = pattern.find('*');
    return star == std::string::npos ? value == pattern
                                     : value.starts_with(pattern.substr(0, star));
}

bool fits_one(const std::string& value, const Words& patterns) {
    return std::any_of(patterns.begin(), patterns.end(),
                       [&value](const std::string& pattern) { return fits(value, pattern); });
}

bool fits_interfaces(const Device& device, const std::string& operation, const Words& patterns) {
    const auto& all = device.interfaces;
    const auto one = [&patterns](const std::string& value) { return fits_one(value, patterns); };
    if (operation == "one-of") return std::any_of(all.begin(), all.end(), one);
    if (operation == "none-of") return std::none_of(all.begin(), all.end(), one);
    if (operation == "match-all") return std::all_of(all.begin(), all.end(), one);
    if (operation == "equals")
        return all.size() == patterns.size() && std::all_of(all.begin(), all.end(), one);
    ADD_FAILURE() << "unknown operation " << operation;
    return false;
}

/// Returns "allow", "reject" or "block" by the first rule that fits, as in usbguard-rules.conf(5).
std::string judged(const Device& device) {
    std::istringstream lines(installed("touchline-usbguard.conf"));
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.starts_with('#')) continue;
        std::istringstream text(line);
        Words words{std::istream_iterator<std::string>(text), {}};
        const std::string target = words.front();
        bool is_fitting = true;
        for (std::size_t i = 1; i < words.size();) {
            if (words[i] == "id") {
                is_fitting = is_fitting && words.at(i + 1) == device.id;
                i += 2;
                continue;
            }
            EXPECT_EQ(words[i], "with-interface");
            const auto end = std::find(words.begin(), words.end(), "}");
            const Words patterns(words.begin() + static_cast<long>(i) + 3, end);
            is_fitting = is_fitting && fits_interfaces(device, words.at(i + 1), patterns);
            i = words.size();
        }
        if (is_fitting) return target;
    }
    return "block";
}

TEST(InstalledForSticks, UsbGuardLetsSticksInAndNothingThatPretends) {
    const std::string stick = "0951:1666";
    EXPECT_EQ(judged({stick, {"08:06:50"}}), "allow");
    EXPECT_EQ(judged({stick, {"08:06:50", "08:06:62"}}), "allow");
    EXPECT_EQ(judged({stick, {"08:06:50", "03:01:01"}}), "reject");
    EXPECT_EQ(judged({stick, {"08:06:50", "02:06:00", "0a:00:00"}}), "reject");
    EXPECT_EQ(judged({stick, {"08:06:50", "e0:01:01"}}), "reject");
    EXPECT_EQ(judged({stick, {"08:06:50", "ff:00:00"}}), "reject");
    EXPECT_EQ(judged({stick, {"08:06:50", "01:01:00"}}), "block");
    EXPECT_EQ(judged({"046d:c31c", {"03:01:01"}}), "reject");  // until its rule is added
    EXPECT_EQ(judged({"1d6b:0002", {"09:00:00"}}), "allow");
    EXPECT_EQ(judged({"05e3:0610", {"09:00:01"}}), "allow");
    EXPECT_EQ(judged({"05e3:0610", {"09:00:01", "03:01:01"}}), "reject");
}

TEST(InstalledForSticks, UsbGuardLetsTheBoardsInAndNoKeyboardWithTheirIds) {
    const auto settings = read_boards(TOUCHLINE_SOURCE_DIR "/config/defaults/boards.toml");
    ASSERT_TRUE(settings.has_value());
    for (const BoardId& board : settings->boards) {
        std::array<char, 10> id{};
        std::snprintf(id.data(), id.size(), "%04x:%04x", static_cast<unsigned>(board.vendor),
                      static_cast<unsigned>(board.product));
        EXPECT_EQ(judged({id.data(), {"02:02:01", "0a:00:00"}}), "allow") << id.data();
        EXPECT_EQ(judged({id.data(), {"02:02:01", "0a:00:00", "03:01:01"}}), "reject") << id.data();
    }
}

}  // namespace
}  // namespace touchline
