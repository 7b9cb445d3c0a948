// Decides what to do next so that the wanted picture is felt soon, and the next one at once: a
// state machine that knows no thread, clock or file.
//
//   want ──> open page ──> find lines ──> build scene ──> delivery
//               │              │  kept: a change of detail goes on from here
//               └──────────────┴─ and for the next view and page, once the present one is felt
//
// A photograph is felt as a whole first; then its main things are looked for, and become views of
// it. A thing that a visitor points at is looked for before it is traced: want ──> look at ──>
// find. Its page replaces the old one when the thing is felt. If anything fails or is cancelled,
// what is felt stays wanted.
//
// Threads: one.
#pragma once

#include "app/kiosk/loading/stages.h"

#include <cstddef>
#include <cstdint>
#include <list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace touchline {

struct ViewOrder {
    FilePtr file;
    int page = 1;
    int view = 1;  // beyond the last: the last
    FeltPart part = {};
    /// Wants the thing at this place of the view instead of the view: in metres from the middle of
    /// the view when it is felt whole.
    std::optional<Position> thing_at = {};
};

enum class JobKind : std::uint8_t { open, find, build, look, look_at, reread };

/// True if a network looks at a photograph.
[[nodiscard]] constexpr bool is_look(JobKind kind) {
    return kind == JobKind::look || kind == JobKind::look_at;
}

/// A piece of work with everything that it needs.
struct LoadJob {
    std::uint64_t number = 0;
    JobKind kind = JobKind::open;
    ViewOrder order;
    std::uint64_t request = 0;  // for a scene to be built
    PagePtr page;               // to find lines on
    FoundPtr found;             // to build a scene of, or to read words in
};

using JobOutcome = std::variant<Result<PagePtr>, Result<FoundPtr>, Result<LoadedScene>>;

/// The result of a request. A second one for the same request improves on the first.
struct Delivery {
    std::uint64_t request = 0;
    Result<LoadedScene> scene;
    PagePlace place;  // as far as it is known, if there is no scene
    bool is_better = false;
};

/// The result of a second look at a photograph.
struct ThingsFound {
    std::uint64_t request = 0;      // the one that is felt
    PagePlace place;                // of what is felt
    std::vector<NamedThing> names;  // of what is felt
    std::string why_not;            // one line that names no file, if the search could not run
};

/// The line of a delivery if no clear thing lies at the requested place.
inline constexpr std::string_view nothing_there =
    "Nothing clear was found there. Move the handle elsewhere and try again.";

/// The kinds of second looks that are possible.
struct SecondLooks {
    bool for_things = false;
    bool for_words = false;
};

struct PlanLimits {
    std::size_t jobs = 2;  // at a time; one of them is for what is wanted
    std::size_t kept_bytes = std::size_t{192} << 20U;  // beyond the present page and view
};

class LoadPlan {
  public:
    LoadPlan(SecondLooks looks, PlanLimits limits);

    /// Replaces what was wanted before. `request`: a new number.
    void want(std::uint64_t request, const ViewOrder& order);

    /// Drops what was wanted last; what is felt stays wanted.
    void cancel();

    /// The jobs to start now. Each must be finished once.
    [[nodiscard]] std::vector<LoadJob> start();

    /// Reports how the job ended. Returns nothing if nobody waits for it.
    [[nodiscard]] std::optional<Delivery> finish(std::uint64_t job, JobOutcome outcome);

    /// What became known since the last call.
    [[nodiscard]] std::optional<ThingsFound> take_things() { return std::exchange(things_, {}); }

    /// Drops everything wanted and kept, and ignores the jobs that still run.
    void forget();

    [[nodiscard]] std::size_t kept_bytes() const;

  private:
    /// An opened page, or a view with its lines.
    struct Kept {
        FilePtr file;
        int number = 0;  // the requested number of the page; the worker's own is not trusted
        PagePtr page;
        FoundPtr found;
        bool is_reread = false;
        std::optional<ThingSearch> looked_for = {};  // the result of a second look at the page
        bool is_before_look = false;  // a whole photograph, traced before its things were known
    };

    using KeptList = std::list<Kept>;

    /// Identifies a piece of work, whatever was known when it was given out.
    struct Step {
        JobKind kind;
        FilePtr file;
        int page;
        int view;

        friend bool operator==(const Step&, const Step&) = default;
    };

    [[nodiscard]] static Step step_of(const LoadJob& job);
    [[nodiscard]] static bool is_page_of(const Kept& kept, const ViewOrder& order);
    [[nodiscard]] static bool is_view_of(const Kept& kept, const ViewOrder& order);
    [[nodiscard]] const Kept* page_of(const ViewOrder& order) const;
    [[nodiscard]] const Kept* view_of(const ViewOrder& order) const;
    [[nodiscard]] PagePlace place_of(const ViewOrder& order) const;
    [[nodiscard]] LoadJob next_step(const ViewOrder& order) const;
    [[nodiscard]] std::vector<ViewOrder> likely_next() const;
    [[nodiscard]] std::optional<LoadJob> next_job();
    [[nodiscard]] std::optional<LoadJob> background_job();
    [[nodiscard]] std::optional<LoadJob> untried(LoadJob job);
    [[nodiscard]] bool is_running(const LoadJob& job) const;
    [[nodiscard]] bool is_looking() const;
    [[nodiscard]] bool is_waited_for(const LoadJob& job) const;
    void stay_with_felt();
    std::optional<Delivery> refuse(const LoadJob& job, const Error& error);
    std::optional<Delivery> answer(const LoadJob& job, Result<LoadedScene> scene);
    void keep(Kept kept);
    [[nodiscard]] std::optional<LoadJob> look_job();
    std::optional<Delivery> keep_thing_at(const LoadJob& job, const Result<PagePtr>& page);
    void keep_things(const LoadJob& job, const Result<PagePtr>& page);
    void renumber(const Kept& page);
    [[nodiscard]] static bool are_of_one_page(const Kept& one, const Kept& other);
    [[nodiscard]] static bool is_numbered_as(const Kept& view, const Kept& page);
    [[nodiscard]] bool is_of_known_page(const LoadJob& job) const;
    void drop_aside();
    void keep_aside();
    void settle(const LoadJob& job);
    void keep_reread(const LoadJob& job, const FoundPtr& found);
    void forget_old();

    SecondLooks looks_;
    PlanLimits limits_;
    std::uint64_t last_number_ = 0;
    std::uint64_t forgotten_number_ = 0;  // jobs up to this number are ignored
    std::optional<ViewOrder> wanted_;
    std::uint64_t request_ = 0;
    std::optional<ViewOrder> felt_;  // by the last request with a result
    std::uint64_t felt_request_ = 0;
    bool is_owed_ = false;       // an answer, or an improved one
    bool is_felt_ = false;       // the request has its first answer
    std::optional<Kept> aside_;  // holds a wanted thing that nobody has felt yet
    std::optional<ThingsFound> things_;
    std::vector<Step> tried_;  // in the background, since the request
    std::vector<LoadJob> running_;
    KeptList kept_;  // the last used first
};

}  // namespace touchline
