// Turns a file name into what is felt and shown.
// Threads: any, each call by itself.
#pragma once

#include "app/documents/trace/finding_things.h"
#include "app/documents/trace/tracing.h"
#include "config/types/choices.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <cstdint>
#include <optional>
#include <string>

namespace touchline {

/// True for a name that ends in .svg, which is a map to every command but `trace`.
[[nodiscard]] bool is_map_name(const std::string& path);

/// Which view of a page: the kiosk's first, the whole, the main thing of a photograph, or one by
/// its number (1 ..., app/documents/trace/page_views.h).
struct ViewChoice {
    enum class Kind : std::uint8_t { first, whole, figure, numbered };

    Kind kind = Kind::first;
    int number = 1;
};

/// "whole", "figure" or a number from 1 to 101; nothing for anything else.
[[nodiscard]] std::optional<ViewChoice> view_choice_of(const std::string& text);

/// A view as the kiosk opens and draws it.
struct SeenView {
    std::string path;  // the file's
    Page page;
    std::optional<MainThings> things;  // a photograph's, if the network is installed; also unsure
    std::string note = {};             // one sentence worth telling the user; may be empty
    bool is_face = false;              // drawn in lines
};

/// Opens a view of a file's first page, and looks for a photograph's main things. With
/// `wants_things` it looks in every picture, and fails if it cannot. Words that the file has in
/// several languages are those in `language`.
[[nodiscard]] Result<SeenView> open_view(const std::string& path, const ViewChoice& view = {},
                                         bool wants_things = false,
                                         const LanguageTag& language = {});

/// What the kiosk lets a hand feel of a view: its lines, or a map of Touchline's own as it is.
/// Errors start with the file.
[[nodiscard]] Result<TracedMap> trace_view(const SeenView& view, const TraceRequest& request);

/// The same with the defaults of `trace`.
[[nodiscard]] Result<TactileMap> map_of(const SeenView& view);

/// The map of a file: reads an .svg as it is, and traces the first view of any other file.
/// `as_picture` treats an .svg as a picture.
[[nodiscard]] Result<TactileMap> load_map(const std::string& path, bool as_picture);

/// A map without its outlines above `detail`.
[[nodiscard]] Result<TactileMap> load_drawing(const std::string& path, int detail);

}  // namespace touchline
