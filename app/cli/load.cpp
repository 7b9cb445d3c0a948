#include "app/cli/load.h"

#include "app/cli/page_map.h"
#include "app/decode/map_svg.h"
#include "app/decode/opening.h"

#include <algorithm>
#include <atomic>
#include <cctype>

#include <fmt/core.h>

namespace touchline {
namespace {

std::uint64_t next_version() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

Error of_file(const std::string& path, const Error& error) {
    return {fmt::format("{}: {}", path, error.line)};
}

Result<LoadedPicture> load_page(Page page, int detail, const Area& area) {
    if (!page.told.outlines.empty())
        return drawn_lines(page, detail).map([&page](TactileMap map) {
            return LoadedPicture{std::move(map), std::move(page.picture), {}};
        });
    return trace_page(page, {area, detail}).map([&page](Trace found) {
        return LoadedPicture{std::move(found.map), std::move(page.picture), found.report.warning};
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
    const auto page = open_page_of(path);
    if (!page) return tl::unexpected(page.error());
    return trace_page(*page, options).map_error([&path](const Error& error) {
        return of_file(path, error);
    });
}

Result<TactileMap> load_map(const std::string& path, bool as_picture) {
    if (is_map_name(path) && !as_picture) return read_map_svg(path);
    return trace_picture(path, {}).map([](Trace found) { return std::move(found.map); });
}

Result<TactileMap> load_drawing(const std::string& path, int detail) {
    Result<TactileMap> map = read_map_svg(path);
    if (!map) return map;
    return shown_at(std::move(*map), detail).map_error([&path](const Error& error) {
        return of_file(path, error);
    });
}

Result<LoadedPicture> load_picture(const std::string& path, int detail, const Area& area) {
    auto page = open_page_of(path);
    if (!page) return tl::unexpected(page.error());
    auto loaded = load_page(std::move(*page), detail, area);
    if (!loaded) return tl::unexpected(of_file(path, loaded.error()));
    loaded->map.version = next_version();
    return loaded;
}

}  // namespace touchline
