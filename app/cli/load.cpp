#include "app/cli/load.h"

#include "app/decode/map_svg.h"

#include <algorithm>
#include <atomic>
#include <cctype>

#include <fmt/core.h>
#include <opencv2/core.hpp>

namespace touchline {
namespace {

std::uint64_t next_version() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

/// The decoded pixels as vision takes them; no copy.
cv::Mat view_of(Picture& picture) {
    return {picture.height, picture.width, CV_8UC3, picture.bgr.data()};
}

Result<Trace> trace(Picture& picture, const std::string& path, const TraceOptions& options) {
    return trace_outlines(view_of(picture), options).map_error([&path](const Error& error) {
        return Error{fmt::format("{}: {}", path, error.line)};
    });
}

Result<LoadedPicture> load_shown_drawing(const std::string& path, int detail) {
    Result<TactileMap> map = load_drawing(path, detail);
    if (!map) return tl::unexpected(map.error());
    map->version = next_version();
    return read_picture(path).map([&map](Picture picture) {
        return LoadedPicture{std::move(*map), std::move(picture), {}};
    });
}

}  // namespace

bool is_map_name(const std::string& path) {
    constexpr std::string_view ending = ".svg";
    return path.size() >= ending.size() &&
           std::equal(ending.begin(), ending.end(),
                      path.end() - static_cast<std::ptrdiff_t>(ending.size()), [](char a, char b) {
                          return a == std::tolower(static_cast<unsigned char>(b));
                      });
}

Result<Trace> trace_picture(const std::string& path, const TraceOptions& options) {
    return read_picture(path).and_then(
        [&](Picture picture) { return trace(picture, path, options); });
}

Result<TactileMap> load_map(const std::string& path, bool as_picture) {
    if (is_map_name(path) && !as_picture) return read_map_svg(path);
    return trace_picture(path, {}).map([](Trace found) { return std::move(found.map); });
}

Result<TactileMap> load_drawing(const std::string& path, int detail) {
    Result<TactileMap> map = read_map_svg(path);
    if (!map) return map;
    std::erase_if(map->outlines,
                  [detail](const Outline& outline) { return outline.detail > detail; });
    if (map->outlines.empty()) {
        return failure(fmt::format("{}: no outline is shown at detail {}; choose a higher detail",
                                   path, detail));
    }
    return map;
}

Result<LoadedPicture> load_picture_or_map(const std::string& path, int detail, const Area& area) {
    if (is_map_name(path)) return load_shown_drawing(path, detail);
    Result<Picture> picture = read_picture(path);
    if (!picture) return tl::unexpected(picture.error());
    Result<Trace> found = trace(*picture, path, {area, detail});
    if (!found) return tl::unexpected(found.error());
    found->map.version = next_version();
    return LoadedPicture{std::move(found->map), std::move(*picture), found->report.warning};
}

}  // namespace touchline
