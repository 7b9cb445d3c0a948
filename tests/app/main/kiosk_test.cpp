// Tests the program itself: its keys, its end, and what it says of what it lacks.
#include "tests/app/main/kiosk_program.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

using Kiosk = KioskProgram;

TEST_F(Kiosk, QuitsOnItsKey) {
    EXPECT_EQ(run_script("kiosk; quit"), 0);
    EXPECT_EQ(complaints(), "");
}

TEST_F(Kiosk, RunsInAWindowToo) {
    EXPECT_EQ(run_script("kiosk --window; quit"), 0);
}

TEST_F(Kiosk, EveryKeyLeavesItRunning) {
    EXPECT_EQ(run_script("kiosk; keys Return Return Down Up Right Left h h h Return Return v b b v;"
                         "keys a a z z comma period minus equal c o F16 F15 t 5;"
                         "kill -0 $pid || exit 9; quit"),
              0);
    EXPECT_EQ(complaints(), "");
}

/// Somebody draws with the mouse: the line is thin and blue until it is finished, and U undoes it.
TEST_F(Kiosk, ALineDrawnWithThePointerIsThere) {
    const std::string draw = R"sh(
        grep -q offers_drawing kiosk.toml || printf '[feel]\noffers_drawing = true\n' >>kiosk.toml
        share() {
            import -window root shot.png
            convert shot.png -fuzz 30% -crop 400x380+0+60 +repage -fill black +opaque $1 \
                -fill white -opaque $1 -format '%[fx:int(mean*w*h)]' info:
        }
        await() {
            step=$((step + 1))
            for _ in $(seq 300); do [ $(share $1) $2 $3 ] && return; sleep 0.1; done
            exit $((20 + step))
        }
        kiosk
        await '#FFD400' -gt 100
        keys Return Return Down Down Down Down Return
        await '#2EF2C7' -gt 10
        [ $(share '#FFD400') = 0 ] || exit 8
        xdotool mousemove 120 300 mousedown 1
        # To and fro: a busy kiosk may see only where the pointer is at last.
        for _ in $(seq 30); do
            for x in 160 200 240 280 320; do xdotool mousemove $x 300; sleep 0.1; done
            [ $(share '#5CC7FF') -gt 100 ] && break
            for x in 280 240 200 160 120; do xdotool mousemove $x 300; sleep 0.1; done
        done
        await '#5CC7FF' -gt 100
        xdotool mouseup 1
        await '#FFD400' -gt 200
        keys u
        await '#FFD400' -eq 0
        quit
    )sh";
    EXPECT_EQ(run_script(draw), 0);
    EXPECT_EQ(complaints(), "");
}

/// R alone holds the recording; after the operator's screens and a PIN, chosen twice, R saves it.
TEST_F(Kiosk, KeepsARecordingForTheOperatorThatRunsAgainTheSame) {
    EXPECT_EQ(
        run_script("kiosk; keys b r b; [ -e kept ] && exit 9; keys h Up Up Down Down Return;"
                   "for i in 1 2; do keys Up Return Up Return Up Return Up Return Return; done;"
                   "keys r; wait_for 'recording was kept' err.txt; kill $pid;"
                   "wait $pid; \"$program\" feel --replay kept/recording-1.touchline"
                   " -o run.csv >out.txt"),
        0)
        << complaints();
    EXPECT_NE(text_of("out.txt").find("the same, bit for bit"), std::string::npos)
        << text_of("out.txt");
}

/// SDL writes to a file instead of a card: it has more than clicks, so somebody spoke.
TEST_F(Kiosk, IsHeard) {
    EXPECT_EQ(
        run_script(
            "export SDL_AUDIODRIVER=disk SDL_DISKAUDIOFILE=heard.raw; kiosk; keys Return Return;"
            "for _ in $(seq 1000); do [ -e heard.raw ] && "
            "[ $(tr -d '\\0' <heard.raw | wc -c) -gt 300000 ] && break; sleep 0.1; done;"
            "[ $(tr -d '\\0' <heard.raw | wc -c) -gt 300000 ] || exit 9; quit"),
        0);
}

TEST_F(Kiosk, WithoutAnySoundItGoesOnAndSaysSoOnce) {
    EXPECT_EQ(run_script("export SDL_AUDIODRIVER=none; kiosk; keys Return Return Down;"
                         "wait_for 'no sound' err.txt; keys Up Down; kill -0 $pid || exit 9;"
                         "[ $(grep -c 'there is no sound: ' err.txt) = 1 ] || exit 8; quit"),
              0);
    EXPECT_EQ(complaints(), "");
}

TEST_F(Kiosk, WithoutAPantographItSaysSoOnce) {
    EXPECT_EQ(run_script("kiosk; wait_for pantograph err.txt; keys b; quit"), 0);
    const std::string words = text_of("err.txt");
    const std::size_t first = words.find("touchline: there is no pantograph: ");
    EXPECT_NE(first, std::string::npos) << words;
    EXPECT_EQ(words.find("pantograph", first + 35), std::string::npos) << words;
}

TEST_F(Kiosk, BadLevelsAreOneLineAndTheDefaultsCount) {
    EXPECT_EQ(run_script("echo '[headset]' >loud.toml; echo 'cap_dB = 130' >>loud.toml;"
                         "export TOUCHLINE_SOUND=loud.toml; kiosk; keys b; quit"),
              0);
    EXPECT_EQ(complaints(),
              "touchline: loud.toml:2: 'cap_dB' must be a number from 60 to 105, in dB\n");
}

TEST_F(Kiosk, LeavesNoCoreDump) {
    EXPECT_EQ(run_script("kiosk; keys b; grep -qE 'Max core file size +0 +0 ' /proc/$pid/limits ||"
                         " exit 9; quit"),
              0);
}

TEST_F(Kiosk, EndsAsAskedByTheSystem) {
    EXPECT_EQ(run_script("kiosk; keys b; kill -TERM $pid; finish"), 0);
}

/// A display that does not answer blocks the main thread for ever.
TEST_F(Kiosk, EndsAsAskedThoughItsDisplayHangs) {
    EXPECT_EQ(
        run_script("server=$(pgrep -x Xvfb -P \"$(ps -o ppid= -p $PPID | tr -d ' ')\") || exit 9;"
                   "kiosk; keys b; kill -STOP $server; kill -TERM $pid; wait $pid; status=$?;"
                   "kill -CONT $server; exit $status"),
        1);
    EXPECT_NE(complaints().find("something hangs"), std::string::npos) << complaints();
}

TEST_F(Kiosk, ABadPictureIsOneLineAndTheSessionGoesOn) {
    EXPECT_EQ(
        run_script("echo 'not a picture' >bad.png; kiosk bad.png; keys b; sleep 1; keys Return "
                   "Return Down Down "
                   "Return Return;"
                   "wait_for bad err.txt; keys Return; kill -0 $pid || exit 9; quit"),
        0);
    const std::string words = complaints();
    EXPECT_NE(words.find("bad.png"), std::string::npos);
    EXPECT_EQ(std::count(words.begin(), words.end(), '\n'), 1) << words;
}

TEST_F(Kiosk, WithoutABusIsOneLine) {
    std::ofstream(folder_ / "kiosk.toml") << "[stick]\nwatched_folder = ''\n";
    EXPECT_EQ(run_script("export DBUS_SYSTEM_BUS_ADDRESS=unix:path=/nowhere/bus; kiosk;"
                         "wait_for sticks err.txt; keys Down; quit"),
              0);
    const std::string words = complaints();
    EXPECT_NE(words.find("sticks are not offered"), std::string::npos) << words;
    EXPECT_EQ(std::count(words.begin(), words.end(), '\n'), 1) << words;
}

TEST_F(Kiosk, SettingsAreReadAndAWrongFileIsOneLineWhileItRuns) {
    EXPECT_EQ(run_script("kiosk; keys b; printf '[feel]\\nfriction = 7\\n' >kiosk.toml;"
                         "wait_for friction err.txt; kill -0 $pid || exit 9; quit"),
              0);
    const std::string words = complaints();
    EXPECT_NE(words.find("kiosk.toml:2: 'feel.friction' must be a number from 0 to 1; the "
                         "settings before hold\n"),
              std::string::npos)
        << words;
    EXPECT_EQ(std::count(words.begin(), words.end(), '\n'), 1) << words;
}

TEST_F(Kiosk, GoesThroughThePagesOfADocument) {
    EXPECT_EQ(
        run_script("printf '%s' '<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"400\" "
                   "height=\"500\"><rect x=\"50\" y=\"60\" width=\"200\" height=\"300\" "
                   "fill=\"none\" stroke=\"black\" stroke-width=\"6\"/></svg>' >page.svg &&"
                   "rsvg-convert -f pdf -o book.pdf page.svg page.svg page.svg &&"
                   "kiosk book.pdf; keys b; sleep 1; keys Return Return Down Down Return Return;"
                   "sleep 2; keys Up Up Return Return Down Return;"
                   "kill -0 $pid || exit 9; quit"),
        0);
    EXPECT_EQ(complaints(), "");
}

TEST_F(Kiosk, DrawsTheOutlinesOnTheScreen) {
    ASSERT_EQ(run_script("kiosk; keys Return Return Return; for _ in $(seq 100); do "
                         "import -window root screen.png; convert screen.png -fill black +opaque "
                         "'#FFD400' -format '%[fx:mean]' info: >yellow.txt; "
                         "grep -qE '[1-9]' yellow.txt && break; sleep 0.5; done; quit"),
              0);
    EXPECT_GT(std::stod(text_of("yellow.txt")), 1e-4);
}

TEST_F(Kiosk, CountsTicksAndFramesWithTheWindowAndWithout) {
    EXPECT_EQ(run_script("kiosk --measure 2; wait $pid && "
                         "grep -qE 'with the window: [0-9.]+ s, [1-9][0-9]* ticks, [0-9]+ missed, "
                         "[1-9][0-9]* frames, [0-9]+ skipped' out.txt && "
                         "grep -qE 'without the window: [0-9.]+ s, [1-9][0-9]* ticks, "
                         "[0-9]+ missed' out.txt"),
              0)
        << text_of("out.txt");
}

TEST_F(Kiosk, WithoutADisplayIsOneLine) {
    EXPECT_EQ(run_script("kiosk; finish", false), 1);
    const std::string words = complaints();
    EXPECT_NE(words.find("touchline tour"), std::string::npos);
    EXPECT_EQ(std::count(words.begin(), words.end(), '\n'), 1) << words;
}

TEST_F(Kiosk, ATourNeedsNoDisplay) {
    EXPECT_EQ(run_script("\"$program\" tour \"$TOUCHLINE_GALLERY\"/05-key.svg -o key.png >out.txt",
                         false),
              0);
    EXPECT_NE(text_of("out.txt").find("2 of 2 outlines"), std::string::npos);
    EXPECT_TRUE(fs::exists(folder_ / "key.png"));
}

}  // namespace
}  // namespace touchline
