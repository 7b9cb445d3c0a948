#include "app/documents/sticks/mount_rules.h"

#include <algorithm>
#include <tuple>

namespace touchline {
namespace {

/// Per stick; nobody brings a table with hundreds of partitions in good faith.
constexpr std::size_t most_tries = 4;

bool is_visitors(const Volume& volume) {
    return (volume.bus == "usb" || volume.bus == "sdio") && !volume.is_of_system &&
           !volume.drive.empty() && volume.bytes > 0;
}

/// True if a visitor would expect something on it to be read.
bool is_promising(const Volume& volume) {
    // Our own rules ignore what is never mounted. A volume that other rules ignore is not for
    // visitors.
    if (volume.is_ignored && mount_options(volume.file_system, FileSystems::more)) return false;
    return is_visitors(volume) && !volume.is_partitioned && volume.usage != "other" &&
           volume.usage != "raid";
}

/// "sdb2" before "sdb10".
auto place_of(const Volume& volume) {
    return std::tuple(volume.object.size(), volume.object);
}

/// True if `a` is on a newer stick, or is an earlier volume of the same stick.
bool is_better(const Volume& a, const Volume& b) {
    if (a.detected_us != b.detected_us) return a.detected_us > b.detected_us;
    if (a.drive != b.drive) return a.drive > b.drive;
    return place_of(a) < place_of(b);
}

}  // namespace

StickStep MountRules::on_volumes(std::vector<Volume> all) {
    all_ = std::move(all);
    if (coming_ && (find(coming_->first) == nullptr || is_mounted(*coming_))) coming_.reset();
    if (leaving_ && !is_mounted(*leaving_)) leaving_.reset();
    apply_answers();
    forget_absent();
    if (std::exchange(is_first_, false)) begin_anew();
    return decide();
}

StickStep MountRules::on_vanished(const std::string& object) {
    std::erase_if(all_, [&object](const Volume& volume) { return volume.object == object; });
    if (order_ && order_->object == object) order_.reset();
    if (coming_ && coming_->first == object) coming_.reset();
    forget_absent();
    return decide();
}

void MountRules::on_mounted(std::uint64_t number, const std::string& object,
                            const std::string& root) {
    ours_.emplace(object, root);
    if (!order_ || order_->number != number) return;  // the volumes will show what happened to it
    order_.reset();
    coming_.emplace(object, root);
    apply_answers();
}

void MountRules::on_mount_failed(std::uint64_t number, bool is_mounted_already) {
    if (!order_ || order_->number != number) return;
    const Volume* const volume = find(order_->object);
    if (!is_mounted_already && volume != nullptr) spent_.emplace(volume->object, volume->drive);
    order_.reset();
}

void MountRules::on_unmounted(std::uint64_t number, bool is_done) {
    if (!order_ || order_->number != number) return;
    std::erase_if(ours_, [this, is_done](const Mount& mount) {
        if (mount.first != order_->object) return false;
        if (is_done) leaving_ = mount;
        return true;
    });
    order_.reset();
    apply_answers();
}

StickStep MountRules::on_session_ended() {
    offer_.reset();  // nobody is there to be told
    for (const Volume& volume : all_) spent_.emplace(volume.object, volume.drive);
    for (const Volume& volume : all_) told_.insert(volume.drive);
    return decide();
}

void MountRules::on_service_lost() {
    if (order_ && order_->kind == OrderKind::mount) unknown_ = order_->object;
    order_.reset();
    coming_.reset();
    leaving_.reset();
    is_first_ = true;
}

const Volume* MountRules::find(const std::string& object) const {
    const auto found = std::ranges::find(all_, object, &Volume::object);
    return found == all_.end() ? nullptr : &*found;
}

bool MountRules::is_mounted(const Mount& mount) const {
    const Volume* const volume = find(mount.first);
    return volume != nullptr && std::ranges::count(volume->roots, mount.second) > 0;
}

std::string MountRules::sentence_for(const Volume& volume) const {
    if (volume.usage == "crypto")
        return "The USB stick is locked with a password. Bring one without.";
    if (volume.usage == "filesystem" && !options_for(volume))
        return "The USB stick’s format is not read here. Bring one formatted as FAT or exFAT.";
    return "The stick cannot be read; put it in again or try another one";
}

bool MountRules::can_be_read(const Volume& volume) const {
    const auto tries = std::ranges::count_if(
        spent_, [&volume](const auto& spent) { return spent.second == volume.drive; });
    return is_promising(volume) && volume.usage == "filesystem" &&
           options_for(volume).has_value() && !spent_.contains({volume.object, volume.drive}) &&
           static_cast<std::size_t>(tries) < most_tries;
}

const Volume* MountRules::best() const {
    const Volume* best = nullptr;
    for (const Volume& volume : all_)
        if (can_be_read(volume) && (best == nullptr || is_better(volume, *best))) best = &volume;
    return best;
}

/// An answer is true, though the volumes may show it only later.
void MountRules::apply_answers() {
    for (Volume& volume : all_) {
        if (coming_ && coming_->first == volume.object && !is_mounted(*coming_))
            volume.roots.push_back(coming_->second);
        if (leaving_ && leaving_->first == volume.object)
            std::erase(volume.roots, leaving_->second);
    }
}

void MountRules::begin_anew() {
    for (const Volume& volume : all_) {
        if (volume.roots.empty()) continue;
        const Mount mount{volume.object, volume.roots.front()};
        if (unknown_ == volume.object) ours_.insert(mount);
        if (ours_.contains(mount) || (offer_ && offer_->object == volume.object)) continue;
        spent_.emplace(volume.object, volume.drive);
        told_.insert(volume.drive);
    }
    unknown_.reset();
}

void MountRules::forget_absent() {
    std::erase_if(spent_, [this](const auto& spent) {
        const Volume* const volume = find(spent.first);
        return volume == nullptr || volume->drive != spent.second;
    });
    std::erase_if(ours_, [this](const Mount& mount) { return !is_mounted(mount); });
    std::erase_if(told_, [this](const std::string& drive) {
        return std::ranges::none_of(
            all_, [&drive](const Volume& volume) { return volume.drive == drive; });
    });
}

StickStep MountRules::decide() {
    StickStep step;
    check_offer(step);
    const Volume* const wanted = best();
    const bool is_newer = offer_ && wanted != nullptr && wanted->drive != offer_->drive &&
                          wanted->detected_us > offer_->detected_us;
    if (is_newer) withdraw(step);
    // A stick that is slow to mount must not keep a newer one waiting.
    if (order_ && order_->kind == OrderKind::mount && wanted != nullptr &&
        wanted->object != order_->object) {
        order_.reset();
    }
    if (order_) return step;
    if (const Mount* const mount = superfluous(wanted); mount != nullptr) {
        give({OrderKind::unmount, 0, mount->first, "", ""}, step);
    } else if (!offer_ && wanted != nullptr) {
        mount_or_offer(*wanted, step);
    } else if (!offer_) {
        refuse_what_cannot_be_read(step);
    }
    return step;
}

void MountRules::check_offer(StickStep& step) {
    if (!offer_) return;
    const Volume* const volume = find(offer_->object);
    const bool is_there = volume != nullptr && volume->drive == offer_->drive;
    if (is_there && is_mounted({offer_->object, offer_->root})) return;
    if (is_there) {
        // Somebody unmounted it, and so wants to pull it out.
        spent_.emplace(offer_->object, offer_->drive);
        told_.insert(offer_->drive);
    }
    withdraw(step);
}

void MountRules::withdraw(StickStep& step) {
    step.events.push_back({StickNews::gone, offer_->root, ""});
    offer_.reset();
}

void MountRules::give(StickOrder order, StickStep& step) {
    order.number = ++last_number_;
    order_ = order;
    step.orders.push_back(std::move(order));
}

/// A mount of ours that nobody needs.
const MountRules::Mount* MountRules::superfluous(const Volume* wanted) const {
    const auto found = std::ranges::find_if(ours_, [this, wanted](const Mount& mount) {
        const bool is_offered = offer_ && offer_->object == mount.first;
        const bool is_wanted = !offer_ && wanted != nullptr && wanted->object == mount.first;
        return !is_offered && !is_wanted;
    });
    return found == ours_.end() ? nullptr : &*found;
}

void MountRules::mount_or_offer(const Volume& volume, StickStep& step) {
    if (volume.roots.empty()) {
        give({OrderKind::mount, 0, volume.object, volume.file_system,
              options_for(volume).value_or("")},
             step);
        return;
    }
    offer_ = Offer{volume.object, volume.drive, volume.roots.front(), volume.detected_us};
    step.events.push_back({StickNews::ready, offer_->root, ""});
}

/// Once per stick, when none of its volumes is left to try.
void MountRules::refuse_what_cannot_be_read(StickStep& step) {
    const auto tell = [this, &step](const Volume& volume) {
        if (told_.insert(volume.drive).second)
            step.events.push_back({StickNews::refused, "", sentence_for(volume)});
    };
    std::vector<const Volume*> left;
    for (const Volume& volume : all_)
        if (is_promising(volume)) left.push_back(&volume);
    std::ranges::sort(left, [](const Volume* a, const Volume* b) { return is_better(*a, *b); });
    for (const Volume* volume : left) tell(*volume);
}

}  // namespace touchline
