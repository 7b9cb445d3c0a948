// Tests what teachers are told, as touchline pack says it.
#include "app/cli/options.h"
#include "app/documents/decode/files.h"
#include "app/documents/packs/pack.h"
#include "app/documents/packs/unpacking.h"
#include "audio-cues/words/language.h"
#include "tests/app/documents/packs/made_packs.h"
#include "tests/config/scratch_folder.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

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

bool has(const std::vector<PackFinding>& findings, FindingKind kind, const std::string& what = "") {
    return std::any_of(findings.begin(), findings.end(), [&](const PackFinding& finding) {
        return finding.kind == kind && finding.what.find(what) != std::string::npos;
    });
}

/// Checks the small pack with another picture.
std::vector<PackFinding> findings_of(const std::string& svg) {
    auto members = made::small_pack();
    members[1].contents = svg;
    const auto pack = read_pack(made::zip(members));
    EXPECT_TRUE(pack.has_value());
    return pack ? check_pack(*pack) : std::vector<PackFinding>{pack.error()};
}

std::string svg(const std::string& inside, const std::string& attributes = "") {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"116mm\" height=\"84mm\" "
           "viewBox=\"0 0 116 84\" " +
           attributes + ">\n" + inside + "\n</svg>";
}

TEST(Check, TheExampleHasNothingToBeTold) {
    const Said said = say({"pack", "check", made::example_pack()});
    EXPECT_EQ(said.status, 0) << said.out << said.err;
    EXPECT_EQ(said.out, made::example_pack() + ": can be used\n");
}

TEST(Check, WhatIsMissingIsTold) {
    const auto findings = findings_of(svg("<path id=\"a\" d=\"M20 20 L60 60\"/>"));
    EXPECT_TRUE(can_be_used(findings));
    EXPECT_TRUE(has(findings, FindingKind::no_title));
    EXPECT_TRUE(has(findings, FindingKind::no_description));
    EXPECT_TRUE(has(findings, FindingKind::no_part_name, "a"));
    EXPECT_TRUE(has(findings, FindingKind::no_difficulty));
    const auto part = std::find_if(findings.begin(), findings.end(), [](const auto& finding) {
        return finding.kind == FindingKind::no_part_name;
    });
    EXPECT_EQ(part->line, 2);
    EXPECT_EQ(part->file, "a.svg");
}

TEST(Check, LanguagesThatAreMissingAreTold) {
    const PackFile picture{
        "a.svg", made::bytes_of(svg("<title>T</title><desc>D</desc><desc xml:lang=\"de\">D</desc>"
                                    "<path id=\"fin\" d=\"M20 20 L60 60\"><title>Fin</title>"
                                    "</path>"))};
    const auto look = open_picture(picture, {"en", "de"});
    ASSERT_TRUE(look.has_value());
    EXPECT_TRUE(has(look->findings, FindingKind::title_language, "de"));
    EXPECT_FALSE(has(look->findings, FindingKind::description_language));
    EXPECT_TRUE(has(look->findings, FindingKind::part_language, "fin"));
    EXPECT_FALSE(has(look->findings, FindingKind::title_language, "en"));
}

TEST(Check, WhatAHandCannotTellIsTold) {
    const auto near =
        findings_of(svg("<path id=\"a\" d=\"M20 20 L80 20\"/>"
                        "<path id=\"b\" d=\"M20 21.5 L80 21.5\"/>"
                        "<path id=\"rim\" d=\"M1 50 L20 50\"/>",
                        "data-difficulty=\"1\""));
    EXPECT_TRUE(has(near, FindingKind::lines_near, "“a”, “b”"));
    EXPECT_TRUE(has(near, FindingKind::near_rim, "rim"));
    EXPECT_TRUE(has(near, FindingKind::many_parts, "1"));
    std::string much;
    for (int y = 4; y < 80; y += 4)
        for (const char* x : {"M4 ", "M4.1 "})
            much += std::string("<path d=\"") + x + std::to_string(y) + " L112 " +
                    std::to_string(y) + "\"/>";
    EXPECT_TRUE(has(findings_of(svg(much)), FindingKind::much_line));
    EXPECT_TRUE(has(findings_of("<svg viewBox=\"0 0 50 50\"><path d=\"M9 9 L30 30\"/></svg>"),
                    FindingKind::other_size));
}

TEST(Check, APictureThatIsNoneIsRefusedWithItsLine) {
    const auto findings = findings_of("<svg>\n<path\n<</svg>");
    ASSERT_FALSE(can_be_used(findings));
    EXPECT_EQ(findings.front().kind, FindingKind::picture_broken);
    EXPECT_GE(findings.front().line, 2);
    EXPECT_FALSE(can_be_used(findings_of(svg(""))));
    EXPECT_FALSE(can_be_used(findings_of(svg("<path d=\"M0 0 Lnan 3\"/>"))));
}

TEST(Check, ALayeredPictureIsTaken) {
    const auto findings = findings_of(
        "<svg viewBox=\"0 0 1160 840\" width=\"1160\" height=\"840\"><title>T</title>"
        "<g data-image-layer=\"one\" aria-label=\"Shapes\" aria-description=\"Both\">"
        "<circle aria-label=\"Ring\" cx=\"580\" cy=\"420\" r=\"200\"/></g></svg>");
    EXPECT_TRUE(can_be_used(findings));
    EXPECT_FALSE(has(findings, FindingKind::no_part_name));
    EXPECT_FALSE(has(findings, FindingKind::no_description));
    EXPECT_FALSE(has(findings, FindingKind::other_size));
}

TEST(Command, SaysWhatIsWrongInOneLineAndAStatus) {
    EXPECT_EQ(say({"pack", "check", "/nowhere"}).status, 1);
    EXPECT_EQ(say({"pack", "check"}).status, 2);
    EXPECT_EQ(say({"pack", "export", made::example_pack(), "-o", "/x", "--image", "?"}).status, 2);
    const ScratchFolder folder;
    folder.write("fish.svg", "<svg/>");
    const Said said = say({"pack", "check", folder.path()});
    EXPECT_EQ(said.status, 1);
    EXPECT_NE(said.out.find("error: "), std::string::npos);
    EXPECT_NE(said.out.find("there is no pack.toml"), std::string::npos) << said.out;
    EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1);
}

/// The guide shows what the command really says.
TEST(Command, SaysWhatTheGuideShows) {
    auto pack = read_pack(made::example_pack());
    ASSERT_TRUE(pack.has_value());
    const ScratchFolder folder;
    for (const PackFile& file : pack->files) {
        std::string text = made::text_of(file.bytes);
        if (file.name == "boat.svg") {
            const std::string sail = "      <title xml:lang=\"de\">Segel</title>\n";
            ASSERT_NE(text.find(sail), std::string::npos);
            text.erase(text.find(sail), sail.size());
            text.insert(text.find("  </g>"),
                        "<path id=\"mast\" d=\"M54.5 10 L54.5 58\"><title>Mast</title>"
                        "<title xml:lang=\"de\">Mast</title></path>\n");
        }
        folder.write("pack/" + file.name, text);
    }
    const Said said = say({"pack", "check", folder.path_of("pack")});
    EXPECT_EQ(said.status, 0) << said.err;
    const auto guide = read_file(TOUCHLINE_SOURCE_DIR "/app/documents/packs/README.md");
    ASSERT_TRUE(guide.has_value());
    std::istringstream lines(said.out);
    for (std::string line; std::getline(lines, line);) {
        if (line.ends_with("better one")) continue;
        EXPECT_NE(made::text_of(*guide).find(line), std::string::npos) << line;
    }
    EXPECT_NE(said.out.find(": can be used; 2 hints for a better one\n"), std::string::npos)
        << said.out;
}

TEST(Command, ExportsAndImports) {
    const ScratchFolder folder;
    const std::string zip = folder.path_of("pack.zip");
    const std::string library = folder.path_of("library");
    ASSERT_EQ(say({"pack", "export", made::example_pack(), "-o", zip}).status, 0);
    EXPECT_EQ(say({"pack", "check", zip}).status, 0);
    const Said said = say({"pack", "import", zip, "--library", library});
    EXPECT_EQ(said.status, 0) << said.err;
    EXPECT_NE(said.out.find("shapes-and-a-boat 1.0.0: installed"), std::string::npos);
    EXPECT_EQ(read_pack(library + "/shapes-and-a-boat")->files,
              read_pack(made::example_pack())->files);
    const std::string layers = folder.path_of("layers.zip");
    ASSERT_EQ(say({"pack", "export", made::example_pack(), "-o", layers, "--image", "de"}).status,
              0);
    const auto layered = read_pack(layers);
    ASSERT_TRUE(layered.has_value());
    const auto boat = made::text_of(find_file(*layered, "boat.svg")->bytes);
    EXPECT_NE(boat.find("aria-label=\"Segel\""), std::string::npos);
    EXPECT_NE(boat.find("data-image-layer=\"detail-2\""), std::string::npos);
}

TEST(Folder, WithALinkOrATwinIsRefused) {
    const ScratchFolder folder;
    for (const auto& member : made::small_pack()) folder.write(member.name, member.contents);
    ASSERT_TRUE(read_pack(folder.path()).has_value());
    std::filesystem::create_symlink("/etc/passwd", folder.path_of("b.txt"));
    EXPECT_EQ(read_pack(folder.path()).error().kind, FindingKind::link);
    std::filesystem::remove(folder.path_of("b.txt"));
    folder.write("A.svg", "x");
    EXPECT_EQ(read_pack(folder.path()).error().kind, FindingKind::twice);
}

}  // namespace
}  // namespace touchline
