// Tests files, options and folders of any name: each command prints one line that no terminal
// obeys.
#include "app/cli/options.h"
#include "app/cli/tour.h"

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

/// A newline, ESC, BEL, a mark that turns the direction of text, and CSI as one character and as
/// one byte.
const std::string hostile = "a\n\x1b[2J\x07\xe2\x80\xae\xc2\x9b\x9b";

/// "@" in an argument stands for the test's folder and a hostile name.
struct Call {
    const char* name;
    std::vector<std::string> arguments;
};

void PrintTo(const Call& call, std::ostream* out) {
    *out << call.name;
}

class HostileNames : public testing::TestWithParam<Call> {
  protected:
    HostileNames() {
        fs::create_directories(folder_);
        for (const char* ending : {".svg", ".png", ".csv", ".toml", ".zip", ".touchline"})
            std::ofstream(named(std::string("there") + ending)) << "nothing of the kind";
        std::ofstream(named("map.svg")) << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 "
                                           "116 84'><path d='M 8 42 L 108 42'/></svg>";
        std::ofstream(named("hand.csv")) << "t_s,x_m,y_m\n0,0,0\n0.001,0,0\n";
        std::ofstream(named("good.toml")) << "";
        fs::create_directories(named("pack"));
        ::setenv("TOUCHLINE_SETTINGS", named("none.toml").c_str(),
                 1);  // NOLINT(concurrency-mt-unsafe)
    }

    ~HostileNames() override {
        ::unsetenv("TOUCHLINE_SETTINGS");  // NOLINT(concurrency-mt-unsafe)
        fs::remove_all(folder_);
    }

    [[nodiscard]] std::string named(const std::string& end) const {
        return (folder_ / (hostile + end)).string();
    }

    [[nodiscard]] std::string filled(std::string argument) const {
        const auto at = argument.find('@');
        if (at != std::string::npos) argument.replace(at, 1, (folder_ / hostile).string());
        return argument;
    }

    fs::path folder_ =
        fs::temp_directory_path() / ("touchline-hostile-" + std::to_string(getpid()));
};

void expect_harmless(const std::string& text, std::size_t most_lines) {
    std::size_t lines = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        lines += byte == '\n' ? 1 : 0;
        EXPECT_TRUE(byte == '\n' || (byte >= 0x20 && byte != 0x7f)) << int{byte} << " at " << i;
    }
    EXPECT_EQ(text.find("\xe2\x80\xae"), std::string::npos) << "turns the direction of writing";
    EXPECT_EQ(text.find("\xc2\x9b"), std::string::npos);
    EXPECT_EQ(text.find("\x9b"), std::string::npos);
    EXPECT_LE(lines, most_lines) << text;
}

TEST_P(HostileNames, AreOneHarmlessLine) {
    std::vector<std::string> arguments;
    for (const std::string& argument : GetParam().arguments) arguments.push_back(filled(argument));
    std::ostringstream out;
    std::ostringstream err;
    const Programs programs{[](const KioskArguments&) { return 0; }, run_tour};
    const int status = run_command_line(arguments, programs, out, err);
    constexpr std::size_t longest_list = 20;  // for the findings about a pack
    expect_harmless(out.str(), longest_list);
    expect_harmless(err.str(), 1);
    EXPECT_EQ(err.str().empty(), status == 0) << err.str();
    EXPECT_EQ(err.str().find("touchline: ") == 0U, status != 0) << err.str();
}

const Call calls[] = {
    {"UnknownWord", {"@"}},
    {"UnknownOption", {"trace", "--@"}},
    {"TraceNone", {"trace", "@none.png", "-o", "@out.svg"}},
    {"TraceBroken", {"trace", "@there.png", "-o", "@out.svg"}},
    {"TraceBrokenDrawing", {"trace", "@there.svg", "-o", "@out.svg"}},
    {"TraceNoFolder", {"trace", "@map.svg", "-o", "@none/out.svg"}},
    {"TraceOverAFolder", {"trace", "@map.svg", "-o", "@pack"}},
    {"TraceNoReport", {"trace", "@map.svg", "-o", "@out.svg", "--json", "@none/report.json"}},
    {"TraceNoEdges", {"trace", "@map.svg", "-o", "@out.svg", "--edges", "@none/edges.png"}},
    {"TraceArea", {"trace", "@map.svg", "-o", "@out.svg", "--area", "@"}},
    {"TraceClass", {"trace", "@map.svg", "-o", "@out.svg", "--class", "@"}},
    {"TraceDetail", {"trace", "@map.svg", "-o", "@out.svg", "--detail", "@"}},
    {"CurveNone", {"curve", "@none.svg", "--level", "0", "-o", "@out.svg"}},
    {"CurveBroken", {"curve", "@there.svg", "--level", "0", "-o", "@out.svg"}},
    {"CurveBrokenPicture", {"curve", "@there.svg", "--picture", "--level", "0", "-o", "@out.svg"}},
    {"CurveNoFolder", {"curve", "@map.svg", "--level", "0", "-o", "@none/out.svg"}},
    {"CurveLevel", {"curve", "@map.svg", "--level", "@", "-o", "@out.svg"}},
    {"FeelNone", {"feel", "@none.svg", "--path", "@hand.csv", "-o", "@run.csv"}},
    {"FeelBroken", {"feel", "@there.svg", "--path", "@hand.csv", "-o", "@run.csv"}},
    {"FeelNoHand", {"feel", "@map.svg", "--path", "@none.csv", "-o", "@run.csv"}},
    {"FeelBrokenHand", {"feel", "@map.svg", "--path", "@there.csv", "-o", "@run.csv"}},
    {"FeelNoFolder", {"feel", "@map.svg", "--path", "@hand.csv", "-o", "@none/run.csv"}},
    {"FeelNoShape",
     {"feel", "@map.svg", "--path", "@hand.csv", "--probe", "@none.svg", "-o", "@run.csv"}},
    {"FeelBrokenShape",
     {"feel", "@map.svg", "--path", "@hand.csv", "--probe", "@there.svg", "-o", "@run.csv"}},
    {"FeelMode", {"feel", "@map.svg", "--path", "@hand.csv", "--mode", "@", "-o", "@run.csv"}},
    {"FeelLevel", {"feel", "@map.svg", "--path", "@hand.csv", "--level", "@", "-o", "@run.csv"}},
    {"FeelProfile",
     {"feel", "@map.svg", "--path", "@hand.csv", "--profile", "@", "-o", "@run.csv"}},
    {"ReplayNone", {"feel", "--replay", "@none.touchline", "-o", "@run.csv"}},
    {"ReplayBroken", {"feel", "--replay", "@there.touchline", "-o", "@run.csv"}},
    {"TourNone", {"tour", "@none.svg", "-o", "@run.png"}},
    {"TourBroken", {"tour", "@there.svg", "-o", "@run.png"}},
    {"TourNoFolder", {"tour", "@map.svg", "-o", "@none/run.png"}},
    {"DeviceProfile", {"device", "list", "--profile", "@"}},
    {"DeviceUnknown", {"device", "@"}},
    {"SettingsNone", {"settings", "check", "@nowhere.toml"}},
    {"SettingsBroken", {"settings", "check", "@there.toml"}},
    {"SettingsGood", {"settings", "check", "@good.toml"}},
    {"SettingsOfTheSite", {"settings", "check"}},
    {"SettingsPrint", {"settings", "print", "@there.toml"}},
    {"PackNone", {"pack", "check", "@none.zip"}},
    {"PackBroken", {"pack", "check", "@there.zip"}},
    {"PackEmpty", {"pack", "check", "@pack"}},
    {"PackImportNone", {"pack", "import", "@none.zip"}},
    {"PackImportBroken", {"pack", "import", "@there.zip"}},
    {"PackExport", {"pack", "export", "@pack", "-o", "@none/out.zip"}},
    {"PackExportLanguage", {"pack", "export", "@pack", "-o", "@out.zip", "--image", "@"}},
    {"KioskNone", {"@none.png"}},
};

INSTANTIATE_TEST_SUITE_P(EveryCommand, HostileNames, testing::ValuesIn(calls),
                         [](const auto& call) { return std::string(call.param.name); });

}  // namespace
}  // namespace touchline
