#include "app/kiosk/loading/load_plan.h"

#include "app/documents/trace/page_views.h"

#include <algorithm>
#include <utility>

namespace touchline {

LoadPlan::LoadPlan(SecondLooks looks, PlanLimits limits) : looks_(looks), limits_(limits) {}

void LoadPlan::want(std::uint64_t request, const ViewOrder& order) {
    drop_aside();
    wanted_ = order;
    request_ = request;
    is_owed_ = true;
    is_felt_ = false;
    things_.reset();
    tried_.clear();
    std::ranges::stable_partition(kept_, [&order](const Kept& kept) {
        return is_page_of(kept, order) || is_view_of(kept, order);
    });
    forget_old();
}

void LoadPlan::cancel() {
    if (wanted_ && is_owed_ && !is_felt_) stay_with_felt();
}

void LoadPlan::stay_with_felt() {
    drop_aside();
    wanted_ = felt_;
    request_ = felt_request_;
    is_owed_ = false;
    is_felt_ = felt_.has_value();
    tried_.clear();
}

std::vector<LoadJob> LoadPlan::start() {
    std::vector<LoadJob> jobs;
    while (running_.size() < limits_.jobs) {
        auto job = next_job();
        if (!job) break;
        job->number = ++last_number_;
        running_.push_back(*job);
        jobs.push_back(std::move(*job));
    }
    return jobs;
}

std::optional<Delivery> LoadPlan::finish(std::uint64_t number, JobOutcome outcome) {
    const auto at = std::ranges::find_if(
        running_, [number](const LoadJob& job) { return job.number == number; });
    if (at == running_.end()) return std::nullopt;
    const LoadJob job = std::move(*at);
    running_.erase(at);
    if (number <= forgotten_number_) return std::nullopt;
    if (auto* const scene = std::get_if<Result<LoadedScene>>(&outcome))
        return answer(job, std::move(*scene));
    if (const auto* const page = std::get_if<Result<PagePtr>>(&outcome)) {
        if (job.kind == JobKind::look) {
            keep_things(job, *page);
            return std::nullopt;
        }
        if (job.kind == JobKind::look_at) return keep_thing_at(job, *page);
        if (!*page) return refuse(job, page->error());
        keep({job.order.file, job.order.page, **page, nullptr});
        return std::nullopt;
    }
    const auto& found = std::get<Result<FoundPtr>>(outcome);
    if (!found) return refuse(job, found.error());
    if (job.kind == JobKind::reread) {
        keep_reread(job, *found);
    } else if (is_of_known_page(job)) {
        keep({job.order.file, job.order.page, nullptr, *found});
    }
    return std::nullopt;
}

void LoadPlan::forget() {
    wanted_.reset();
    felt_.reset();
    aside_.reset();
    is_owed_ = false;
    things_.reset();
    tried_.clear();
    kept_.clear();
    forgotten_number_ = last_number_;
}

std::size_t LoadPlan::kept_bytes() const {
    std::size_t bytes = 0;
    for (const Kept& kept : kept_) bytes += kept.page ? bytes_of(*kept.page) : kept.found->bytes;
    return bytes;
}

LoadPlan::Step LoadPlan::step_of(const LoadJob& job) {
    const bool is_of_page = job.kind == JobKind::open || is_look(job.kind);
    return {job.kind, job.order.file, job.order.page, is_of_page ? 0 : job.order.view};
}

bool LoadPlan::is_page_of(const Kept& kept, const ViewOrder& order) {
    return kept.page && kept.file == order.file && kept.number == order.page;
}

bool LoadPlan::is_view_of(const Kept& kept, const ViewOrder& order) {
    if (!kept.found || kept.file != order.file || kept.number != order.page) return false;
    const PagePlace& place = kept.found->place;
    return place.view == std::min(order.view, place.view_count);
}

const LoadPlan::Kept* LoadPlan::page_of(const ViewOrder& order) const {
    if (aside_ && is_page_of(*aside_, order)) return &*aside_;
    const auto at =
        std::ranges::find_if(kept_, [&](const Kept& kept) { return is_page_of(kept, order); });
    return at == kept_.end() ? nullptr : &*at;
}

const LoadPlan::Kept* LoadPlan::view_of(const ViewOrder& order) const {
    // While a page is aside, its other views still have their old numbers.
    const bool is_aside = aside_ && is_page_of(*aside_, order);
    const auto at = std::ranges::find_if(kept_, [&](const Kept& kept) {
        return is_view_of(kept, order) && (!is_aside || is_numbered_as(kept, *aside_));
    });
    return at == kept_.end() ? nullptr : &*at;
}

bool LoadPlan::are_of_one_page(const Kept& one, const Kept& other) {
    return one.file == other.file && one.number == other.number;
}

bool LoadPlan::is_numbered_as(const Kept& view, const Kept& page) {
    return view.found && are_of_one_page(view, page) &&
           view.found->place.view_count == view_count(*page.page);
}

/// True if the lines belong to the newest version of the page.
bool LoadPlan::is_of_known_page(const LoadJob& job) const {
    const Kept* const page = page_of(job.order);
    return page == nullptr || page->page == job.page;
}

/// Drops the page that is aside, because nothing of it was felt.
void LoadPlan::drop_aside() {
    if (!aside_) return;
    kept_.remove_if([this](const Kept& kept) { return is_numbered_as(kept, *aside_); });
    aside_.reset();
}

/// Keeps the page that is aside once it is felt, and renumbers its views.
void LoadPlan::keep_aside() {
    if (!aside_) return;
    const Kept further = std::move(*aside_);
    aside_.reset();
    kept_.remove_if(
        [&further](const Kept& kept) { return kept.page && are_of_one_page(kept, further); });
    kept_.push_front(further);
    renumber(further);
}

PagePlace LoadPlan::place_of(const ViewOrder& order) const {
    if (const Kept* const view = view_of(order)) return view->found->place;
    const Kept* const page = page_of(order);
    if (page == nullptr) return {order.page, 0, order.view, 0};
    PagePlace place = touchline::place_of(*page->page, order.view);
    place.page = order.page;
    return place;
}

/// The next job on the way to an order's scene, from what is kept.
LoadJob LoadPlan::next_step(const ViewOrder& order) const {
    LoadJob job;
    job.order = order;
    const Kept* const page = page_of(order);
    const Kept* const view = order.thing_at ? nullptr : view_of(order);
    if (view != nullptr) {
        job.kind = JobKind::build;
        job.request = request_;
        job.found = view->found;
        job.order.view = view->found->place.view;
    } else if (page != nullptr) {
        job.kind = order.thing_at ? JobKind::look_at : JobKind::find;
        job.request = order.thing_at ? request_ : 0;
        job.page = page->page;
        job.order.view = std::min(order.view, view_count(*page->page));
    }
    return job;
}

std::vector<ViewOrder> LoadPlan::likely_next() const {
    const PagePlace place = place_of(*wanted_);
    const auto order = [this](int page, int view) {
        return ViewOrder{wanted_->file, page, view, {wanted_->part.detail}};
    };
    std::vector<ViewOrder> orders;
    if (place.view < place.view_count) orders.push_back(order(place.page, place.view + 1));
    if (place.things == ThingSearch::found && place.view == place.view_count)
        orders.push_back(order(place.page, 1));
    if (place.page < place.page_count) orders.push_back(order(place.page + 1, 1));
    return orders;
}

std::optional<LoadJob> LoadPlan::next_job() {
    if (!wanted_) return std::nullopt;
    if (is_owed_) {
        LoadJob job = next_step(*wanted_);
        const bool is_waiting = is_running(job) || (job.kind == JobKind::look_at && is_looking());
        return is_waiting ? std::nullopt : std::optional(std::move(job));
    }
    // Runs one background job at a time, so that what is wanted next finds a free place.
    return running_.empty() ? background_job() : std::nullopt;
}

/// Looks at a photograph that is felt as a whole and was not looked at yet.
std::optional<LoadJob> LoadPlan::look_job() {
    if (!looks_.for_things || !is_felt_) return std::nullopt;
    const Kept* const view = view_of(*wanted_);
    const Kept* const page = page_of(*wanted_);
    if (view == nullptr || !view->found->is_photo || page == nullptr || page->looked_for)
        return std::nullopt;
    LoadJob job;
    job.kind = JobKind::look;
    job.order = *wanted_;
    job.page = page->page;
    return untried(std::move(job));
}

std::optional<LoadJob> LoadPlan::background_job() {
    if (auto look = look_job()) return look;
    for (const ViewOrder& order : likely_next()) {
        LoadJob job = next_step(order);
        if (job.kind == JobKind::build) continue;
        if (auto first = untried(std::move(job))) return first;
    }
    const Kept* const present = view_of(*wanted_);
    if (!looks_.for_words || !is_felt_ || present == nullptr || present->is_reread)
        return std::nullopt;
    LoadJob job = next_step(*wanted_);
    job.kind = JobKind::reread;
    job.request = 0;
    return untried(std::move(job));
}

std::optional<LoadJob> LoadPlan::untried(LoadJob job) {
    const Step step = step_of(job);
    if (std::ranges::find(tried_, step) != tried_.end()) return std::nullopt;
    tried_.push_back(step);
    return job;
}

/// Only one network runs at a time.
bool LoadPlan::is_looking() const {
    return std::ranges::any_of(running_, [](const LoadJob& job) { return is_look(job.kind); });
}

bool LoadPlan::is_running(const LoadJob& job) const {
    return std::ranges::any_of(running_, [&job](const LoadJob& other) {
        return step_of(other) == step_of(job) && other.request == job.request;
    });
}

/// True if the job is the next step of what is wanted, even if it began in the background.
bool LoadPlan::is_waited_for(const LoadJob& job) const {
    return wanted_ && is_owed_ && step_of(next_step(*wanted_)) == step_of(job);
}

std::optional<Delivery> LoadPlan::refuse(const LoadJob& job, const Error& error) {
    if (!is_waited_for(job)) return std::nullopt;
    is_owed_ = false;
    Delivery refused{request_, tl::unexpected(error), place_of(*wanted_)};
    if (!is_felt_) stay_with_felt();
    return refused;
}

std::optional<Delivery> LoadPlan::answer(const LoadJob& job, Result<LoadedScene> scene) {
    if (!wanted_ || job.request != request_) return std::nullopt;
    const Kept* const present = view_of(*wanted_);
    const bool is_newest = present == nullptr || present->found == job.found;
    const bool was_felt = is_felt_;
    if (is_newest || !scene) is_owed_ = false;
    if (!scene && was_felt) return std::nullopt;
    is_felt_ = scene.has_value();
    if (is_felt_) settle(job);
    const Kept* const page = page_of(*wanted_);
    if (scene && page != nullptr && page->looked_for &&
        scene->facts.place.things == ThingSearch::under_way)
        scene->facts.place.things = *page->looked_for;
    if (scene && page != nullptr)
        scene->facts.names = names_told(*page->page, job.found->place.view);
    Delivery answered{request_, std::move(scene), job.found->place, was_felt};
    if (!is_felt_) stay_with_felt();
    return answered;
}

/// What was wanted is felt now.
void LoadPlan::settle(const LoadJob& job) {
    felt_ = wanted_;
    felt_request_ = request_;
    keep_aside();
    const bool is_before_look = std::ranges::any_of(
        kept_, [&job](const Kept& kept) { return kept.found == job.found && kept.is_before_look; });
    if (!is_before_look) kept_.remove_if([](const Kept& kept) { return kept.is_before_look; });
}

void LoadPlan::keep(Kept kept) {
    kept_.push_front(std::move(kept));
    forget_old();
}

/// The page has further things, before the whole. The whole stays as it is felt until another view
/// is felt.
void LoadPlan::renumber(const Kept& page) {
    const int views = view_count(*page.page);
    for (Kept& kept : kept_) {
        const bool is_view_of_it = kept.found && are_of_one_page(kept, page);
        if (!is_view_of_it || is_numbered_as(kept, page)) continue;
        FoundView view = *kept.found;
        const bool is_whole = view.place.view == view.place.view_count;
        if (is_whole) view.place.view = views;
        view.place.view_count = views;
        view.place.things = ThingSearch::found;
        view.is_photo = false;
        kept.found = std::make_shared<const FoundView>(std::move(view));
        kept.is_before_look = kept.is_before_look || is_whole;
    }
}

/// If nobody waits for it any more, the page stays as it was. Otherwise the page with the thing is
/// kept aside until the thing is felt.
std::optional<Delivery> LoadPlan::keep_thing_at(const LoadJob& job, const Result<PagePtr>& page) {
    if (!wanted_ || job.request != request_ || !is_owed_) return std::nullopt;
    if (!page) return refuse(job, page.error());
    if (*page == nullptr) return refuse(job, Error{std::string(nothing_there)});
    aside_ = Kept{job.order.file, job.order.page, *page, nullptr};
    aside_->looked_for = ThingSearch::found;
    wanted_->view = view_count(**page) - 1;
    wanted_->thing_at.reset();
    return std::nullopt;
}

void LoadPlan::keep_things(const LoadJob& job, const Result<PagePtr>& page) {
    const auto at =
        std::ranges::find_if(kept_, [&job](const Kept& kept) { return kept.page == job.page; });
    if (at == kept_.end()) return;
    const bool is_in_use =
        wanted_ && (is_page_of(*at, *wanted_) || (felt_ && is_page_of(*at, *felt_)));
    if (is_owed_ && is_in_use) {  // views are not renumbered while an order is under way
        std::erase(tried_, step_of(job));
        return;
    }
    const bool has_things = page && has_main_things(**page);
    at->looked_for = has_things              ? ThingSearch::found
                     : !page                 ? ThingSearch::impossible
                     : (*page)->was_searched ? ThingSearch::unclear
                                             : ThingSearch::absent;
    if (page && (has_things || !(*page)->names.empty())) at->page = *page;
    if (has_things) renumber(*at);
    const bool is_felt = wanted_ && is_felt_ && is_page_of(*at, *wanted_);
    if (!is_felt) return;
    if (has_things) wanted_->view = view_count(**page);
    felt_ = wanted_;
    things_ = ThingsFound{request_, place_of(*wanted_),
                          page ? names_told(**page, wanted_->view) : std::vector<NamedThing>(),
                          page ? "" : page.error().line};
    things_->place.things = *at->looked_for;
}

void LoadPlan::keep_reread(const LoadJob& job, const FoundPtr& found) {
    for (Kept& kept : kept_) {
        if (kept.found != job.found) continue;
        kept.is_reread = true;
        if (found == nullptr) continue;
        kept.found = found;
        if (wanted_ && is_felt_ && is_view_of(kept, *wanted_)) is_owed_ = true;
    }
    forget_old();
}

/// Keeps the present page and view, however large they are.
void LoadPlan::forget_old() {
    for (auto at = kept_.end(); at != kept_.begin() && kept_bytes() > limits_.kept_bytes;) {
        --at;
        const bool is_present = wanted_ && (is_page_of(*at, *wanted_) || is_view_of(*at, *wanted_));
        if (!is_present) at = kept_.erase(at);
    }
}

}  // namespace touchline
