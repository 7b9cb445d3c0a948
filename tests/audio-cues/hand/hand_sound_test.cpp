#include "tests/audio-cues/hand/hand_sound.h"

#include "app/documents/decode/map_svg.h"
#include "audio-cues/cues/cue_table.h"
#include "tests/audio-cues/hand/rows_of_picture.h"
#include "tests/audio-cues/spectrum.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Vertical lines from edge to edge.
TactileMap fence(const std::vector<double>& at_m) {
    TactileMap map;
    for (const double x_m : at_m) {
        Outline line;
        line.points = {{x_m, -0.035}, {x_m, 0.035}};
        line.id = "line" + std::to_string(map.outlines.size());
        map.outlines.push_back(line);
    }
    return map;
}

HandRun across(const TactileMap& map, double from_m, double to_m) {
    const auto run = follow(map, {{from_m, 0.0}, {to_m, 0.0}}, 0.04);
    EXPECT_TRUE(run) << (run ? "" : run.error().line);
    return run.value_or(HandRun{});
}

/// The frames at which a sound begins after at least 60 ms of near silence.
std::vector<std::size_t> onsets(const std::vector<StereoFrame>& sound) {
    std::vector<std::size_t> found;
    std::size_t quiet = 48000;
    for (std::size_t i = 0; i < sound.size(); ++i) {
        const bool sounds = std::max(std::abs(sound[i].left), std::abs(sound[i].right)) > 0.02F;
        if (sounds && quiet > 2880) found.push_back(i);
        quiet = sounds ? 0 : quiet + 1;
    }
    return found;
}

/// The level of right over left in the next 50 ms, in dB.
double side_dB(const std::vector<StereoFrame>& sound, std::size_t at) {
    const auto part = std::span(sound).subspan(at, std::min<std::size_t>(2400, sound.size() - at));
    return 20.0 * std::log10(rms(right_of_stereo(part)) / rms(left_of_stereo(part)));
}

TEST(HandSound, LinesCanBeCounted) {
    for (std::size_t count = 1; count <= 5; ++count) {
        std::vector<double> at_m;
        for (std::size_t i = 0; i < count; ++i)
            at_m.push_back(-0.03 + 0.014 * static_cast<double>(i));
        const HandRun run = across(fence(at_m), -0.05, 0.05);
        const auto touches = std::count_if(
            run.events.begin(), run.events.end(),
            [](const ContactEvent& event) { return event.kind == ContactEventKind::contact_made; });
        EXPECT_EQ(static_cast<std::size_t>(touches), count);
        // Each line is one group of sounds: touched, crossed and left within a fifth of a second.
        const auto sound = sound_of(run, CueAmount::cues);
        std::size_t groups = 0;
        std::size_t last = 0;
        for (const std::size_t onset : onsets(sound)) {
            if (groups == 0 || onset - last > 12000) ++groups;
            last = onset;
        }
        EXPECT_EQ(groups, count) << count << " lines 14 mm apart at 40 mm/s";
    }
}

TEST(HandSound, LeftAndRightAreToldApart) {
    const auto sound = sound_of(across(fence({-0.04, 0.04}), -0.05, 0.05), CueAmount::cues);
    const auto found = onsets(sound);
    ASSERT_GE(found.size(), 2U);
    EXPECT_LT(side_dB(sound, found.front()), -6.0);
    EXPECT_GT(side_dB(sound, found.back()), 6.0);
}

/// The pulses a second that are heard by a hand that sways between two distances from a line.
double pulses_Hz(double nearest_m, double furthest_m) {
    constexpr double line_x_m = 0.03;
    std::vector<Position> way;
    for (int i = 0; i < 50; ++i)
        way.push_back({line_x_m - (i % 2 == 0 ? furthest_m : nearest_m), 0.0});
    const auto run = follow(fence({line_x_m}), way, 0.01);
    EXPECT_TRUE(run);
    const auto sound = left_of_stereo(sound_of(*run, CueAmount::full));
    int pulses = 0;
    bool was_quiet = true;
    for (std::size_t i = 0; i + 240 < sound.size(); i += 240) {
        const bool is_quiet = rms(std::span(sound).subspan(i, 240)) < 0.02;
        pulses += was_quiet && !is_quiet ? 1 : 0;
        was_quiet = is_quiet;
    }
    return pulses / (1e-3 * static_cast<double>(run->handle.size()));
}

TEST(HandSound, NearAndFarAreToldApartAndWhatIsNeitherIsQuiet) {
    const double far_Hz = pulses_Hz(0.012, 0.014);
    const double near_Hz = pulses_Hz(0.004, 0.006);
    EXPECT_GT(far_Hz, 1.0);
    EXPECT_GT(near_Hz, 1.8 * far_Hz) << near_Hz << " " << far_Hz;
    EXPECT_EQ(pulses_Hz(0.020, 0.022), 0.0) << "beyond the range";
}

TEST(HandSound, EveryCueIsWithinABlockOfItsEvent) {
    const HandRun run = across(fence({0.0}), -0.03, 0.03);
    const auto first = std::find_if(run.events.begin(), run.events.end(), [](const auto& event) {
        return contact_rows()[static_cast<std::size_t>(event.kind)].cue.has_value();
    });
    ASSERT_NE(first, run.events.end());
    const auto sound = left_of_stereo(sound_of(run, CueAmount::cues));
    const double at_s = static_cast<double>(first_sound(sound)) / frame_rate_Hz;
    EXPECT_GE(at_s, first->time_s);
    EXPECT_LE(at_s - first->time_s, 0.001 + 128.0 / frame_rate_Hz) << "a tick and a block";
}

TEST(HandSound, ThreePicturesOfTheGalleryAreHeardWithoutClicksOrOverload) {
    for (const char* name : {"01-shapes", "06-fish", "07-house"}) {
        const auto map = read_map_svg(TOUCHLINE_SOURCE_DIR "/app/documents/gallery/pictures/" +
                                      std::string(name) + ".svg");
        ASSERT_TRUE(map);
        const auto run = follow(*map, rows_of_picture(map->area), 0.04);
        ASSERT_TRUE(run);
        EXPECT_GE(run->events.size(), 6U) << name;
        const auto sound = sound_of(*run, CueAmount::full);
        EXPECT_GT(peak(left_of_stereo(sound)), 0.1F);
        EXPECT_LE(peak(left_of_stereo(sound)), 1.0F);
        EXPECT_LT(loudest_above_dB(left_of_stereo(sound), 14000.0), -60.0) << name;
    }
}

}  // namespace
}  // namespace touchline
