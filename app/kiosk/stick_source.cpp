#include "app/kiosk/stick_source.h"

#include <chrono>
#include <exception>
#include <utility>

namespace touchline {

namespace {

/// Memory can run out anywhere; the visit goes on.
Result<StickListing, StickRefusal> listed(const std::shared_ptr<StickReader>& reader,
                                          const std::string& root) {
    try {
        return reader->list(root);
    } catch (const std::exception&) {
        return tl::unexpected(StickRefusal::unreadable);
    }
}

}  // namespace

StickSource::StickSource(std::unique_ptr<StickPort> port, const std::string& import_program)
    : port_(std::move(port)), reader_(std::make_shared<StickReader>(import_program)) {}

std::optional<FilesChange> StickSource::poll(std::int64_t now_ns) {
    std::optional<FilesChange> change;
    for (const StickEvent& event : port_->poll(now_ns))
        if (auto newer = take(event)) change = std::move(newer);
    if (listing_.valid() &&
        listing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        const Listed listed = listing_.get();
        if (!is_due_ && !root_.empty()) change = change_of(listed);
    }
    if (is_due_ && !listing_.valid()) {
        is_due_ = false;
        listing_ = std::async(std::launch::async, listed, reader_, root_);
    }
    return change;
}

std::optional<FilesChange> StickSource::take(const StickEvent& event) {
    reader_->forget();
    is_due_ = event.news == StickNews::ready;
    root_ = is_due_ ? event.root : std::string();
    if (is_due_) return std::nullopt;
    return FilesChange{{}, event.sentence, {}, false};
}

FilesChange StickSource::change_of(const Listed& listed) const {
    if (!listed) return {{}, sentence_of(listed.error(), ""), {}, false};
    return {files_of_stick(reader_, root_, *listed), "", listed->rest, true};
}

}  // namespace touchline
