#include "app/kiosk/operator_stick.h"

#include "app/sticks/names.h"

#include <chrono>
#include <exception>
#include <filesystem>
#include <utility>

namespace touchline {

OperatorStick::OperatorStick(const std::string& import_program)
    : import_(std::make_shared<Import>(import_program)) {}

void OperatorStick::look_at(const std::string& root) {
    if (root == root_) return;
    root_ = root;
    files_.clear();
    names_.clear();
    is_due_ = !root.empty();
}

/// Memory can run out anywhere; the kiosk goes on.
OperatorStick::Listed OperatorStick::list(const std::shared_ptr<Import>& import,
                                          const std::string& root) {
    try {
        const std::lock_guard lock(import->mutex);
        return {root, import->import.list_operator_files(root)};
    } catch (const std::exception&) {
        return {root, tl::unexpected(StickRefusal::unreadable)};
    }
}

/// Drops a list of a stick that is gone by now, or that was plugged in again since.
std::string OperatorStick::take(Listed listed) {
    if (listed.root != root_ || is_due_) return {};
    if (!listed.listing) return sentence_of(listed.listing.error(), "");
    files_ = std::move(listed.listing->entries);
    for (const StickEntry& file : files_)
        names_.push_back(shown_name(std::filesystem::path(file.name).stem().string()));
    return {};
}

std::string OperatorStick::poll() {
    std::string sentence;
    const bool has_ended =
        listing_.valid() && listing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (has_ended) sentence = take(listing_.get());
    if (is_due_ && !listing_.valid()) {
        is_due_ = false;
        listing_ = std::async(std::launch::async, list, import_, root_);
    }
    return sentence;
}

std::function<Result<Mapping, StickRefusal>()> OperatorStick::reader_of(std::size_t file) const {
    return [import = import_, root = root_,
            entry = files_.at(file)]() -> Result<Mapping, StickRefusal> {
        const std::lock_guard lock(import->mutex);
        const auto memory = import->import.read(root, entry);
        if (!memory) return tl::unexpected(memory.error());
        auto mapped = map_sealed(*memory, most_bytes_of(entry.kind));
        if (!mapped) return tl::unexpected(StickRefusal::unreadable);
        return std::move(*mapped);
    };
}

}  // namespace touchline
