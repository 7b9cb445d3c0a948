#include "app/sticks/file_kind.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool is_same(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower(x) == lower(y); });
}

template <std::size_t count>
bool is_one_of(std::string_view name, const std::array<std::string_view, count>& names) {
    return std::any_of(names.begin(), names.end(),
                       [name](std::string_view one) { return is_same(name, one); });
}

constexpr std::array<std::string_view, 20> pictures{
    "png", "apng", "jpg", "jpeg", "jpe", "jfif", "webp", "gif",  "bmp",  "dib",
    "pnm", "pbm",  "pgm", "ppm",  "tif", "tiff", "heic", "heif", "avif", "hif"};
constexpr std::array<std::string_view, 3> documents{"svg", "svgz", "pdf"};
constexpr std::array<std::string_view, 15> office_files{"doc", "docx", "docm",    "odt",   "rtf",
                                                        "ppt", "pptx", "odp",     "xls",   "xlsx",
                                                        "ods", "odg",  "numbers", "pages", "key"};

/// The folders of Windows, macOS, Linux and Android.
constexpr std::array<std::string_view, 8> folders_of_systems{"System Volume Information",
                                                             "$RECYCLE.BIN",
                                                             "RECYCLER",
                                                             "RECYCLED",
                                                             "lost+found",
                                                             "__MACOSX",
                                                             "LOST.DIR",
                                                             "FOUND.000"};

/// Without its dot; empty if there is none.
std::string_view ending_of(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    const bool has_ending = dot != std::string_view::npos && dot > 0;
    return has_ending ? name.substr(dot + 1) : std::string_view();
}

}  // namespace

std::optional<StickFileKind> kind_of_name(std::string_view name) {
    const std::string_view ending = ending_of(name);
    if (is_one_of(ending, pictures)) return StickFileKind::picture;
    if (is_one_of(ending, documents)) return StickFileKind::document;
    if (is_one_of(ending, office_files)) return StickFileKind::office;
    return std::nullopt;
}

std::optional<StickFileKind> operator_kind_of_name(std::string_view name) {
    const std::string_view ending = ending_of(name);
    if (is_same(ending, "zip")) return StickFileKind::pack;
    if (is_same(ending, "onnx")) return StickFileKind::network;
    return std::nullopt;
}

bool is_left_out(std::string_view name) {
    // "~$letter.docx": a program's mark that it has the letter open.
    return name.empty() || name.starts_with('.') || name.starts_with("~$") ||
           is_one_of(name, folders_of_systems);
}

std::string side_car_of(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    const bool has_ending = dot != std::string_view::npos && dot > 0;
    return std::string(has_ending ? name.substr(0, dot) : name) + ".txt";
}

std::string_view office_sentence() {
    return "Office files cannot be felt; please save it as a PDF and bring that";
}

}  // namespace touchline
