#include "app/cli/load.h"

#include "app/cli/page_map.h"
#include "app/decode/map_svg.h"
#include "app/decode/opening.h"

#include <algorithm>
#include <cctype>

#include <fmt/core.h>

namespace touchline {
namespace {

Error of_file(const std::string& path, const Error& error) {
    return {fmt::format("{}: {}", path, error.line)};
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

Result<TracedMap> trace_picture(const std::string& path, const TraceRequest& request) {
    const auto page = open_page_of(path);
    if (!page) return tl::unexpected(page.error());
    return trace_page(*page, request).map_error([&path](const Error& error) {
        return of_file(path, error);
    });
}

Result<TactileMap> load_map(const std::string& path, bool as_picture) {
    if (is_map_name(path) && !as_picture) return read_map_svg(path);
    return trace_picture(path, {}).map([](TracedMap found) { return std::move(found.map); });
}

Result<TactileMap> load_drawing(const std::string& path, int detail) {
    Result<TactileMap> map = read_map_svg(path);
    if (!map) return map;
    return shown_at(std::move(*map), detail).map_error([&path](const Error& error) {
        return of_file(path, error);
    });
}

}  // namespace touchline
