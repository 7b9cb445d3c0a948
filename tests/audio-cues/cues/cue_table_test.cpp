#include "audio-cues/cues/cue_table.h"

#include "tests/audio-cues/spectrum.h"

#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

std::string rows_as_markdown(std::span<const EventRow> rows) {
    std::string text;
    for (const EventRow& row : rows) {
        text += fmt::format("| {} | {}{} |\n", row.event,
                            row.cue ? row_of(*row.cue).name : "finer, coarser",
                            row.is_alert ? ", always" : "");
    }
    return text;
}

std::string cues_as_markdown() {
    std::string text = "| what happens | sound |\n|---|---|\n";
    text += rows_as_markdown(contact_rows()) + rows_as_markdown(screen_rows());
    text += "\n| sound | like | ms |\n|---|---|---|\n";
    for (const CueRow& row : cue_table()) {
        text += fmt::format("| {} | {} | {:.0f} |\n", row.name, row.sound,
                            1000.0 * length_s(row.earcon));
    }
    return text;
}

TEST(CueTable, HasTwelveSoundsInTheirOrderOfAQuarterSecondAtMost) {
    ASSERT_LE(cue_table().size(), 12U);
    std::set<std::string_view> names;
    std::set<std::string_view> sounds;
    for (std::size_t i = 0; i < cue_table().size(); ++i) {
        const CueRow& row = cue_table()[i];
        EXPECT_EQ(static_cast<std::size_t>(row.cue), i);
        EXPECT_LE(length_s(row.earcon), 0.250) << row.name;
        EXPECT_GE(length_s(row.earcon), 0.030) << row.name;
        EXPECT_TRUE(names.insert(row.name).second);
        EXPECT_TRUE(sounds.insert(row.sound).second);
    }
}

TEST(CueTable, EveryEventHasARowInItsOrder) {
    EXPECT_EQ(contact_rows().size(), contact_event_count);
    EXPECT_EQ(screen_rows().size(), screen_event_count);
    for (const EventRow& row : screen_rows()) EXPECT_TRUE(row.cue) << row.event;
    EXPECT_EQ(contact_rows()[static_cast<std::size_t>(ContactEventKind::end_reached)].cue,
              Cue::end);
    EXPECT_EQ(contact_rows()[static_cast<std::size_t>(ContactEventKind::area_left)].cue,
              Cue::area_left);
}

TEST(CueTable, EverySoundOfIt_IsHeardWithoutAClickAndDiffersFromItsOpposite) {
    std::vector<double> pitches_Hz;
    for (const CueRow& row : cue_table()) {
        Mixer mixer;
        mixer.send(sound_of({row.cue, 0.0, 0.0, false}, 2000));
        const auto sound = left_of_stereo(rendered(mixer, 16384));
        EXPECT_GT(peak(sound), 0.05F) << row.name;
        EXPECT_LE(peak(sound), 0.7F) << row.name;
        EXPECT_LT(loudest_above_dB(sound, 12000.0), -60.0) << row.name;
        pitches_Hz.push_back(strongest_Hz(sound));
    }
    const auto pitch_Hz = [&](Cue cue) { return pitches_Hz[static_cast<std::size_t>(cue)]; };
    EXPECT_GT(pitch_Hz(Cue::touch), 1.8 * pitch_Hz(Cue::leave));
    EXPECT_GT(pitch_Hz(Cue::corner), 1.8 * pitch_Hz(Cue::end));
    EXPECT_GT(pitch_Hz(Cue::key), 1.8 * pitch_Hz(Cue::refused));
}

TEST(CueTable, SlidesAndPairsOfNotesGoTheWayTheirNamesSay) {
    const auto halves_Hz = [](Cue cue) {
        const auto& notes = row_of(cue).earcon.notes;
        const int count = row_of(cue).earcon.note_count;
        return std::pair(notes[0].begin_Hz, notes[static_cast<std::size_t>(count - 1)].end_Hz);
    };
    for (const Cue up : {Cue::finer, Cue::area_entered}) {
        EXPECT_GT(halves_Hz(up).second, 1.2 * halves_Hz(up).first);
    }
    for (const Cue down : {Cue::coarser, Cue::area_left}) {
        EXPECT_LT(1.2 * halves_Hz(down).second, halves_Hz(down).first);
    }
}

TEST(CueTable, TheReadmeShowsIt) {
    std::ifstream file(TOUCHLINE_SOURCE_DIR "/audio-cues/cues/README.md");
    const std::string readme{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(readme.find(cues_as_markdown()), std::string::npos) << cues_as_markdown();
}

}  // namespace
}  // namespace touchline
