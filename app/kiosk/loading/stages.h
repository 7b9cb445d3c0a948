// The way of a picture from its file to the hand, in stages whose results are worth keeping
// (load_plan.h), because each serves many times.
// Threads: values that share what does not change.
#pragma once

#include "app/documents/decode/file_format.h"
#include "app/documents/decode/page.h"
#include "app/documents/packs/picture_recordings.h"
#include "app/documents/trace/page_views.h"
#include "app/documents/trace/tracing.h"
#include "app/force/servo/servo_client.h"
#include "app/screen/screen_content.h"
#include "app/visit/page_place.h"
#include "config/types/pinned.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "config/types/thing_name.h"
#include "vision/simplify/zoom.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

struct LoadedFacts {
    std::string title;
    int outline_count = 0;
    std::string note;  // one sentence worth telling; may be empty
    PagePlace place = {1, 1, 1, 1};
    std::vector<NamedThing> names = {};    // what the things of a photograph probably are
    PictureRecordingsPtr recordings = {};  // null: there are none
};

/// A file of the list. Two of them are the same only if they are the same object.
struct PictureFile {
    std::string name;          // begins the sentences about the file; fit to be shown
    std::string title;         // used if the file has none of its own
    std::string gallery_file;  // its name in the gallery; empty: a visitor's file
    bool is_private = false;   // from a stick: no log may name it
    /// Opens one of its pages. Errors are one line with the file's name. Called from any thread, at
    /// any time.
    std::function<Result<Page>(const PageOrder&)> open;
    /// Raw bytes, if `title` was made from the file's name rather than by a person. Only
    /// spoken_name() may say them.
    std::string file_name = {};
    /// Reads what is recorded of the words of a page. Called as open() is. Empty: nothing is.
    std::function<PictureRecordingsPtr(const TactileMap& told)> recordings = {};
};

using FilePtr = std::shared_ptr<const PictureFile>;
using PagePtr = std::shared_ptr<const Page>;

/// The part of a view that is felt: how much detail, and which part enlarged.
struct FeltPart {
    int detail = 3;  // 1 silhouette ... 5 all
    Zoom zoom = {};

    friend bool operator==(const FeltPart&, const FeltPart&) = default;
};

/// What is felt of a part that was traced already.
struct TracedPart {
    FeltPart part;
    Result<TracedMap> map;
};

/// A view with its lines, for every part.
struct FoundView {
    PagePtr view;
    std::optional<FoundLines> lines;  // none: the view's own outlines are felt
    std::optional<TracedPart>
        first;  // traced with these lines: the part that was wanted when they were found
    std::shared_ptr<const Canvas> picture;
    PagePlace place;                       // every field is known
    bool is_photo = false;                 // nobody has looked for main things in it
    std::size_t bytes = 0;                 // roughly what it holds
    PictureRecordingsPtr recordings = {};  // null: there are none
};

using FoundPtr = std::shared_ptr<const FoundView>;

struct LoadedScene {
    ShownScene shown;
    FeltPicture felt;
    LoadedFacts facts;
};

/// The place of a view of the page; a view beyond the last is the last.
[[nodiscard]] inline PagePlace place_of(const Page& page, int view) {
    const int views = view_count(page);
    const int shown = std::min(view, views);
    return {page.number,
            page.count,
            shown,
            views,
            has_main_things(page) ? ThingSearch::found : ThingSearch::none,
            is_face(page, shown)};
}

/// Each call stands by itself, from any thread. Errors are one line with the file's name.
class Stages : public Interface {
  public:
    /// Opens page 1 ... of a file. Waits for a worker.
    [[nodiscard]] virtual Result<PagePtr> open(const PictureFile& file, int page) const = 0;

    /// Finds the lines of a view, 1 ... view_count(page), and traces `part`. May open the page
    /// again, drawn finer. Waits for a worker.
    [[nodiscard]] virtual Result<FoundPtr> find(const PictureFile& file, const PagePtr& page,
                                                int view, const FeltPart& part) const = 0;

    /// Builds what is felt and shown of it. Takes milliseconds; waits for a worker if the part is
    /// another one.
    [[nodiscard]] virtual Result<LoadedScene> build(const PictureFile& file, const FoundView& found,
                                                    const FeltPart& part) const = 0;

    /// False if look() and look_at() would never find anything.
    [[nodiscard]] virtual bool has_looking() const = 0;

    /// A second look at a photograph. Returns its page with its main things and faces, each a view,
    /// and with what they probably are. Never null. Its errors name no file. Waits for a worker,
    /// some seconds.
    [[nodiscard]] virtual Result<PagePtr> look(const PagePtr& page) const = 0;

    /// The same for the thing at a place of a view, in metres from the middle of the view when it
    /// is felt whole. The page has it as the last view before the whole. Null if nothing is clear
    /// there.
    [[nodiscard]] virtual Result<PagePtr> look_at(const PagePtr& page, int view,
                                                  const Position& place) const = 0;

    /// False if reread() would never find anything.
    [[nodiscard]] virtual bool has_reading() const = 0;

    /// A slow second look: the view with the words that were read in its pixels. Null if there are
    /// none.
    [[nodiscard]] virtual FoundPtr reread(const FoundView& found) const = 0;
};

}  // namespace touchline
