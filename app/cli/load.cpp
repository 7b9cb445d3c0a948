#include "app/cli/load.h"

#include "app/documents/decode/map_svg.h"
#include "app/documents/decode/one_line.h"
#include "app/documents/decode/opening.h"
#include "app/documents/models/networks.h"
#include "app/documents/trace/page_views.h"
#include "config/types/map_bytes.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/core.h>

namespace touchline {
namespace {

Error of_file(const std::string& path, const Error& error) {
    return {fmt::format("{}: {}", path, error.line)};
}

/// The map as it is, with a report that says so.
Result<TracedMap> own_map(const SeenView& view, int detail) {
    return shown_at(view.page.told, detail).map([&view](TactileMap map) {
        TracedMap felt;
        felt.report = fmt::format(
            "{{\n  \"class\": \"{}\", \"reason\": {},\n  \"outlines\": {}, \"points\": {}\n}}\n",
            view.is_face ? "face" : "map",
            json_string(view.is_face ? "This is a face, drawn in lines."
                                     : "This is a map of Touchline's own: it is felt as it is."),
            map.outlines.size(), point_count(map));
        felt.map = std::move(map);
        return felt;
    });
}

/// Tracing tells whether a picture is a photograph.
bool is_photo(const Page& page) {
    if (is_own_map(page) || !page.figures.empty()) return false;
    const auto traced = trace_page(page, {});
    return traced && traced->is_photo;
}

/// Looks with the networks for which there is memory.
Result<void> look_with(const PictureNetworkFiles& files, SeenView& seen) {
    const auto networks = with_room(files.networks());
    if (!networks) return tl::unexpected(networks.error());
    return find_main_things(seen.page, *networks).map([&](MainThings things) {
        seen.things = std::move(things);
        if (seen.things->is_sure) return;
        seen.note = networks->figure.empty() && !files.figure.empty()
                        ? "finding its main thing needs 2 GB of free memory"
                        : "no clear main thing was found";
    });
}

/// Fails only if the things are wanted. Otherwise a note says why there are none, if that is worth
/// one.
Result<void> look_for_things(bool are_wanted, SeenView& seen) {
    const bool has_views = is_photo(seen.page);
    if (!are_wanted && !has_views) return {};
    const Result<void> looked = read_picture_networks().and_then(
        [&](const PictureNetworkFiles& read) { return look_with(read, seen); });
    if (!looked && are_wanted) return looked;
    if (!looked) seen.note = looked.error().line;
    if (seen.things && has_views) seen.page = with_main_things(std::move(seen.page), *seen.things);
    return {};
}

std::string no_figure(const SeenView& seen) {
    if (!seen.note.empty() && !is_installed(*network_named("figure")))
        return seen.note + "; 'touchline models get figure' brings what sees more";
    return seen.note.empty() ? "it is no photograph, and is felt as a whole; choose --view whole"
                             : seen.note + "; choose --view whole";
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

std::optional<ViewChoice> view_choice_of(const std::string& text) {
    constexpr int most_views = 101;
    if (text == "whole") return ViewChoice{ViewChoice::Kind::whole, 1};
    if (text == "figure") return ViewChoice{ViewChoice::Kind::figure, 1};
    const auto number = number_in(text, 1, most_views);
    if (!number) return std::nullopt;
    return ViewChoice{ViewChoice::Kind::numbered, *number};
}

Result<SeenView> open_view(const std::string& path, const ViewChoice& view, bool wants_things,
                           const LanguageTag& language) {
    const auto open = [&](PageOrder order) {
        order.language = language;
        return open_page_of(path, order);
    };
    auto page = open({});
    if (!page) return tl::unexpected(page.error());
    SeenView seen{path, std::move(*page), std::nullopt};
    const Result<void> looked = look_for_things(wants_things, seen);
    if (!looked) return tl::unexpected(of_file(path, looked.error()));
    if (view.kind == ViewChoice::Kind::figure && !has_main_things(seen.page))
        return tl::unexpected(of_file(path, {no_figure(seen)}));
    const int views = view_count(seen.page);
    const int number = view.kind == ViewChoice::Kind::whole ? views : view.number;
    if (number > views)
        return tl::unexpected(
            of_file(path, {fmt::format("it has {} to feel; choose one of them",
                                       views == 1 ? "one view" : fmt::format("{} views", views))}));
    if (auto finer = finer_page(seen.page, number, open)) seen.page = std::move(*finer);
    seen.is_face = is_face(seen.page, number);
    if (number < views) seen.page = view_of(seen.page, number);
    return seen;
}

Result<TracedMap> trace_view(const SeenView& view, const TraceRequest& request) {
    const auto felt = is_own_map(view.page) ? own_map(view, request.options.detail)
                                            : trace_page(view.page, request);
    return felt.map_error([&view](const Error& error) { return of_file(view.path, error); });
}

Result<TactileMap> map_of(const SeenView& view) {
    return trace_view(view, {}).map([](TracedMap felt) { return std::move(felt.map); });
}

Result<TactileMap> load_map(const std::string& path, bool as_picture) {
    if (is_map_name(path) && !as_picture) return read_map_svg(path);
    return open_view(path).and_then([](const SeenView& view) { return map_of(view); });
}

Result<TactileMap> load_drawing(const std::string& path, int detail) {
    Result<TactileMap> map = read_map_svg(path);
    if (!map) return map;
    return shown_at(std::move(*map), detail).map_error([&path](const Error& error) {
        return of_file(path, error);
    });
}

}  // namespace touchline
