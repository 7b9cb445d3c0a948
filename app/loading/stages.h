// The way of a picture from its file to the hand, in stages that are worth keeping apart: what one
// gives is kept (load_plan.h) and serves many times.
// Threads: values that share what does not change.
#pragma once

#include "app/decode/page.h"
#include "app/decode/page_order.h"
#include "app/screen/shown_scene.h"
#include "app/servo/servo_client.h"
#include "app/session/page_place.h"
#include "app/trace/page_views.h"
#include "app/trace/tracing.h"
#include "config/types/result.h"
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
    int coarsest_level = 0;
    std::string note;  // one sentence worth telling; may be empty
    PagePlace place = {1, 1, 1, 1};
    std::vector<NamedThing> names = {};  // what the things of a photograph are taken for
};

/// A file of the list. Two of them are the same only if they are the same object.
struct PictureFile {
    std::string name;          // as sentences about it begin; fit to be shown
    std::string title;         // where the file has none of its own
    std::string gallery_file;  // its name there; empty: a visitor's
    bool is_private = false;   // of a stick: no log may name it
    /// A page of it. Errors are one line with the file's name. From any thread, at any time.
    std::function<Result<Page>(const PageOrder&)> open;
    /// Raw bytes, where `title` is made of it and no person's: said by spoken_name() alone.
    std::string file_name = {};
};

using FilePtr = std::shared_ptr<const PictureFile>;
using PagePtr = std::shared_ptr<const Page>;

/// What of a view is felt: how much of it, and which part of it enlarged.
struct FeltPart {
    int detail = 3;  // 1 silhouette ... 5 all
    Zoom zoom = {};

    friend bool operator==(const FeltPart&, const FeltPart&) = default;
};

/// What is felt of a part, where it was traced already.
struct TracedPart {
    FeltPart part;
    Result<TracedMap> map;
};

/// A view with its lines, for every part.
struct FoundView {
    PagePtr view;
    std::optional<FoundLines> lines;  // none: the view's own outlines are felt
    std::optional<TracedPart>
        first;  // of these lines: of the part that was wanted when they were found
    std::shared_ptr<const Canvas> picture;
    PagePlace place;        // all of it known
    bool is_photo = false;  // that nobody has looked for main things in
    std::size_t bytes = 0;  // about what it holds
};

using FoundPtr = std::shared_ptr<const FoundView>;

struct LoadedScene {
    ShownScene shown;
    FeltPicture felt;
    LoadedFacts facts;
};

/// Where a view of the page lies; one beyond the last is the last.
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

/// Each call by itself, from any thread. Errors are one line with the file's name.
class Stages {
  public:
    Stages() = default;
    virtual ~Stages() = default;
    Stages(const Stages&) = delete;
    Stages(Stages&&) = delete;
    Stages& operator=(const Stages&) = delete;
    Stages& operator=(Stages&&) = delete;

    /// Page 1 ... of a file. Waits for a worker.
    [[nodiscard]] virtual Result<PagePtr> open(const PictureFile& file, int page) const = 0;

    /// A view, 1 ... view_count(page), with its lines, and what is felt of `part`. May open the
    /// page again, drawn finer. Waits for a worker.
    [[nodiscard]] virtual Result<FoundPtr> find(const PictureFile& file, const PagePtr& page,
                                                int view, const FeltPart& part) const = 0;

    /// What is felt and shown of it. Milliseconds; waits for a worker where the part is another
    /// one.
    [[nodiscard]] virtual Result<LoadedScene> build(const PictureFile& file, const FoundView& found,
                                                    const FeltPart& part) const = 0;

    /// False: look() and look_at() would find nothing, ever.
    [[nodiscard]] virtual bool has_looking() const = 0;

    /// A second look at a photograph: its page with its main things and faces, each a view, and
    /// with what they are taken for. Never null. Its errors name no file. Waits for a worker, some
    /// seconds.
    [[nodiscard]] virtual Result<PagePtr> look(const PagePtr& page) const = 0;

    /// The same of the thing at a place of a view, in metres from its middle as it is felt whole:
    /// the page with it as the last view before the whole. Null where nothing is clear there.
    [[nodiscard]] virtual Result<PagePtr> look_at(const PagePtr& page, int view,
                                                  const Position& place) const = 0;

    /// False: reread() would find nothing, ever.
    [[nodiscard]] virtual bool has_reading() const = 0;

    /// A second look that takes its time: the view with the words that were read in its pixels.
    /// Null where there are none.
    [[nodiscard]] virtual FoundPtr reread(const FoundView& found) const = 0;
};

}  // namespace touchline
