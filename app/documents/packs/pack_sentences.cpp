#include "app/documents/decode/one_line.h"
#include "app/documents/packs/pack.h"
#include "audio-cues/words/language.h"
#include "config/types/utf8.h"

#include <array>

namespace touchline {
namespace {

struct Row {
    int decimals;  // of the number {1}
    const char* english;
    const char* one = nullptr;  // the sentence if {1} is 1
};

/// In the order of FindingKind. {0} is what the sentence names, {1} a number.
constexpr std::array<Row, finding_kind_count> rows{{
    {0, "this is not there; check its name"},
    {0, "this cannot be read; copy it again"},
    {0, "this is empty; copy it again"},
    {0, "this is no zip file; pack the folder as a zip file"},
    {0, "the zip file is damaged; pack the folder again"},
    {0, "this is damaged or harmful; take another one"},
    {0, "this takes too long to open; make it smaller"},
    {0, "this needs too much memory; make it smaller"},
    {0, "packs cannot be opened safely here; have Touchline installed anew"},
    {0, "the pack is larger than {1} megabytes; make two packs of it"},
    {0, "the pack holds more than {1} files; make two packs of it"},
    {0, "this is larger than {1} megabytes; save it smaller",
     "this is larger than one megabyte; save it smaller"},
    {0, "unpacked, the pack exceeds {1} megabytes; make two packs of it"},
    {0, "the name leads out of the pack; rename the file"},
    {0, "names may have a to z, digits, space, dot, hyphen, underscore; rename the file"},
    {0, "the name is longer than {1} letters; shorten it"},
    {0, "this lies in more than {1} folders; move it up"},
    {0, "this name is there twice; rename one of the files"},
    {0, "this is only a link; put the file itself there"},
    {0, "this is no file but a device; leave it out"},
    {0, "this is locked by a password; pack it without one"},
    {0, "this is a packed file itself; unpack it into the folder"},
    {0, "packs hold SVG, WAV, OGG, FLAC and TXT files only; leave this out"},
    {0, "there is no pack.toml; write one as the guide shows"},
    {0, "this line is not understood; compare it with the guide"},
    {0, "“{0}” is not known here; correct or remove it"},
    {0, "“{0}” is missing; add it"},
    {0, "the value of “{0}” cannot be used; compare it with the guide"},
    {0, "more than {1} of “{0}” are listed; make two packs of it"},
    {0, "“{0}” is not in the pack; add it or correct its name"},
    {0, "the picture cannot be used: {0}"},
    {0, "this is no WAV, OGG or FLAC recording; save it as one"},
    {0, "the recording is damaged; make it again, or copy it again"},
    {0, "the recording is longer than {1} seconds; make it shorter"},
    {0, "the recording has an unusual rate or many channels; save it in mono"},
    {0, "version {0} is installed, which is newer; confirm to replace it"},
    {0, "the library cannot be written; check its disk and its rights"},
    {0, "the file cannot be written; check its disk and its rights"},
    {0, "the picture has no part “{0}”; correct it in pack.toml"},
    {0, "the picture has no title; add one"},
    {0, "the picture has no description; add one"},
    {0, "the part “{0}” has no name; give it a title"},
    {0, "the title is missing in “{0}”; add it"},
    {0, "the description is missing in “{0}”; add it"},
    {0, "the name of {0} is missing; add it"},
    {1, "there are only {1} millimetres between {0}; a hand needs 3 or more"},
    {0, "{1} parts are many for difficulty {0}; leave some out or grade it higher"},
    {0, "the lines are {1} millimetres long, much for a hand; leave details out"},
    {0, "the part “{0}” lies less than 3 millimetres from the edge; move it inwards"},
    {0, "the picture has no difficulty; grade it from 1 to 5"},
    {0, "the picture is not 116 by 84 millimetres; the kiosk’s area is"},
    {0, "two parts are called “{0}”; tell them apart"},
    {0, "pack.toml does not name this file; list it or leave it out"},
    {0, "the recording is very quiet; make it again, nearer or louder"},
}};

/// "fish.svg, line 12: "
std::string place_of(const PackFinding& finding, const Language& language) {
    if (finding.file.empty()) return "";
    const std::string file = one_spaced(utf8_of(finding.file), 120);
    if (finding.line <= 0) return file + ": ";
    return language.text("pack", "{0}, line {1}", {file, std::to_string(finding.line)}) + ": ";
}

}  // namespace

std::string sentence_of(const PackFinding& finding, const Language& language) {
    const Row& row = rows[static_cast<std::size_t>(finding.kind)];
    const std::string what = one_spaced(utf8_of(finding.what), 200);
    const char* const english = row.one != nullptr && finding.value == 1.0 ? row.one : row.english;
    return place_of(finding, language) +
           language.text("pack", english, {what, language.number(finding.value, row.decimals)});
}

}  // namespace touchline
