#include "app/kiosk/stick_packs.h"

#include "app/sticks/names.h"

#include <chrono>
#include <exception>
#include <filesystem>
#include <utility>

namespace touchline {

StickPacks::StickPacks(const std::string& import_program)
    : import_(std::make_shared<Import>(import_program)) {}

void StickPacks::look_at(const std::string& root) {
    if (root == root_) return;
    root_ = root;
    packs_.clear();
    names_.clear();
    is_due_ = !root.empty();
}

/// Memory can run out anywhere; the kiosk goes on.
StickPacks::Listed StickPacks::list(const std::shared_ptr<Import>& import,
                                    const std::string& root) {
    try {
        const std::lock_guard lock(import->mutex);
        return {root, import->import.list_packs(root)};
    } catch (const std::exception&) {
        return {root, tl::unexpected(StickRefusal::unreadable)};
    }
}

/// A list of a stick that is gone by now, or that came again since, is dropped.
std::string StickPacks::take(Listed listed) {
    if (listed.root != root_ || is_due_) return {};
    if (!listed.listing) return sentence_of(listed.listing.error(), "");
    packs_ = std::move(listed.listing->entries);
    for (const StickEntry& pack : packs_)
        names_.push_back(shown_name(std::filesystem::path(pack.name).stem().string()));
    return {};
}

std::string StickPacks::poll() {
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

std::function<Result<Mapping, StickRefusal>()> StickPacks::reader_of(std::size_t pack) const {
    return [import = import_, root = root_,
            entry = packs_.at(pack)]() -> Result<Mapping, StickRefusal> {
        const std::lock_guard lock(import->mutex);
        const auto memory = import->import.read(root, entry);
        if (!memory) return tl::unexpected(memory.error());
        auto mapped = map_sealed(*memory, most_bytes_of(entry.kind));
        if (!mapped) return tl::unexpected(StickRefusal::unreadable);
        return std::move(*mapped);
    };
}

}  // namespace touchline
