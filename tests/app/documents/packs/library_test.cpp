// Tests packs as they are installed, replaced, listed and heard.
#include "app/documents/packs/pack.h"
#include "app/documents/packs/pack_library.h"
#include "audio-cues/words/language.h"
#include "tests/app/documents/packs/made_packs.h"
#include "tests/config/scratch_folder.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <sndfile.h>
#include <unistd.h>

namespace touchline {
namespace {

Pack example() {
    auto pack = read_pack(made::example_pack());
    EXPECT_TRUE(pack.has_value());
    return pack ? std::move(*pack) : Pack{};
}

Pack with_version(Pack pack, PackVersion version) {
    pack.info.version = version;
    for (PackFile& file : pack.files)
        if (file.name == "pack.toml") file.bytes = made::bytes_of(toml_of(pack.info));
    return pack;
}

std::vector<std::string> names_in(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.push_back(entry.path().filename());
    return names;
}

TEST(Library, HoldsAPackBitForBit) {
    const ScratchFolder library;
    const auto place = import_pack(example(), library.path());
    ASSERT_TRUE(place.has_value()) << sentence_of(place.error(), Language());
    EXPECT_TRUE(*read_pack(*place) == example());
    EXPECT_EQ(names_in(library.path()), std::vector<std::string>{"shapes-and-a-boat"});
}

TEST(Library, TakesANewerVersionAndAsksBeforeAnOlder) {
    const ScratchFolder library;
    ASSERT_TRUE(import_pack(example(), library.path()).has_value());
    ASSERT_TRUE(import_pack(with_version(example(), {2, 0, 0}), library.path()).has_value());
    const auto older = import_pack(example(), library.path());
    ASSERT_FALSE(older.has_value());
    EXPECT_EQ(older.error().kind, FindingKind::older);
    EXPECT_EQ(older.error().what, "2.0.0");
    const std::string place = library.path_of("shapes-and-a-boat");
    EXPECT_EQ(read_pack(place)->info.version, (PackVersion{2, 0, 0}));
    ASSERT_TRUE(import_pack(example(), library.path(), OlderPack::take).has_value());
    EXPECT_EQ(read_pack(place)->info.version, (PackVersion{1, 0, 0}));
    EXPECT_EQ(names_in(library.path()).size(), 1U);
}

TEST(Library, AFileThatTheNewVersionLacksIsGone) {
    const ScratchFolder library;
    Pack first = example();
    first.files.push_back({"zz.txt", made::bytes_of("notes")});
    ASSERT_TRUE(import_pack(first, library.path()).has_value());
    ASSERT_TRUE(import_pack(example(), library.path()).has_value());
    EXPECT_FALSE(std::filesystem::exists(library.path_of("shapes-and-a-boat/zz.txt")));
}

TEST(Library, KeepsTheOldVersionWhenTheNewOneCannotBeUsed) {
    const ScratchFolder library;
    ASSERT_TRUE(import_pack(example(), library.path()).has_value());
    Pack broken = with_version(example(), {3, 0, 0});
    for (PackFile& file : broken.files)
        if (file.name == "boat.svg") file.bytes = made::bytes_of("<svg");
    const auto refused = import_pack(broken, library.path());
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().kind, FindingKind::picture_broken);
    EXPECT_EQ(refused.error().file, "boat.svg");
    EXPECT_TRUE(*read_pack(library.path_of("shapes-and-a-boat")) == example());
}

/// Leftovers of an import that lost power.
TEST(Library, LeftoversAreNoPacksAndAreCleaned) {
    const ScratchFolder library;
    library.write(".unfinished-x-1/pack.toml", "half");
    std::vector<PackFinding> problems;
    EXPECT_TRUE(list_library(library.path(), {}, problems).empty());
    EXPECT_TRUE(problems.empty());
    ASSERT_TRUE(import_pack(example(), library.path()).has_value());
    EXPECT_EQ(names_in(library.path()).size(), 1U);
}

TEST(Library, ThatCannotBeWrittenIsSaid) {
    const auto refused = import_pack(example(), "/proc/touchline");
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().kind, FindingKind::library_unwritable);
}

TEST(Library, IsListedInALanguage) {
    const ScratchFolder library;
    ASSERT_TRUE(import_pack(example(), library.path()).has_value());
    library.write("broken/pack.toml", "id = 7");
    std::vector<PackFinding> problems;
    const auto pictures = list_library(library.path(), {"de"}, problems);
    ASSERT_EQ(pictures.size(), 2U);
    EXPECT_EQ(pictures[0].entry.title, "Ein Kreis");
    EXPECT_EQ(pictures[0].entry.difficulty, 1);
    EXPECT_EQ(pictures[1].entry.title, "Ein Boot");
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].file, "broken/pack.toml");
    const auto map = read_pack_map(pictures[1].entry.path, {"de"});
    ASSERT_TRUE(map.has_value());
    EXPECT_EQ(map->outlines[1].label, "Segel");
}

/// What is recorded of the picture, as the kiosk asks for it.
PictureRecordingsPtr recorded(const LibraryPicture& picture, const std::string& language,
                              std::vector<PackFinding>& problems) {
    const auto map = read_pack_map(picture.entry.path, {language});
    EXPECT_TRUE(map.has_value());
    return map ? recordings_of(picture, *map, {language}, problems) : nullptr;
}

TEST(Library, RecordingsTakeThePlaceOfTheVoice) {
    const ScratchFolder library;
    ASSERT_TRUE(import_pack(example(), library.path()).has_value());
    std::vector<PackFinding> problems;
    const auto pictures = list_library(library.path(), {"en"}, problems);
    ASSERT_EQ(pictures.size(), 2U);
    const auto circle = recorded(pictures[0], "en", problems);
    ASSERT_NE(circle, nullptr);
    EXPECT_NE(circle->description, nullptr);
    EXPECT_EQ(circle->title, nullptr);
    EXPECT_TRUE(circle->parts.empty());
    const auto boat = recorded(pictures[1], "en", problems);
    ASSERT_NE(boat, nullptr);
    ASSERT_EQ(boat->parts.size(), 1U);
    EXPECT_EQ(boat->parts[0].first, "Sail");
    EXPECT_GT(boat->parts[0].second->samples.size(), 10000U);
    EXPECT_EQ(recorded(pictures[1], "de", problems), nullptr);
    EXPECT_TRUE(problems.empty());
}

/// The example, with a recording of the boat's title.
Pack with_title(const std::string& language, double long_s) {
    Pack pack = with_version(example(), {1, 0, 0});
    const int wav = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
    pack.info.sounds.push_back({"voices/title.wav", "boat.svg", language, SoundText::title, {}});
    pack.files.push_back({"voices/title.wav", made::recording(wav, 22050, long_s)});
    std::ranges::sort(pack.files, {}, &PackFile::name);
    return with_version(std::move(pack), {1, 0, 0});
}

TEST(Library, ARecordingServesTheFormsOfItsLanguage) {
    const ScratchFolder library;
    ASSERT_TRUE(import_pack(with_title("de-AT", 1.0), library.path()).has_value());
    std::vector<PackFinding> problems;
    for (const char* const language : {"de", "de-at", "de-CH"}) {
        const auto pictures = list_library(library.path(), {language}, problems);
        ASSERT_EQ(pictures.size(), 2U);
        EXPECT_EQ(pictures[0].title_recording, nullptr);
        EXPECT_NE(pictures[1].title_recording, nullptr) << language;
        EXPECT_NE(recorded(pictures[1], language, problems)->title, nullptr);
    }
    EXPECT_EQ(list_library(library.path(), {"en"}, problems)[1].title_recording, nullptr);
}

TEST(Library, ALongTitleIsHeardWithItsPictureAlone) {
    const ScratchFolder library;
    ASSERT_TRUE(import_pack(with_title("en", 6.0), library.path()).has_value());
    std::vector<PackFinding> problems;
    const auto pictures = list_library(library.path(), {"en"}, problems);
    EXPECT_EQ(pictures[1].title_recording, nullptr);
    EXPECT_NEAR(length_s(*recorded(pictures[1], "en", problems)->title), 6.0, 0.01);
}

TEST(Library, ADamagedRecordingIsAProblemAndNoSound) {
    const ScratchFolder library;
    ASSERT_TRUE(import_pack(with_title("en", 1.0), library.path()).has_value());
    library.write("shapes-and-a-boat/voices/title.wav", "RIFF....WAVE");
    library.write("shapes-and-a-boat/voices/sail-en.flac", "");
    std::vector<PackFinding> problems;
    const auto pictures = list_library(library.path(), {"en"}, problems);
    ASSERT_EQ(pictures.size(), 2U);
    EXPECT_EQ(pictures[1].title_recording, nullptr);
    EXPECT_EQ(recorded(pictures[1], "en", problems), nullptr);
    ASSERT_EQ(problems.size(), 3U) << "in the list, and twice with the picture";
    EXPECT_EQ(problems[0].file, "title.wav");
}

TEST(Check, PartsThatARecordingNamesMustBeThere) {
    Pack pack = example();
    pack.info.sounds[1].part = "mast";
    const auto findings = check_pack(pack);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].kind, FindingKind::no_such_part);
    EXPECT_TRUE(can_be_used(findings));
}

}  // namespace
}  // namespace touchline
