#include "tests/app/documents/decode/reference.h"

#include "app/documents/decode/file_format.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

#include <fmt/format.h>

namespace touchline {
namespace {

std::vector<std::uint8_t> output_of(const std::string& command) {
    std::vector<std::uint8_t> bytes;
    FILE* const pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return bytes;
    std::array<std::uint8_t, 65536> part{};
    for (std::size_t got = 0; (got = std::fread(part.data(), 1, part.size(), pipe)) > 0;)
        bytes.insert(bytes.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(got));
    pclose(pipe);
    return bytes;
}

FileFormat format_at(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::vector<char> head(4096);
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    return format_of(std::as_bytes(std::span(head)));
}

/// Returns a command that writes the picture as PPM.
std::string command_for(const std::string& path, const Page& like) {
    const int width = like.picture.width;
    const int height = like.picture.height;
    constexpr auto to_ppm =
        "-background white -alpha remove -alpha off +set comment -depth 8 ppm:- 2>/dev/null";
    switch (format_at(path)) {
        case FileFormat::svg:
            return fmt::format("rsvg-convert -w {} -h {} '{}' 2>/dev/null | convert png:- {}",
                               width, height, path, to_ppm);
        case FileFormat::pdf:
            return fmt::format(
                "pdftoppm -cropbox -f {} -l {} -scale-to-x {} -scale-to-y {} '{}' 2>/dev/null",
                like.number, like.number, width, height, path);
        case FileFormat::heif:  // ImageMagick repeats colours where libheif blends them
            return fmt::format(
                "heif-convert '{0}' '{0}.png' >/dev/null 2>&1 && convert '{0}.png' {1}", path,
                to_ppm);
        default:
            return fmt::format("convert '{}[0]' -auto-orient -colorspace sRGB {}", path, to_ppm);
    }
}

/// Reads P6 with 255 levels.
Picture picture_of_ppm(const std::vector<std::uint8_t>& bytes) {
    Picture picture;
    int most = 0;
    int header = 0;
    const std::string head(bytes.begin(),
                           bytes.begin() + std::min<std::ptrdiff_t>(64, std::ssize(bytes)));
    if (std::sscanf(head.c_str(), "P6 %d %d %d%n", &picture.width, &picture.height, &most,
                    &header) != 3 ||
        most != 255)
        return {};
    const std::size_t first = static_cast<std::size_t>(header) + 1;
    picture.bgr.assign(bytes.begin() + static_cast<std::ptrdiff_t>(first), bytes.end());
    for (std::size_t i = 0; i + 2 < picture.bgr.size(); i += 3)
        std::swap(picture.bgr[i], picture.bgr[i + 2]);
    return picture;
}

}  // namespace

Result<Picture> reference_picture(const std::string& path, const Page& like) {
    Picture picture = picture_of_ppm(output_of(command_for(path, like)));
    if (picture.width < 1 || picture.bgr.empty()) return failure("the reference shows nothing");
    return picture;
}

Difference difference(const Picture& a, const Picture& b) {
    if (a.width != b.width || a.height != b.height || a.bgr.size() != b.bgr.size()) return {};
    Difference found{0, 0.0, true};
    double sum = 0.0;
    for (std::size_t i = 0; i < a.bgr.size(); ++i) {
        const int d = std::abs(int{a.bgr[i]} - int{b.bgr[i]});
        found.most = std::max(found.most, d);
        sum += d;
    }
    found.mean = sum / static_cast<double>(std::max<std::size_t>(a.bgr.size(), 1));
    return found;
}

Tolerance tolerance_for(const std::string& path) {
    switch (format_at(path)) {
        case FileFormat::svg:
        case FileFormat::pdf:
            return {255, 2.0};
        case FileFormat::jpeg:
        case FileFormat::webp:
        case FileFormat::heif:
            return {3, 0.5};
        default:
            return {1, 0.25};  // every decoder rounds transparency differently
    }
}

bool run_command(const std::string& command) {
    return std::system(command.c_str()) == 0;
}

}  // namespace touchline
