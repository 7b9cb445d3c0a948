#include "app/cli/load.h"

#include "app/cli/json.h"
#include "app/decode/map_svg.h"
#include "app/decode/opening.h"
#include "app/trace/own_map.h"
#include "app/trace/page_views.h"
#include "config/types/map_limits.h"

#include <algorithm>
#include <cctype>

#include <fmt/core.h>

namespace touchline {
namespace {

Error of_file(const std::string& path, const Error& error) {
    return {fmt::format("{}: {}", path, error.line)};
}

/// As it is, with a report that says so.
Result<TracedMap> own_map(const Page& page, int detail) {
    return shown_at(page.told, detail).map([](TactileMap map) {
        TracedMap felt;
        felt.report = fmt::format(
            "{{\n  \"class\": \"map\", \"reason\": {},\n  \"outlines\": {}, \"points\": {}\n}}\n",
            json_string("This is a map of Touchline's own: it is felt as it is."),
            map.outlines.size(), point_count(map));
        felt.map = std::move(map);
        return felt;
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

Result<Page> open_view(const std::string& path, int view) {
    auto page = open_page_of(path);
    if (!page) return page;
    const int views = view_count(*page);
    if (view > views)
        return tl::unexpected(
            of_file(path, {fmt::format("it has {} to feel; choose one of them",
                                       views == 1 ? "one view" : fmt::format("{} views", views))}));
    const auto open = [&path](const PageOrder& order) { return open_page_of(path, order); };
    if (auto finer = finer_page(*page, view, open)) page = std::move(*finer);
    return view < views ? view_of(*page, view) : std::move(page);
}

Result<TracedMap> trace_picture(const std::string& path, const TraceRequest& request, int view) {
    const auto seen = open_view(path, view);
    if (!seen) return tl::unexpected(seen.error());
    const auto felt =
        is_own_map(*seen) ? own_map(*seen, request.options.detail) : trace_page(*seen, request);
    return felt.map_error([&path](const Error& error) { return of_file(path, error); });
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
