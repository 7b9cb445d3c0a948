// Tests packs that are made from a curator's folder.
#include "app/cli/options.h"
#include "app/documents/decode/map_svg.h"
#include "app/documents/packs/curator_folder.h"
#include "app/documents/packs/curator_texts.h"
#include "app/documents/packs/pack_library.h"
#include "app/documents/packs/pack_making.h"
#include "app/documents/packs/spoken_map.h"
#include "app/documents/packs/unpacking.h"
#include "audio-cues/words/language.h"
#include "config/types/map_frame.h"
#include "config/types/utf8.h"
#include "tests/app/documents/packs/made_packs.h"
#include "tests/config/mutated.h"
#include "tests/config/scratch_folder.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sndfile.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr const char* boat_svg =
    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"116mm\" height=\"84mm\" "
    "viewBox=\"0 0 116 84\" data-difficulty=\"2\">"
    "<path id=\"hull\" d=\"M18 58 L98 58 L88 74 L28 74 Z\"/>"
    "<path id=\"sail\" d=\"M38 48 L78 48 L58 10 Z M58 30 L58 40\"/></svg>";

constexpr const char* pack_txt =
    "# The summer show\ntitle: At the quay\ntitle de: Am Kai\nauthor: A museum\n"
    "licence: CC0-1.0\nversion: 1.2\nlanguages: en, de\n";

/// The same bytes each time: an encoder of OGG draws a number for each.
const std::string& ogg_bytes() {
    static const std::string bytes = made::text_of(made::ogg());
    return bytes;
}

std::string wav() {
    return made::text_of(made::recording(SF_FORMAT_WAV | SF_FORMAT_PCM_16, 22050, 0.3));
}

/// What the guide of the packs shows.
void write_folder(const ScratchFolder& folder, const std::string& name = "The Old Quay") {
    const auto write = [&](const std::string& file, const std::string& text) {
        folder.write(name + '/' + file, text);
    };
    write("pack.txt", pack_txt);
    write("boat.svg", boat_svg);
    write("boat.txt",
          "\xef\xbb\xbftitle: A boat & its crew\r\ndescription: It lies at the quay,\r\n"
          "  its bow to the left.\r\ndifficulty: 3\r\npart hull: Hull\r\npart sail: Sail\r\n");
    write("boat.de.txt",
          "title: Ein Boot\ndescription: Es liegt am Kai.\npart hull: Rumpf\npart sail: Segel\n");
    write("boat.ogg", ogg_bytes());
    write("boat.de.title.wav", wav());
    write("boat.sail.wav", wav());
    write(".DS_Store", "litter");
    write("ring.svg", made::small_pack()[1].contents);
}

Result<TactileMap> no_tracing(const std::string& path) {
    return failure(path + ": nothing is traced here");
}

MadePack made_from(const fs::path& folder) {
    return make_pack(folder.string(), no_tracing);
}

TEST(PackMaking, AFolderBecomesAPackThatReadsBackTheSame) {
    const ScratchFolder scratch;
    write_folder(scratch);
    const MadePack made = made_from(scratch.path() / "The Old Quay");
    ASSERT_TRUE(made.faults.empty()) << made.faults.front();
    EXPECT_EQ(made.pack.info.id, "the-old-quay");
    EXPECT_EQ(made.pack.info.version, (PackVersion{1, 2, 0}));
    EXPECT_EQ(title_in(made.pack.info, "de"), "Am Kai");
    EXPECT_EQ(made.pack.info.pictures,
              (std::vector<PackPicture>{{"boat.svg", 3}, {"ring.svg", 1}}));
    const std::vector<PackSound> sounds{
        {"boat.de.title.wav", "boat.svg", "de", SoundText::title, ""},
        {"boat.ogg", "boat.svg", "en", SoundText::description, ""},
        {"boat.sail.wav", "boat.svg", "en", SoundText::part, "sail"}};
    EXPECT_EQ(made.pack.info.sounds, sounds);
    const auto zip = zip_of(made.pack);
    ASSERT_TRUE(zip.has_value());
    EXPECT_TRUE(*read_pack(*zip) == made.pack);
}

TEST(PackMaking, TheTextsAreInThePictureAndItsLinesAreTheSame) {
    const ScratchFolder scratch;
    write_folder(scratch);
    const MadePack made = made_from(scratch.path() / "The Old Quay");
    ASSERT_TRUE(made.faults.empty()) << made.faults.front();
    const PackFile& boat = *find_file(made.pack, "boat.svg");
    const auto english = open_picture(boat, {"en"});
    const auto german = open_picture(boat, {"de"});
    ASSERT_TRUE(english.has_value() && german.has_value());
    EXPECT_EQ(english->map.title, "A boat & its crew");
    EXPECT_EQ(english->map.description, "It lies at the quay, its bow to the left.");
    EXPECT_EQ(german->map.title, "Ein Boot");
    const auto before = parse_map_svg(boat_svg);
    ASSERT_TRUE(before.has_value());
    ASSERT_EQ(english->map.outlines.size(), before->outlines.size());
    for (std::size_t i = 0; i < before->outlines.size(); ++i) {
        EXPECT_EQ(english->map.outlines[i].points, before->outlines[i].points) << i;
        EXPECT_EQ(english->map.outlines[i].id, before->outlines[i].id) << i;
    }
    EXPECT_EQ(english->map.outlines[0].label, "Hull");
    EXPECT_EQ(english->map.outlines[2].label, "Sail") << "the second piece of its shape, too";
    EXPECT_EQ(german->map.outlines[1].label, "Segel");
    EXPECT_EQ(find_file(made.pack, "ring.svg")->bytes,
              made::bytes_of(made::small_pack()[1].contents))
        << "a picture with its own texts stays as it is";
}

TEST(PackMaking, TheSameFolderGivesTheSameBytesWhereverItLies) {
    const ScratchFolder one;
    const ScratchFolder other;
    write_folder(one);
    write_folder(other);
    const auto zip = [](const ScratchFolder& folder) {
        return zip_of(made_from(folder.path() / "The Old Quay").pack).value();
    };
    EXPECT_EQ(zip(one), zip(other));
}

TEST(PackMaking, EveryFaultIsToldAtOnceWithWhatToDo) {
    const ScratchFolder scratch;
    write_folder(scratch, "quay");
    const auto write = [&](const std::string& file, const std::string& text) {
        scratch.write("quay/" + file, text);
    };
    write("pack.txt", std::string(pack_txt) + "colour: blue\n");
    write("boat.txt", "title: A boat\nno colon\npart seil: Sail\ntitle: Again\ndifficulty: 9\n");
    write("boat.fr.txt", "title: Un bateau");
    write("fox.txt", "title: A fox");
    write("boat.keel.ogg", wav());
    write("boat.description.wav", wav());
    write("notes.doc", "?");
    write("b\xc3\xb6t.svg", boat_svg);
    write("more/boat.svg", boat_svg);
    write("broken.svg", "<svg");
    write("photo.png", "?");
    write("ring.txt", "title: \xff\xfe");
    fs::create_symlink("boat.svg", scratch.path() / "quay" / "link.svg");
    const MadePack made = made_from(scratch.path() / "quay");
    const std::vector<std::string> wanted{
        "pack.txt, line 8: “colour” is not known; write id, title, author, licence, version or "
        "languages",
        "boat.txt, line 2: there is no colon; write it as “title: A boat”",
        "boat.txt, line 3: boat.svg has no part “seil”; it has hull, sail, sail-2",
        "boat.txt, line 4: “title” is there twice",
        "boat.txt, line 5: the difficulty is none; write 1 (easy) to 5",
        "boat.fr.txt: “fr” is none of the pack's languages; add it to pack.txt, or rename the file",
        "fox.txt: no picture is called fox; rename the file",
        "boat.keel.ogg: boat.svg has no part “keel”; it has hull, sail, sail-2",
        "boat.ogg: boat.description.wav says the same; leave one of them out",
        "notes.doc: this is no picture, text or recording; leave it out",
        "more: this is a folder; lay its files beside it",
        "the picture cannot be used",
        "photo.png: nothing is traced here",
        "ring.txt: this is no UTF-8 text; save it as one",
        "link.svg: this is only a link; put the file itself there",
        "names may have a to z"};
    for (const std::string& line : wanted)
        EXPECT_TRUE(std::ranges::any_of(made.faults, [&line](const std::string& fault) {
            return fault.find(line) != std::string::npos;
        })) << line;
    std::string all;
    for (const std::string& fault : made.faults) {
        all += fault + '\n';
        EXPECT_EQ(plain_line(fault), fault);
    }
    EXPECT_EQ(made.faults.size(), wanted.size()) << all;
}

TEST(PackMaking, WithoutItsTableOrPicturesSaysSo) {
    const ScratchFolder scratch;
    EXPECT_NE(made_from(scratch.path()).faults.front().find("pack.txt: it is missing"),
              std::string::npos);
    scratch.write("pack.txt", "title: A\nlanguages: en\n");
    const MadePack bare = made_from(scratch.path());
    ASSERT_EQ(bare.faults.size(), 3U);
    EXPECT_EQ(bare.faults[0], "pack.txt: “author” is missing; add it");
    EXPECT_EQ(bare.faults[1], "pack.txt: “licence” is missing; add it");
    EXPECT_NE(bare.faults[2].find("there is no picture"), std::string::npos);
    scratch.write("boat.svg", boat_svg);
    scratch.write("pack.txt", "title: A\nlanguages: x\nauthor: B\nlicence: C\n");
    const MadePack odd = made_from(scratch.path());
    ASSERT_EQ(odd.faults.size(), 1U);
    EXPECT_EQ(odd.faults[0], "pack.txt: “x” is no language; write one like en");
    scratch.write("pack.txt", "title: A\nlanguages: en\nauthor: B\nlicence: C\nid: A b\n");
    const MadePack named = made_from(scratch.path());
    ASSERT_EQ(named.faults.size(), 1U);
    EXPECT_TRUE(named.faults[0].starts_with("pack.txt: the value of “id” cannot be used"))
        << named.faults[0];
    scratch.write("pack.toml", "");
    EXPECT_NE(made_from(scratch.path()).faults.front().find("a pack already"), std::string::npos);
    EXPECT_FALSE(made_from("/nowhere").faults.empty());
}

TEST(PackMaking, AnotherPictureIsTraced) {
    const ScratchFolder scratch;
    scratch.write("quay/pack.txt", pack_txt);
    scratch.write("quay/fish.png", "pixels");
    scratch.write("quay/fish.txt", "title: A fish\ndescription: It swims.\npart one: Fin\n");
    std::string traced;
    const MadePack made = make_pack(
        scratch.path_of("quay"), [&traced](const std::string& path) -> Result<TactileMap> {
            traced = path;
            TactileMap map;
            map.outlines.push_back({{canonical_point(10, 10, {}), canonical_point(50, 40, {})},
                                    false,
                                    "one",
                                    "",
                                    2.0,
                                    4});
            map.labels.push_back({"Sea", canonical_point(20, 20, {})});
            return map;
        });
    ASSERT_TRUE(made.faults.empty()) << made.faults.front();
    EXPECT_EQ(traced, scratch.path_of("quay/fish.png"));
    const auto look = open_picture(*find_file(made.pack, "fish.svg"), {"de"});
    ASSERT_TRUE(look.has_value());
    EXPECT_EQ(look->map.title, "A fish") << "where nobody translated it";
    ASSERT_EQ(look->map.outlines.size(), 1U);
    EXPECT_EQ(look->map.outlines[0].label, "Fin");
    EXPECT_EQ(look->map.outlines[0].weight, 2.0);
    EXPECT_EQ(look->map.outlines[0].detail, 4);
    EXPECT_EQ(look->map.labels.at(0).text, "Sea");
}

struct SaidByCommand {
    int status;
    std::string out;
    std::string err;
};

SaidByCommand command(const std::vector<std::string>& words, const Programs& programs = {}) {
    std::ostringstream out;
    std::ostringstream err;
    const int status = run_command_line(words, programs, out, err);
    return {status, out.str(), err.str()};
}

TEST(PackMakeCommand, MakesChecksAndLetsOneTry) {
    const ScratchFolder scratch;
    write_folder(scratch, "quay");
    const std::string zip = scratch.path_of("quay.zip");
    const auto said = command({"pack", "make", scratch.path_of("quay"), "-o", zip});
    EXPECT_EQ(said.status, 0) << said.out << said.err;
    EXPECT_NE(said.out.find("2 pictures, 3 recordings; touchline pack try"), std::string::npos)
        << said.out;
    EXPECT_NE(said.out.find("missing: ring.svg: the title is missing in “de”; add it\n"),
              std::string::npos)
        << said.out;
    std::string library;
    std::size_t pictures = 0;
    const Programs programs{[&](const KioskArguments& kiosk) {
                                EXPECT_TRUE(kiosk.in_window);
                                library = kiosk.tried_library;
                                std::vector<PackFinding> problems;
                                pictures = list_library(library, {"en"}, problems).size();
                                return 0;
                            },
                            {}};
    EXPECT_EQ(command({"pack", "try", zip}, programs).status, 0);
    EXPECT_EQ(pictures, 2U);
    EXPECT_FALSE(fs::exists(library)) << "nothing of it stays";
}

TEST(PackMakeCommand, WritesNothingOfAFolderWithAFault) {
    const ScratchFolder scratch;
    write_folder(scratch, "quay");
    scratch.write("quay/fox.ogg", wav());
    scratch.write("quay/boat.sail.wav", "no sound");
    const std::string zip = scratch.path_of("quay.zip");
    auto said = command({"pack", "make", scratch.path_of("quay"), "-o", zip});
    EXPECT_EQ(said.status, 1);
    EXPECT_EQ(said.out, "error: fox.ogg: no picture is called fox; rename the file\n");
    fs::remove(scratch.path() / "quay" / "fox.ogg");
    said = command({"pack", "make", scratch.path_of("quay"), "-o", zip});
    EXPECT_EQ(said.status, 1);
    EXPECT_NE(said.out.find("error: boat.sail.wav: this is no WAV, OGG or FLAC recording"),
              std::string::npos)
        << said.out;
    EXPECT_FALSE(fs::exists(zip));
    EXPECT_EQ(command({"pack", "try", scratch.path_of("quay")}, {}).status, 1);
    EXPECT_EQ(command({"pack", "make", scratch.path_of("quay")}, {}).status, 2);
}

RC_GTEST_PROP(CuratorTexts, AnyBytesAreLinesOrFaults, ()) {
    const auto text = *rc::gen::container<std::string>(
        rc::gen::elementOf(std::string("ab: \t\n\r#\xc3\xa4\xff")));
    const CuratorTexts texts = curator_texts("a.txt", std::as_bytes(std::span(text)));
    for (const CuratorLine& line : texts.lines) {
        RC_ASSERT(is_utf8(line.key) && is_utf8(line.value) && !line.value.empty());
        RC_ASSERT(plain_line(line.value) == line.value);
        RC_ASSERT(line.line >= 1);
    }
    for (const std::string& fault : texts.faults) RC_ASSERT(fault.starts_with("a.txt"));
}

RC_GTEST_PROP(SpokenMap, ReadsBackInEveryLanguage, ()) {
    const auto word = [] {
        return *rc::gen::map(
            rc::gen::container<std::string>(rc::gen::elementOf(std::string("a<&>\"'"))),
            [](const std::string& text) { return "é" + text; });
    };
    TactileMap map;
    const int count = *rc::gen::inRange(1, 5);
    for (int i = 0; i < count; ++i)
        map.outlines.push_back({{canonical_point(*rc::gen::inRange(0, 116), 3.25, {}),
                                 canonical_point(50, *rc::gen::inRange(4, 84), {})},
                                false,
                                "part" + std::to_string(i),
                                "",
                                1.5,
                                2});
    std::vector<MapWords> words;
    for (const char* const language : {"en", "de", "pt-BR"}) {
        words.push_back({language, word(), word(), {}, {}});
        for (int i = 0; i < count; ++i) words.back().parts.push_back(word());
    }
    const std::string svg = spoken_map_svg(map, words);
    for (const MapWords& each : words) {
        const auto read = parse_map_svg(svg, {each.language});
        RC_ASSERT(read.has_value());
        RC_ASSERT(read->title == each.title && read->description == each.description);
        RC_ASSERT(read->outlines.size() == map.outlines.size());
        for (std::size_t i = 0; i < map.outlines.size(); ++i) {
            RC_ASSERT(read->outlines[i].points == map.outlines[i].points);
            RC_ASSERT(read->outlines[i].id == map.outlines[i].id);
            RC_ASSERT(read->outlines[i].label == each.parts[i]);
        }
    }
}

TEST(CuratorFolder, TheLongestNameOfAPictureCounts) {
    const std::set<std::string> pictures{"boat", "boat.old", "b"};
    const std::vector<std::string> languages{"en", "de"};
    const auto of = [&](const std::string& name) {
        const BesidePicture beside = beside_picture(name, pictures, languages);
        return beside.picture + '|' + beside.language + '|' + beside.part;
    };
    EXPECT_EQ(of("boat.ogg"), "boat||");
    EXPECT_EQ(of("boat.old.ogg"), "boat.old||");
    EXPECT_EQ(of("boat.old.de.sail.ogg"), "boat.old|de|sail");
    EXPECT_EQ(of("boat.de.ogg"), "boat|de|");
    EXPECT_EQ(of("boat.fr.sail.ogg"), "boat||fr.sail");
    EXPECT_EQ(of("boats.ogg"), "||");
}

}  // namespace
}  // namespace touchline
