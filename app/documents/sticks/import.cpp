#include "app/documents/sticks/import.h"

#include "app/documents/decode/files.h"
#include "app/documents/decode/opening.h"
#include "app/isolation/process/memory.h"
#include "app/isolation/sandbox/limits.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <utility>

namespace touchline {
namespace {

using Refused = tl::unexpected<StickRefusal>;

/// After SIGKILL. It takes longer only if the kernel itself waits for the stick.
constexpr double killed_s = 0.5;

constexpr std::size_t most_network_bytes = std::size_t{64} << 20U;

bool is_for_operator(StickFileKind kind) {
    return kind >= StickFileKind::pack;
}

StickRefusal refusal_of_end(const ChildEnd& end) {
    if (end.signal == SIGKILL) return StickRefusal::out_of_memory;  // not ours: the kernel's
    const int refusal = end.status - first_refusal_status;
    if (end.signal == 0 && refusal >= 0 && refusal < stick_refusal_count)
        return static_cast<StickRefusal>(refusal);
    return end.status == 127 ? StickRefusal::not_started : StickRefusal::unreadable;
}

}  // namespace

std::size_t most_bytes_of(StickFileKind kind) {
    switch (kind) {
        case StickFileKind::picture:
            return limits_of(WorkerKind::raster).input_bytes;
        case StickFileKind::pack:
            return limits_of(WorkerKind::pack).input_bytes;
        case StickFileKind::network:
            return most_network_bytes;
        case StickFileKind::bundle:
            return max_file_bytes;
        case StickFileKind::house_key:
            return most_house_key_bytes;
        case StickFileKind::document:
        case StickFileKind::office:
            break;
    }
    return limits_of(WorkerKind::document).input_bytes;
}

StickImport::StickImport(std::string program, ImportDeadlines deadlines)
    : program_(std::move(program)), deadlines_(deadlines) {}

Result<StickListing, StickRefusal> StickImport::list(const std::string& root) {
    return listed({"list", root});
}

Result<StickListing, StickRefusal> StickImport::list_operator_files(const std::string& root) {
    auto files = listed({"operator", root});
    if (files)
        std::erase_if(files->entries, [](const StickEntry& entry) {
            return !is_for_operator(entry.kind) || !entry.folder.empty();
        });
    return files;
}

Result<StickListing, StickRefusal> StickImport::listed(const std::vector<std::string>& words) {
    const auto answer = run(words, deadlines_.list_s);
    if (!answer) return Refused(answer.error());
    const auto mapping = map_sealed(*answer, most_listing_bytes);
    if (!mapping) return Refused(StickRefusal::unreadable);
    auto listing = listing_of(mapping->bytes());
    if (!listing) return Refused(StickRefusal::unreadable);
    return std::move(*listing);
}

Result<Descriptor, StickRefusal> StickImport::read(const std::string& root,
                                                   const StickEntry& entry) {
    return copy(root, entry, entry.name, most_bytes_of(entry.kind));
}

Result<Descriptor, StickRefusal> StickImport::read_side_car(const std::string& root,
                                                            const StickEntry& entry) {
    return copy(root, entry, side_car_of(entry.name), max_side_car_bytes);
}

Result<Descriptor, StickRefusal> StickImport::copy(const std::string& root, const StickEntry& entry,
                                                   const std::string& name,
                                                   std::size_t most_bytes) {
    return run({"read", root, entry.folder, name, std::to_string(most_bytes)}, deadlines_.read_s);
}

Result<Descriptor, StickRefusal> StickImport::run(const std::vector<std::string>& words,
                                                  double deadline_s) {
    reap_dead();
    auto output = fresh_memory();
    if (!output) return Refused(StickRefusal::not_started);
    const std::array<const Descriptor*, 1> handed{&*output};
    auto child = Child::start(program_, words, handed, StandardStreams::nothing);
    if (!child) return Refused(StickRefusal::not_started);
    if (!child->ends_within(deadline_s)) {
        child->kill();
        if (child->ends_within(killed_s)) {
            (void)child->reap();
        } else {
            left_behind_.push_back(std::move(*child));
        }
        return Refused(StickRefusal::out_of_time);
    }
    const ChildEnd end = child->reap();
    if (!end.is_good()) return Refused(refusal_of_end(end));
    // Only now: while the child lived, it could have mapped the memory for writing.
    if (is_empty(*output) || !seal(*output)) return Refused(StickRefusal::unreadable);
    return std::move(*output);
}

void StickImport::reap_dead() {
    const auto alive = std::partition(left_behind_.begin(), left_behind_.end(),
                                      [](const Child& child) { return !child.ends_within(0); });
    for (auto dead = alive; dead != left_behind_.end(); ++dead) (void)dead->reap();
    left_behind_.erase(alive, left_behind_.end());
}

}  // namespace touchline
