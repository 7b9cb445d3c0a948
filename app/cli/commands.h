// The commands that need no display: what each is asked for, and what it does. A result file
// appears whole or not at all; a failure is one line. Threads: one.
#pragma once

#include "app/cli/load.h"
#include "app/sheets/braille_lines.h"
#include "app/sheets/tactile_sheet.h"
#include "config/types/result.h"
#include "haptics/contact/proxy_state.h"
#include "haptics/curve/curve_set.h"
#include "vision/simplify/trace.h"

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

// touchline trace: writes the outlines of a picture as a map.

struct TraceCommandOptions {
    std::string input;   // a picture, whatever its name
    std::string output;  // MAP.svg
    std::string report;  // REPORT.json; empty: none
    std::string edges;   // STRENGTH.png; empty: none
    std::string figure;  // MASK.png; empty: none
    ViewChoice view;     // of the first page
    TraceOptions trace;
};

/// Writes the map and the other requested files, each whole or not at all. Returns one sentence
/// worth telling the user (outlines cut to the budget), else an empty text.
[[nodiscard]] Result<std::string> run_trace(const TraceCommandOptions& options);

// touchline print: writes a sheet to take home, for swell paper or an embosser.

struct PrintCommandOptions {
    std::string input;   // a picture, whatever its name
    std::string output;  // its ending chooses the format
    ViewChoice view;     // of the first page
    TraceOptions trace;
    PaperKind paper = PaperKind::a4;
    std::string language = "en";  // of a catalogue
    BrailleGrade grade = BrailleGrade::uncontracted;
};

/// pdf: all pages. svg: the drawing alone. brf: words, and the lines in dots of text. ubrl: the
/// lines in an embosser's graphic mode, for CUPS. index: words and lines for an Index embosser.
enum class SheetFormat : std::uint8_t { pdf, svg, brf, ubrl, index };

/// The ending of a name tells it; nothing for any other.
[[nodiscard]] std::optional<SheetFormat> sheet_format_of(const std::string& path);

/// Traces the picture as `trace` does, and writes the sheet whole or not at all. Returns one
/// sentence worth telling the user, else an empty text.
[[nodiscard]] Result<std::string> run_print(const PrintCommandOptions& options);

// touchline curve: writes the multiresolution curve of a picture or map at one level, as a map.

struct CurveCommandOptions {
    std::string input;  // picture or map
    bool as_picture = false;
    std::string output;  // OUT.svg
    std::string report;  // REPORT.json; empty: none
    double level = 0.0;
    bool with_boxes = false;
    CurveOptions curves;
};

/// Writes the exact polylines that `feel --level` uses, one path per piece, and the report. Files
/// appear whole or not at all.
[[nodiscard]] Result<void> run_curve(const CurveCommandOptions& options);

// touchline feel: a recorded or computed hand moves over a map, one servo step per row. With
// --probe, a held shape moves and turns.

struct FeelOptions {
    std::string input;  // picture or map
    bool as_picture = false;
    std::string path;    // HAND.csv
    std::string output;  // RUN.csv
    std::string probe;   // a map of the held shape; empty: a point
    ContactSettings contact;
    CurveOptions curves;
    std::optional<double> level;  // none: auto
    std::string profile = "2diy-gen3.1";
    std::optional<int> budget_boxes;
    std::optional<double> deadline_us;
    bool with_timing = false;
};

/// Writes RUN.csv whole or not at all.
[[nodiscard]] Result<void> run_feel(const FeelOptions& options);

// touchline feel --replay: runs a recording of the kiosk's black box again.

struct ReplayOptions {
    std::string recording;
    std::string output;  // RUN.csv
};

/// Writes RUN.csv whole or not at all: the ticks of this run or, if a visitor's picture was felt,
/// the recorded ones. One sentence says which. Fails, after writing the table, if the run differs
/// from the recording in any bit.
[[nodiscard]] Result<std::string> run_replay(const ReplayOptions& options);

// touchline settings: checks a settings file, and prints the resulting settings.

/// check: one line says that the file can be used, and how many settings it sets. print: all
/// settings as TOML.
enum class SettingsAction : std::uint8_t { check, print };

struct SettingsCommandOptions {
    SettingsAction action = SettingsAction::check;
    std::string file;  // empty: the site's, which may be missing
};

/// Returns a line for every fault of the file (settings_text.h), including an unknown language and
/// an unreadable file. Empty: done. Writes nothing else to `out`.
[[nodiscard]] std::vector<std::string> run_settings(const SettingsCommandOptions& options,
                                                    std::ostream& out);

// touchline pack: picture packs, for people who make and install them.

/// check: every finding about a pack, one sentence per line. import: installs it into the library.
/// export: writes a folder as a zip file. make: the same for a curator's folder of pictures, texts
/// and recordings. attempt: installs it into a library that only this run has, for a kiosk in a
/// window.
enum class PackAction : std::uint8_t { check, import, write, make, attempt };

struct PackCommandOptions {
    PackAction action = PackAction::check;
    std::string input;
    std::string output;   // for export and make
    std::string library;  // for import and attempt; empty: the user's
    std::string
        image_language;  // for export: as layered pictures of the IMAGE project; empty: unchanged
    bool takes_older = false;  // for import: also over a newer version
};

/// Fails with one sentence if the pack cannot be used.
[[nodiscard]] Result<void> run_pack(const PackCommandOptions& options, std::ostream& out);

// touchline models: the networks that Touchline can use, their licences, and how to get them.

/// list: what is known of each, and whether it is here. check: whether those that are here, or
/// ship, are whole. get: downloads one of the others from its publisher, after showing its licence
/// and getting the user's agreement.
enum class ModelsAction : std::uint8_t { list, check, get };

struct ModelsCommandOptions {
    ModelsAction action = ModelsAction::list;
    std::string name;        // for get
    bool is_agreed = false;  // get does not ask
};

/// `in`: where the answer "yes" is read from. Fails with one line: a damaged network, an unknown
/// name, an answer other than yes, or a failed download.
[[nodiscard]] Result<void> run_models(const ModelsCommandOptions& options, std::istream& in,
                                      std::ostream& out);

// touchline bundle: what several kiosks of one house have alike, signed by the house.

/// key: makes the key of this house and tells its fingerprint; or takes the key of another kiosk,
/// if the fingerprint is the one that was typed. make: writes a bundle of this kiosk. check: tells
/// what a bundle would change. apply: changes it, all or nothing. undo: goes back to before it.
enum class BundleAction : std::uint8_t { key, make, check, apply, undo };

struct BundleCommandOptions {
    BundleAction action = BundleAction::check;
    std::string input;        // the bundle; for key: the file of a key, or empty
    std::string output;       // for make; for key: where the key goes, or empty
    std::string fingerprint;  // for key
    bool is_agreed = false;   // for undo: go back, not only tell
};

/// Fails with one line, and then nothing was changed.
[[nodiscard]] Result<void> run_bundle(const BundleCommandOptions& options, std::ostream& out);

// touchline counters: the days of several kiosks as one table.

struct CountersCommandOptions {
    std::vector<std::string> inputs;  // tables of kiosks
    std::string output;               // ALL.csv
};

/// Writes the table whole or not at all.
[[nodiscard]] Result<void> run_counters(const CountersCommandOptions& options);

}  // namespace touchline
