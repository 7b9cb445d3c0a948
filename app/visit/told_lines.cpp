#include "app/visit/told_lines.h"

#include "haptics/safety/force_chain.h"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace touchline {
namespace {

constexpr std::string_view part_missing = "A part of this kiosk is missing. Please call the staff.";
constexpr std::string_view staffs_part_missing =
    "A part of this kiosk is missing. Install Touchline again.";
constexpr std::string_view too_much_memory =
    "The picture needs too much memory. Save it smaller and bring it again.";
constexpr std::string_view too_large = "The file is too large. Save it smaller and bring it again.";
constexpr std::string_view damaged = "The file is damaged. Copy it again, or choose another one.";
constexpr std::string_view not_safe = "The file cannot be opened safely. Choose another one.";
constexpr std::string_view lines_not_safe =
    "The lines cannot be found safely. Choose another picture.";
constexpr std::string_view no_such_page = "This page cannot be opened. Choose another one.";
constexpr std::string_view no_line_in_part =
    "There is no line in this part. Choose another part, or the whole picture.";
constexpr std::string_view unfit_kind = "This kind of picture cannot be felt. Choose another one.";
constexpr std::string_view unfit_tiff = "This kind of TIFF cannot be felt. Save it as a PNG.";
constexpr std::string_view damaged_svg =
    "The SVG file is damaged. Save it again, or choose another one.";
constexpr std::string_view damaged_map =
    "The lines of this picture are damaged. Choose another one.";
constexpr std::string_view too_rich =
    "The picture holds more than can be felt. Choose a simpler one.";
constexpr std::string_view pulled_out = "The USB stick was pulled out. Put it in again.";
constexpr std::string_view unreadable_file =
    "The file cannot be read. Choose another one, or call the staff.";
constexpr std::string_view staffs_unreadable_file =
    "The file cannot be read. Copy it to the USB stick again.";

/// The sentences of the camera and the sticks are catalogue texts already. No other line is trusted
/// as one, for it may come from a worker that a file has taken over.
constexpr std::array<std::string_view, 11> whole_sentences{
    "It is too dark here. Ask the staff for more light.",
    "There is too much light. Ask the staff to turn the lamp away.",
    "The lamp is reflected in the sheet. Ask the staff to move it.",
    "The sheet is too far away. Bring it closer.",
    "The sheet is too close. Move it away from the camera.",
    "Move the sheet to the right.",
    "Move the sheet to the left.",
    "Move the sheet down, towards you.",
    "Move the sheet up, away from you.",
    "The USB stick is locked with a password. Bring one without.",
    "The USB stick’s format is not read here. Bring one formatted as FAT or exFAT."};

constexpr auto rows_of_files = std::to_array<LineRow>({
    // Documents and pictures, by their readers.
    {"locked with a password", "The PDF is locked with a password. Save it without one."},
    {"is an office document", "Office files cannot be felt. Please bring the file as a PDF."},
    {"is an archive of other files",
     "This file holds others, packed together. Unpack them on your computer first."},
    {"is no picture that is known here",
     "This file is not a picture that can be felt. Use a PNG, JPEG or PDF file."},
    {"nothing is painted", "Nothing is drawn in this picture. Choose another one."},
    {"it has no page", "The PDF has no page. Choose another file."},
    {"is cut short or damaged", damaged},
    {"the file is empty", "The file is empty. Copy it again, or choose another one."},
    {"the map is empty", "The file is empty. Copy it again, or choose another one."},
    {"more than * megapixels", "The picture is too large. Save it smaller and bring it again."},
    {"is larger than * MiB", too_large},
    {"too large when unpacked", too_large},
    {"in one piece that is too large", unfit_tiff},
    {"is of a kind that cannot be shown", unfit_tiff},
    {"needs too much memory", too_much_memory},
    {"not enough memory", too_much_memory},
    {"the WebP picture moves", "This picture moves. Save one frame of it as a PNG."},
    {"repeats its parts too often", "This SVG repeats its parts too often. Save it as a PNG."},
    {"cannot be drawn (", "The file cannot be drawn. Save it as a PNG."},
    {"is no SVG", damaged_svg},
    {"but no SVG", damaged_svg},
    {"is no XML", damaged_svg},
    {"write viewBox", "The SVG does not say its size. Save it as a PNG."},
    {"choose one of them", no_such_page},
    {"one page only", no_such_page},
    {"this page could not be opened", no_such_page},
    // Maps.
    {"the map cannot be handed over", too_rich},
    {"the map holds no outline", "There is no line in this picture. Choose another one."},
    {"the map", damaged_map},
    {"the curves would have", too_rich},
    // Workers.
    {"takes too long to open", "The file takes too long to open. Save it smaller or simpler."},
    {"finding its outlines takes too long",
     "Finding the lines takes too long. Choose a simpler picture."},
    {"cannot be started safely here", part_missing, staffs_part_missing},
    {"a part of Touchline is missing", part_missing, staffs_part_missing},
    {"is of another version", part_missing, staffs_part_missing},
    {"damaged or harmful", not_safe},
    {"could not be opened safely", not_safe},
    {"could not be found safely", lines_not_safe},
    {"found before are damaged", lines_not_safe},
    {"parts do not fit together", lines_not_safe},
    {"to find lines in", lines_not_safe},
    {"no such step", lines_not_safe},
    // Lines.
    {"none in this part", no_line_in_part},
    {"no line in this part", no_line_in_part},
    {"no outline is shown at detail", "There is no line at this detail. Choose more detail."},
    {"the picture is only", "The picture is too small to be felt. Bring a larger one."},
    {"flat to be felt", "The picture is too flat to be felt. Bring a higher one."},
    {"narrow to be felt", "The picture is too narrow to be felt. Bring a wider one."},
    {"too small for a finger",
     "All in the picture is too small for a finger. Choose a closer picture."},
    {"stands out from its background",
     "Nothing in the picture stands out. Choose one with more contrast."},
    {"the picture has no pixels", damaged},
    {"was not foreseen", unfit_kind},
    {"neither 8-bit colour", unfit_kind},
    {"the middle of the zoom is no place", no_line_in_part},
    {"stands out from its grain",
     "Nothing in the picture stands out clearly. Only the strongest lines are kept."},
    {"more than can be felt; only", crowded_picture},
    // The camera.
    {"the camera's picture cannot be used", "The photo cannot be used. Take another one."},
    {"the camera's frame is damaged", "The photo cannot be used. Take another one."},
    // Sticks and their files.
    {"was pulled out or is damaged",
     "The USB stick was pulled out or is damaged. Put it in again, or try another one."},
    {"was pulled out", pulled_out},
    {"no longer on the stick", "The file is no longer on the USB stick. Choose another one."},
    {"only a link or a device", "This is only a link. Choose the picture itself."},
    {"is too large; save it smaller", too_large},
    {"is empty; copy it to the stick", "The file is empty. Copy it again, or choose another one."},
    {"is locked for the user who saved it",
     "Only the person who saved this may open it. Copy it to another USB stick."},
    {"takes too long to read",
     "Reading takes too long. Put the USB stick in again, or try another one."},
    {"cannot be read; put it in again", stick_trouble},
    {"list of the stick's files cannot be understood", stick_trouble},
    // What should not happen.
    {"there is no memory to share", too_much_memory},
    {"shared memory cannot be mapped", too_much_memory},
    {"memory cannot be sealed", too_much_memory},
    {"no sealed memory", unreadable_file, staffs_unreadable_file},
    {"no shared memory of a fixed size", unreadable_file, staffs_unreadable_file},
    {"cannot be opened", unreadable_file, staffs_unreadable_file},
    {"cannot be read", unreadable_file, staffs_unreadable_file},
});

struct PrintWords {
    std::string_view told;
    std::string_view staff_told;
};

constexpr std::string_view no_printer = "The printer cannot be used now. Please call the staff.";

constexpr std::string_view printed_is_kept =
    "CUPS keeps printed sheets. The manual says how to remove them.";

// In the order of PrintEnd.
constexpr std::array<PrintWords, print_end_count> print_ends{{
    {},
    {"The printer has no paper. Please call the staff.", "The printer has no paper. Put some in."},
    {"The printer needs care. Please call the staff.",
     "The printer is jammed, open or without ink. Put that right."},
    {"The printer is switched off. Please call the staff.",
     "The printer does not answer. Switch it on and check its cable."},
    {no_printer, "The printer is paused. Start it again in CUPS."},
    {no_printer, "The printer takes no sheets. The manual says how to change that."},
    {no_printer, "CUPS has no printer of this name. Check the name in the settings."},
    {no_printer, "CUPS cannot be reached. Start its service."},
    {no_printer, "CUPS does not answer. Start its service again."},
    {"The sheet was not printed. Try again, or call the staff.",
     "The sheet was not printed. The log of CUPS says why."},
    {"Printing took too long. Please call the staff.",
     "Printing took too long. Check the printer."},
    {no_printer, printed_is_kept},
    {no_printer, printed_is_kept},
    {"This picture cannot be printed. Choose another one.",
     "This picture cannot be printed. Choose another one."},
    {part_missing, staffs_part_missing},
}};

/// True if the line holds all texts between the stars, in their order.
bool holds(std::string_view line, std::string_view part) {
    for (;;) {
        const std::size_t star = part.find('*');
        const std::string_view wanted = part.substr(0, star);
        const std::size_t at = line.find(wanted);
        if (at == std::string_view::npos) return false;
        if (star == std::string_view::npos) return true;
        line.remove_prefix(at + wanted.size());
        part.remove_prefix(star + 1);
    }
}

std::string told_by(std::span<const LineRow> rows, const std::string& line,
                    std::string_view general, const Language& language, ToldTo to) {
    const auto row =
        std::ranges::find_if(rows, [&line](const LineRow& each) { return holds(line, each.part); });
    if (row == rows.end()) return language.text("trouble", std::string(general));
    const bool is_other = to == ToldTo::staff && !row->staff_told.empty();
    return language.text("trouble", std::string(is_other ? row->staff_told : row->told));
}

/// "It is 12 millimetres off." is the text "It is {0} millimetres off." with 12. Empty if the
/// catalogue has neither form of the sentence.
std::string told_sentence(const std::string& sentence, const Language& language) {
    constexpr const char* digits = "0123456789";
    const std::string whole = language.text("device", sentence);
    const std::size_t first = sentence.find_first_of(digits);
    if (whole != sentence || first == std::string::npos) return whole == sentence ? "" : whole;
    const std::string number =
        sentence.substr(first, sentence.find_first_not_of(digits, first) - first);
    std::string pattern = sentence;
    pattern.replace(first, number.size(), "{0}");
    const std::string filled = language.text("device", pattern, {number});
    return filled == sentence ? "" : filled;
}

constexpr std::string_view call_the_staff = "Please call the staff.";
constexpr std::string_view hold_still = "Hold it still. The force comes back by itself.";
constexpr std::string_view hold_firmly = "Hold it firmly and choose softer lines.";

// In the order of Fault.
constexpr std::array<FaultWords, fault_count> faults{{
    {},
    {"The handle does not answer.", call_the_staff,
     "Check its cable. The voice then tells you where to move the handle."},
    {"The handle moved too fast.", hold_still, hold_still},
    {"The handle pushed harder than it should.", "Hold the handle. Please call the staff.",
     "Hold the handle."},
    {"The handle kept shaking.", "Hold it firmly and choose softer lines. Please call the staff.",
     hold_firmly},
    {"Nobody seems to hold the handle. Its ball may have come off.", call_the_staff,
     "Put the ball on and hold it."},
    {"The handle’s position jumped.", call_the_staff,
     "Check the arms of the device and its cable."},
    {"The device or the program reported an impossible number.", call_the_staff,
     "Copy the log for whoever maintains the kiosk."},
    {"The emergency stop was pressed.", call_the_staff, "Make sure that all is safe."},
}};

std::string told(std::initializer_list<std::string_view> sentences, const Language& language) {
    std::string text;
    for (const std::string_view sentence : sentences) {
        if (!text.empty()) text += ' ';
        text += language.text("fault", std::string(sentence));
    }
    return text;
}

}  // namespace

std::span<const LineRow> file_lines() {
    return rows_of_files;
}

std::string told_of_file(const std::string& line, std::string_view general,
                         const Language& language, ToldTo to) {
    if (line.empty()) return {};
    if (std::ranges::find(whole_sentences, line) != whole_sentences.end())
        return language.text("trouble", line);
    return told_by(rows_of_files, line, general, language, to);
}

std::string told_of_device(const std::string& line, const Language& language, ToldTo to) {
    if (line.empty()) return {};
    const std::string_view general = to == ToldTo::staff ? staffs_device_trouble : device_trouble;
    if (!line.ends_with('.')) return told_by(device_lines(), line, general, language, to);
    if (language.code() == "en") return line;
    std::string said;
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t stop = std::min(line.find(". ", at), line.size() - 1);
        const std::string words = told_sentence(line.substr(at, stop + 1 - at), language);
        if (!words.empty()) said += (said.empty() ? "" : " ") + words;
        at = stop + 2;
    }
    return said.empty() ? language.text("trouble", std::string(general)) : said;
}

std::string told_of_print(PrintEnd end, const Language& language, ToldTo to) {
    const PrintWords& words = print_ends[static_cast<std::size_t>(end)];
    return language.text("trouble",
                         std::string(to == ToldTo::staff ? words.staff_told : words.told));
}

FaultWords words_of(Fault fault) {
    return faults[static_cast<std::size_t>(fault)];
}

std::string spoken_fault(Fault fault, const Language& language) {
    if (fault == Fault::none) return {};
    const FaultWords words = words_of(fault);
    return told({"The force is off.", words.why, words.visitor_does}, language);
}

std::string staffs_fault(Fault fault, const Language& language) {
    if (fault == Fault::none) return {};
    const FaultWords words = words_of(fault);
    const std::string text = told({"The force is off.", words.why, words.staff_does}, language);
    const FaultRule& rule = fault_rules()[static_cast<std::size_t>(fault) - 1];
    if (rule.clears == FaultClears::when_gone) return text;
    return text + ' ' +
           language.text("fault", "Then choose: {0}.",
                         {language.text("operator", "Reset the force fault")});
}

}  // namespace touchline
