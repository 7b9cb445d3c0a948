// Made-up documents (how many pages, which views, what fails) whose stages count everything that is
// done, and a loader, its jobs, which wait for the test, and everything that it delivered.
// Threads: the stages any, all else one.
#pragma once

#include "app/documents/trace/page_views.h"
#include "app/kiosk/loading/loader.h"
#include "app/kiosk/loading/stages.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

struct MadeUpDocument {
    std::vector<int> figures = {};  // for each page
    int page_px = 4;
    std::set<int> torn_pages = {};
    std::set<std::pair<int, int>> empty_views = {};  // page, view
    std::map<int, int> photos = {};  // main things by page; -1: cannot look; -2: a photo of people
                                     // only
};

class MadeUpStages final : public Stages {
  public:
    /// `with_words`: pages and views whose words can be read; none: nothing reads.
    using Places = std::set<std::pair<int, int>>;

    explicit MadeUpStages(std::vector<MadeUpDocument> documents,
                          std::optional<Places> with_words = {}, bool finds_things = false)
        : with_words_(std::move(with_words)), finds_things_(finds_things) {
        for (MadeUpDocument& document : documents) {
            files_.push_back(std::make_shared<const PictureFile>(
                PictureFile{std::to_string(files_.size()), "", "", false, {}}));
            documents_.emplace(files_.back().get(), std::move(document));
        }
    }

    [[nodiscard]] const std::vector<FilePtr>& files() const { return files_; }

    [[nodiscard]] const MadeUpDocument& document(const FilePtr& file) const {
        return documents_.at(file.get());
    }

    [[nodiscard]] Result<PagePtr> open(const PictureFile& file, int number) const override {
        ++opened;
        const MadeUpDocument& document = documents_.at(&file);
        if (document.torn_pages.contains(number)) return failure("torn page");
        Page page;
        page.picture = {document.page_px, document.page_px, {}, 1.0};
        page.picture.bgr.resize(3U * static_cast<std::size_t>(document.page_px * document.page_px));
        const auto figures = document.figures.at(static_cast<std::size_t>(number - 1));
        page.figures.resize(static_cast<std::size_t>(figures), {{0, 0, 2, 2}, ""});
        page.number = number;
        page.count = static_cast<int>(document.figures.size());
        return std::make_shared<const Page>(std::move(page));
    }

    [[nodiscard]] Result<FoundPtr> find(const PictureFile& file, const PagePtr& page, int view,
                                        const FeltPart&) const override {
        ++found;
        if (documents_.at(&file).empty_views.contains({page->number, view}))
            return failure("empty view");
        FoundView result;
        result.view = page;
        result.place = {page->number, page->count, view, view_count(*page)};
        result.is_photo =
            documents_.at(&file).photos.contains(page->number) && page->main_things.grey.empty();
        if (!page->main_things.grey.empty()) result.place.things = ThingSearch::found;
        result.bytes = page->picture.bgr.size();
        return std::make_shared<const FoundView>(std::move(result));
    }

    /// The title names file, page, view and detail; a '+' means that words were read.
    [[nodiscard]] Result<LoadedScene> build(const PictureFile& file, const FoundView& view,
                                            const FeltPart& part) const override {
        ++built;
        LoadedScene scene;
        scene.facts.title = title(file.name, view.place.page, view.place.view, part.detail) +
                            (view.view->words.empty() ? "" : "+");
        scene.facts.place = view.place;
        if (view.is_photo) scene.facts.place.things = ThingSearch::under_way;
        return scene;
    }

    static std::string title(const std::string& file, int page, int view, int detail) {
        return file + " " + std::to_string(page) + " " + std::to_string(view) + " " +
               std::to_string(detail);
    }

    [[nodiscard]] bool has_looking() const override { return finds_things_; }

    /// Only the first document has photographs.
    [[nodiscard]] Result<PagePtr> look(const PagePtr& page) const override {
        ++looked_count;
        const int things = document(files_.front()).photos.at(page->number);
        if (things == -1) return failure("no memory");
        Page seen = *page;
        seen.names = {{ThingName::dog, {0.0, 0.0, 1.0, 1.0}, 0.9}};
        seen.was_searched = things >= 0;
        if (things <= 0) return std::make_shared<const Page>(std::move(seen));
        seen.figures.resize(static_cast<std::size_t>(things), {{0, 0, 2, 2}, ""});
        seen.main_things = {1, 1, {255}};
        return std::make_shared<const Page>(std::move(seen));
    }

    /// There is a thing to the left of the middle and nothing to the right; far up, looking fails.
    [[nodiscard]] Result<PagePtr> look_at(const PagePtr& page, int,
                                          const Position& place) const override {
        ++looked_at_count;
        if (place.y > 0.03) return failure("no memory");
        if (place.x > 0.0) return PagePtr();
        Page seen = *page;
        seen.figures.push_back({{0, 0, 2, 2}, ""});
        seen.main_things = {1, 1, {255}};
        return std::make_shared<const Page>(std::move(seen));
    }

    [[nodiscard]] bool has_reading() const override { return with_words_.has_value(); }

    [[nodiscard]] FoundPtr reread(const FoundView& view) const override {
        ++reread_count;
        if (!with_words_->contains({view.place.page, view.place.view})) return nullptr;
        FoundView better = view;
        Page page = *view.view;
        page.words.push_back({0, 0, 1, 1});
        better.view = std::make_shared<const Page>(std::move(page));
        return std::make_shared<const FoundView>(std::move(better));
    }

    mutable std::atomic<int> opened{0};
    mutable std::atomic<int> found{0};
    mutable std::atomic<int> built{0};
    mutable std::atomic<int> looked_count{0};
    mutable std::atomic<int> looked_at_count{0};
    mutable std::atomic<int> reread_count{0};

  private:
    std::optional<Places> with_words_;
    bool finds_things_;
    std::vector<FilePtr> files_;
    std::map<const PictureFile*, MadeUpDocument> documents_;
};

/// Jobs wait until the test ends them.
class HeldJobs final : public Executor {
  public:
    void start(std::uint64_t number, std::function<JobOutcome()> work) override {
        held_.emplace_back(number, std::move(work));
        most_at_once = std::max(most_at_once, held_.size());
    }

    std::vector<FinishedJob> take_finished() override { return std::exchange(finished_, {}); }

    [[nodiscard]] std::size_t held() const { return held_.size(); }

    void end(std::size_t which) {
        const auto at = held_.begin() + static_cast<std::ptrdiff_t>(which);
        finished_.push_back({at->first, at->second()});
        held_.erase(at);
    }

    std::size_t most_at_once = 0;

  private:
    std::vector<std::pair<std::uint64_t, std::function<JobOutcome()>>> held_;
    std::vector<FinishedJob> finished_;
};

/// A loader, its jobs and everything that it delivered.
struct World {
    explicit World(std::vector<MadeUpDocument> documents,
                   std::optional<MadeUpStages::Places> with_words = {}, PlanLimits limits = {},
                   bool finds_things = false)
        : stages(std::make_shared<MadeUpStages>(std::move(documents), std::move(with_words),
                                                finds_things)),
          jobs(new HeldJobs),
          loader(stages, std::unique_ptr<Executor>(jobs), limits) {}

    void want(int page, int view, int detail = 3, std::size_t file = 0) {
        loader.want(++request, {stages->files().at(file), page, view, {detail}});
    }

    /// Asks for the thing at a place of a view.
    void want_thing(int view, const Position& place) {
        loader.want(++request, {stages->files().at(0), 1, view, {3}, place});
    }

    void end(std::size_t which = 0) {
        jobs->end(which);
        poll();
    }

    void poll() {
        for (Delivery& delivery : loader.poll()) delivered.push_back(std::move(delivery));
    }

    /// Ends jobs until the last request has an answer. Background work goes on.
    void until_felt() {
        const std::size_t before = delivered.size();
        while (delivered.size() == before && jobs->held() > 0) end(jobs->held() - 1);
    }

    void until_idle() {
        poll();
        while (jobs->held() > 0) end();
    }

    [[nodiscard]] std::string last() const {
        if (delivered.empty()) return "nothing";
        const auto& scene = delivered.back().scene;
        return scene ? scene->facts.title : scene.error().line;
    }

    std::shared_ptr<MadeUpStages> stages;
    HeldJobs* jobs;
    Loader loader;
    std::uint64_t request = 0;
    std::vector<Delivery> delivered;
};

inline MadeUpDocument three_pages() {
    return {.figures = {2, 0, 1}};
}

}  // namespace touchline
