#include "app/kiosk/ordered_picture.h"

#include "app/session/told_lines.h"

namespace touchline {
namespace {

/// True if the order is for another part or detail of what the visitor brought.
bool is_of_same_file(const LoadPicture& order, const Visitor& visitor) {
    const auto& loading = visitor.loading;
    return loading && loading->order.request == order.request &&
           loading->reason != LoadReason::other_picture &&
           (order.source == PictureSource::stick || order.source == PictureSource::camera);
}

/// Removes the file's name, which begins every line about it, tells nothing and may hold anything.
std::string told_reason(const std::string& line, const std::string& name,
                        const Language& language) {
    return told_of_file(line.starts_with(name) ? line.substr(name.size()) : line, picture_trouble,
                        language);
}

}  // namespace

std::optional<PictureFailed> OrderedPicture::want(const LoadPicture& order, const Visitor& visitor,
                                                  const FilePtr& listed, const Language& language) {
    order_ = order;
    const FilePtr& file = is_of_same_file(order, visitor) && felt_file_ ? felt_file_ : listed;
    if (file == nullptr)
        return PictureFailed{order.request,
                             language.text("kiosk", "This picture is gone. Choose another one.")};
    wanted_ = file;
    is_loading_ = true;
    const Zoom zoom{order.zoom.centre, order.zoom.factor};
    loader_->want(order.request,
                  {file, order.page, order.view, {order.detail, zoom}, order.thing_at});
    return std::nullopt;
}

void OrderedPicture::cancel() {
    loader_->cancel();
    stay_with_felt();
}

void OrderedPicture::stay_with_felt() {
    is_loading_ = false;
    order_ = felt_order_;
    wanted_ = felt_file_;
}

std::optional<PictureNews> OrderedPicture::take(const Delivery& delivery,
                                                const Language& language) {
    if (delivery.request != order_.request || !wanted_) return std::nullopt;
    if (!delivery.scene) return refuse(delivery, language);
    if (!std::exchange(is_loading_, false) && !delivery.is_better) return std::nullopt;
    shown_ = delivery.scene->shown;
    map_ = delivery.scene->felt.map;
    felt_file_ = wanted_;
    felt_order_ = order_;
    PictureFacts facts = facts_of(*delivery.scene, *wanted_, order_.form, language);
    parts_ = facts.parts;
    return PictureNews{PictureReady{delivery.request, std::move(facts)}, delivery.scene->felt,
                       delivery.is_better};
}

PictureNews OrderedPicture::refuse(const Delivery& delivery, const Language& language) {
    const std::string& line = delivery.scene.error().line;
    const bool is_answer = line == nothing_there;
    const std::string sentence =
        order_.thing_at
            ? language.text("trouble",
                            is_answer ? line : "The main thing cannot be looked for now.")
            : told_reason(line, wanted_->name, language);
    PictureNews news{PictureFailed{delivery.request, sentence}};
    if (!is_answer) news.line = wanted_->is_private ? "a visitor's picture cannot be felt" : line;
    stay_with_felt();
    return news;
}

std::optional<std::size_t> OrderedPicture::part_at(const HandState& hand) const {
    if (!map_) return std::nullopt;
    return touchline::part_at(*map_, parts_, hand);
}

void OrderedPicture::forget() {
    loader_->forget();
    is_loading_ = false;
    wanted_.reset();
    felt_file_.reset();
    shown_ = {};
    map_.reset();
    parts_.clear();
    order_ = {};
    felt_order_ = {};
}

}  // namespace touchline
