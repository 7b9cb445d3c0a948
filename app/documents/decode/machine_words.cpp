#include "app/documents/decode/readers.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace touchline::decode {
namespace {

using Words = std::span<const std::string_view>;

// All in lower case. No list holds a word by itself that people use for what a picture shows: each
// kind below needs more than one sign of a machine.

constexpr auto makers = std::to_array<std::string_view>(
    {"olympus", "sony",  "minolta",  "konica",   "samsung",  "kodak",   "medion",   "canon",
     "nikon",   "casio", "pentax",   "fujifilm", "ricoh",    "sanyo",   "jenoptik", "panasonic",
     "vivitar", "benq",  "gedsc",    "aiptek",   "polaroid", "hewlett", "packard",  "praktica",
     "rollei",  "agfa",  "traveler", "sigma",    "motorola", "huawei"});

constexpr auto words_of_makers = std::to_array<std::string_view>(
    {"digital",   "camera",      "cameras", "still",       "dsc",   "pictures", "imaging",
     "powershot", "coolpix",     "exilim",  "photosmart",  "optio", "finepix",  "lumix",
     "eos",       "ixus",        "corp",    "corporation", "co",    "ltd",      "inc",
     "company",   "electronics", "pen",     "cybershot"});

constexpr auto programs = std::to_array<std::string_view>(
    {"adobe",      "illustrator", "photoshop",  "indesign",    "acrobat",        "inkscape",
     "sketch",     "figma",       "gimp",       "vsco",        "potrace",        "autocad",
     "matplotlib", "canva",       "svgo",       "boxy",        "gnuplot",        "graphviz",
     "microsoft",  "libreoffice", "openoffice", "imagemagick", "graphicsmagick", "picasa",
     "lightroom",  "snapseed",    "camscanner", "ebay",        "coreldraw",      "corel",
     "sodipodi",   "plantuml",    "matlab",     "mathematica", "geogebra",       "jpegmini",
     "ffmpeg",     "ghostscript", "pdfcreator", "chromium",    "vectornator",    "qgis",
     "freecad",    "openscad",    "librecad",   "fritzing",    "kicad",          "gd-jpeg",
     "macromedia", "procreate",   "paint.net",  "pdftex",      "xfig",           "avocode",
     "pixelmator", "photoscape"});

constexpr auto doings = std::to_array<std::string_view>(
    {"created",  "generated", "made",      "processed", "edited",     "exported",
     "produced", "scanned",   "converted", "optimized", "optimised",  "rendered",
     "written",  "saved",     "erstellt",  "erzeugt",   "bearbeitet", "gescannt",
     "créé",     "numérisé",  "creado",    "generado",  "creato",     "generato"});

constexpr auto means = std::to_array<std::string_view>(
    {"with", "by", "from", "using", "mit", "von", "aus", "avec", "par", "con", "por", "da"});

/// Programs' placeholders for a missing name, in the languages of the kiosk.
constexpr auto placeholders = std::to_array<std::string_view>(
    {"untitled",     "unbenannt",     "unnamed",      "title",         "titel",
     "titre",        "título",        "slice",        "slide",         "folie",
     "diapositive",  "diapositiva",   "layer",        "ebene",         "calque",
     "capa",         "livello",       "artboard",     "zeichenfläche", "page",
     "seite",        "página",        "pagina",       "drawing",       "zeichnung",
     "dessin",       "dibujo",        "disegno",      "document",      "dokument",
     "documento",    "doc",           "presentation", "präsentation",  "présentation",
     "presentación", "presentazione", "image",        "imagen",        "immagine",
     "picture",      "pic",           "bild",         "foto",          "photo",
     "grafik",       "graphic",       "img",          "dsc",           "dscn",
     "dscf",         "pxl",           "scan",         "escaneo",       "scansione",
     "numérisation", "svg",           "pdf",          "book",          "mappe",
     "classeur",     "libro",         "layout",       "screenshot",    "bildschirmfoto",
     "schermata",    "camscanner",    "default",      "clipboard"});

constexpr auto untitled = std::to_array<std::string_view>(
    {"ohne titel", "sans titre", "sin título", "sin titulo", "senza titolo", "no title",
     "untitled document", "untitled drawing", "untitled design", "unbenanntes dokument",
     "document sans titre", "documento sin título", "documento senza titolo"});

constexpr auto new_files = std::to_array<std::string_view>(
    {"scanned image", "new document", "neues dokument", "new doc", "screen shot", "whatsapp image",
     "adobe scan", "scanned document", "nouveau document", "nuevo documento", "nuovo documento",
     "screenshot from", "capture d’écran", "capture d'écran", "captura de pantalla"});

/// Placeholders only if a number follows; alone they may be what the picture shows.
constexpr auto numbered = std::to_array<std::string_view>(
    {"group", "gruppe", "groupe", "grupo", "gruppo", "frame", "rahmen", "vector", "path", "pfad",
     "shape", "rectangle", "icon", "ellipse", "object"});

constexpr auto whole_texts = std::to_array<std::string_view>(
    {"my beautiful picture", "exif_jpeg_picture", "exif_jpeg_t422", "powerpoint presentation",
     "powerpoint-präsentation", "présentation powerpoint", "presentación de powerpoint",
     "presentazione di powerpoint", "print", "full page photo", "full page fax print",
     "binary comment", "user comments"});

bool has(Words words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool has_digit(std::string_view text) {
    return std::ranges::any_of(text, is_digit);
}

std::vector<std::string_view> parts_of(std::string_view text, std::string_view between) {
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        const auto end = std::min(text.find_first_of(between), text.size());
        if (end > 0) parts.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

/// "1.16", "v62.1", "cs6": what follows the name of a program. No year, no plain number.
bool is_version(std::string_view word) {
    word = trimmed(word, "v,.;()");
    const auto digits = std::ranges::count_if(word, is_digit);
    const auto dots = std::ranges::count(word, '.');
    if (digits + dots == static_cast<std::ptrdiff_t>(word.size()))
        return digits > 0 && dots >= 1 && dots <= 2 && word.size() <= 7;
    return word.size() <= 5 && digits >= 1 && digits <= 2;
}

/// True for a maker's name, product words and model numbers only, if it is in capitals, digital or
/// with a number: a person may draw a Canon camera.
bool is_of_a_camera(std::string_view text, bool is_in_capitals) {
    const auto is_known = [](std::string_view part) {
        return has(makers, part) || has(words_of_makers, part);
    };
    const auto words = parts_of(text, " ,.");
    const bool is_theirs = std::ranges::all_of(words, [&](std::string_view word) {
        if (has_digit(word)) return true;
        return std::ranges::all_of(parts_of(word, "-"), [&](std::string_view part) {
            return is_known(part) || part.size() <= 2;
        });
    });
    const auto parts = parts_of(text, " ,.-");
    const bool is_loud =
        is_in_capitals || has_digit(text) || std::ranges::count(words, "digital") > 0;
    return is_theirs && is_loud && parts.size() >= 2 && std::ranges::any_of(parts, is_known);
}

/// A telephone's name for a way to take a picture: "cof_vivid", "_cuva", "sdr".
bool is_a_mode(std::string_view text) {
    constexpr auto modes = std::to_array<std::string_view>(
        {"cuva", "oznor", "cof", "dav", "mde",  "hdr",   "hdrpl", "rhdr",     "rbt",   "sdr",
         "ptr",  "edf",   "fbt", "bty", "btf",  "bsh",   "nor",   "nfnor",    "mfnr",  "vhdr",
         "rpt",  "qrf",   "srn", "sdx", "soft", "vivid", "burst", "portrait", "night", "oznorwb"});
    constexpr auto of_people =
        std::to_array<std::string_view>({"soft", "vivid", "burst", "portrait", "night"});
    const auto parts = parts_of(text, "_");
    const bool are_all = std::ranges::all_of(parts, [&](auto part) { return has(modes, part); });
    if (parts.empty() || !are_all) return false;
    return parts.size() > 1 || !has(of_people, parts.front());
}

bool is_value_of_a_machine(std::string_view value) {
    value = trimmed(value, " \t()[]");
    if (value.empty() || value == "true" || value == "false" || value == "null") return true;
    return std::ranges::all_of(value, [](char c) {
        return is_digit(c) || std::string_view(".,-+ xe").find(c) != std::string_view::npos;
    });
}

/// "filter: 0; jpegRotation: 0": names without blanks, most values without words. JSON and XML too.
bool is_a_table(std::string_view text) {
    if (text.starts_with('{') && text.ends_with('}') && text.find("\":") != std::string_view::npos)
        return true;
    if (text.starts_with('<') && text.ends_with('>')) return true;
    std::size_t count = 0;
    std::size_t plain = 0;
    for (const std::string_view part : parts_of(text, ";\n\r")) {
        const std::string_view pair = trimmed(part, " \t");
        if (pair.empty()) continue;
        const auto colon = pair.find_first_of(":=");
        const auto key = trimmed(pair.substr(0, std::min(colon, pair.size())), " \t");
        if (colon == std::string_view::npos || key.find(' ') != std::string_view::npos)
            return false;
        ++count;
        if (is_value_of_a_machine(pair.substr(colon + 1))) ++plain;
    }
    return count >= 2 && 2 * plain >= count;
}

/// "Untitled-1", "Layer 1 copy", "Scan_20230405", "Screenshot 2023-04-05 at 10.15.00".
bool is_a_placeholder(std::string_view text) {
    constexpr auto trailing = std::to_array<std::string_view>(
        {"copy", "kopie", "copie", "copia", "at", "um", "à", "a las", "am", "pm", "uhr"});
    constexpr std::string_view signs = " \t-_.,:;/#()0123456789";
    const bool has_number = has_digit(text);
    for (bool goes_on = true; goes_on;) {
        const auto end = text.find_last_not_of(signs);
        text = text.substr(0, end == std::string_view::npos ? 0 : end + 1);
        goes_on = false;
        for (const std::string_view word : trailing) {
            if (!text.ends_with(word) || text.size() == word.size()) continue;
            const char before = text[text.size() - word.size() - 1];
            if (signs.find(before) == std::string_view::npos) continue;
            text.remove_suffix(word.size());
            goes_on = true;
        }
    }
    return has(placeholders, text) || has(untitled, text) || has(new_files, text) ||
           (has_number && has(numbered, text));
}

/// "Created with Sketch.", "Generated by Foo 3.2 (http://...)"; not "Made with love".
bool is_made_by_a_program(std::string_view text) {
    const auto words = parts_of(text, " \t\n");
    for (std::size_t i = 0; i + 2 < words.size() && i < 3; ++i) {
        if (!has(doings, words[i]) || !has(means, words[i + 1])) continue;
        const auto rest = std::span(words).subspan(i + 2);
        const std::string_view name = trimmed(rest[0], "\"'(,.;:)");
        const bool is_known = has(programs, name) || name.ends_with(".js") ||
                              name.ends_with(".io") || name.starts_with("http");
        const bool has_comma = rest[0].ends_with(',');
        const bool has_version = rest.size() > 1 && !has_comma &&
                                 rest[1].find('.') != std::string_view::npos && is_version(rest[1]);
        const bool has_address = text.find("http://") != std::string_view::npos ||
                                 text.find("https://") != std::string_view::npos ||
                                 text.find("www.") != std::string_view::npos;
        if (is_known || has_version || has_address) return true;
    }
    return false;
}

/// "Adobe Illustrator 27.0, SVG Export", "Microsoft Word - Doc1.docx", "Generator: ...".
bool begins_with_a_program(std::string_view text) {
    for (const std::string_view begin :
         {"microsoft word -", "microsoft powerpoint -", "microsoft excel -", "generator:",
          "creator: gd-jpeg", "lead technologies", "software:", "adobe scan ", "camscanner "})
        if (text.starts_with(begin)) return true;
    const auto words = parts_of(text, " \t\n");
    if (words.size() < 2 || !has(programs, words[0])) return false;
    std::size_t names = 1;
    while (names < words.size() && has(programs, trimmed(words[names], ","))) ++names;
    return names == words.size() || is_version(words[names]);
}

/// One word that nobody says: a file's name, a path, an address, a long number.
bool is_a_token(std::string_view text) {
    const bool is_path = text.size() > 3 && text.substr(1, 2) == ":\\";
    if (is_path) return true;
    if (text.empty() || text.find_first_of(" \t\n") != std::string_view::npos) return false;
    if (text.starts_with("http://") || text.starts_with("https://") || text.starts_with("www."))
        return true;
    constexpr auto endings = std::to_array<std::string_view>(
        {".jpg", ".jpeg", ".png",  ".gif", ".tif", ".tiff", ".heic", ".webp", ".svg", ".svgz",
         ".pdf", ".doc",  ".docx", ".odt", ".ppt", ".pptx", ".xls",  ".xlsx", ".ai",  ".eps",
         ".psd", ".indd", ".dwg",  ".dxf", ".cdr", ".vsd",  ".bmp",  ".raw"});
    const bool is_file =
        std::ranges::any_of(endings, [text](std::string_view end) { return text.ends_with(end); });
    constexpr std::size_t long_token = 24;
    constexpr std::ptrdiff_t long_number = 5;
    const bool has_letters = std::ranges::any_of(text, [](char c) {
        return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80U;
    });
    return is_file || (text.size() >= long_token && has_digit(text)) ||
           (!has_letters && std::ranges::count_if(text, is_digit) >= long_number);
}

}  // namespace

bool is_of_a_machine(std::string_view text) {
    const std::string small = in_small_letters(trimmed(text, " \t\r\n"));
    const bool is_in_small_letters = in_small_letters(text) == text;
    const bool is_in_capitals =
        std::ranges::none_of(text, [](char c) { return c >= 'a' && c <= 'z'; });
    return has(whole_texts, trimmed(small, ".")) || is_of_a_camera(small, is_in_capitals) ||
           (is_in_small_letters && is_a_mode(small)) || is_a_table(small) ||
           is_a_placeholder(small) || is_made_by_a_program(small) || begins_with_a_program(small) ||
           is_a_token(small);
}

}  // namespace touchline::decode
