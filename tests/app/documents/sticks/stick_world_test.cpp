// Tests the rules of sticks against a world that does anything in any order: sticks come and go,
// udisks2 answers late, wrongly or not at all, and others mount and unmount.
#include "app/documents/sticks/mount_rules.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

struct Partition {
    Volume volume;
    bool fails = false;    // to mount
    bool is_ours = false;  // one of our orders mounted it
    bool is_plain = true;  // nothing has kept it from being offered
};

class World {
  public:
    /// The operator has allowed ext4.
    World() {
        rules_.allow(FileSystems::more);
        tell_volumes();
    }

    void plug(int slot, const std::string& file_system, bool fails, int partitions) {
        if (has_slot(slot)) return;
        ++time_;
        for (int i = 1; i <= partitions; ++i) {
            Partition partition;
            partition.volume.object = "sd" + std::to_string(slot) + "-" + std::to_string(i);
            partition.volume.drive =
                "drive" + std::to_string(slot) + "-" + std::to_string(time_ % 3);
            partition.volume.bus = slot == 0 ? "ata" : "usb";
            partition.volume.usage = "filesystem";
            partition.volume.file_system = file_system;
            partition.volume.detected_us = time_;
            partition.volume.bytes = 1;
            partition.fails = fails;
            partitions_.push_back(partition);
        }
        tell_volumes();
    }

    void pull(int slot) {
        for (const Partition& partition : partitions_) {
            if (!is_in(partition, slot)) continue;
            const std::string object = partition.volume.object;
            queue_.push_back([this, object] { carry_out(rules_.on_vanished(object)); });
        }
        std::erase_if(partitions_,
                      [slot](const Partition& partition) { return is_in(partition, slot); });
        tell_volumes();
    }

    void answer(std::size_t which, bool tells_volumes_first) {
        if (orders_.empty()) return;
        // Orders for one device are answered in the order in which they were given.
        const std::string& device = orders_[which % orders_.size()].object;
        const auto next = std::find_if(orders_.begin(), orders_.end(),
                                       [&device](const auto& one) { return one.object == device; });
        const StickOrder order = *next;
        orders_.erase(next);
        Partition* const partition = find(order.object);
        const bool is_mounted = partition != nullptr && !partition->volume.roots.empty();
        std::function<void()> answer;
        if (order.kind == OrderKind::unmount) {
            if (is_mounted) partition->volume.roots.clear();
            if (is_mounted) partition->is_ours = false;
            answer = [this, order, is_mounted] { rules_.on_unmounted(order.number, is_mounted); };
        } else if (partition == nullptr || is_mounted || partition->fails) {
            answer = [this, order, is_mounted] {
                rules_.on_mount_failed(order.number, is_mounted);
            };
        } else {
            const std::string root = "/media/" + std::to_string(++mounts_);
            partition->volume.roots = {root};
            partition->is_ours = true;
            answer = [this, order, root] { rules_.on_mounted(order.number, order.object, root); };
        }
        if (tells_volumes_first) tell_volumes();
        queue_.push_back(answer);
        tell_volumes();
    }

    void mount_by_others(std::size_t which) {
        if (partitions_.empty()) return;
        Partition& partition = partitions_[which % partitions_.size()];
        if (!partition.volume.roots.empty()) return;
        partition.volume.roots = {"/others/" + std::to_string(++mounts_)};
        partition.is_plain = false;
        tell_volumes();
    }

    void unmount_by_others(std::size_t which) {
        if (partitions_.empty()) return;
        Partition& partition = partitions_[which % partitions_.size()];
        partition.volume.roots.clear();
        partition.is_ours = false;
        partition.is_plain = false;
        tell_volumes();
    }

    void end_session() {
        root_.reset();
        carry_out(rules_.on_session_ended());
        for (Partition& partition : partitions_) partition.is_plain = false;
    }

    /// Loses whatever was under way. A stick that is pulled out and put back unnoticed counts as
    /// the same.
    void restart() {
        if (!queue_.empty())
            for (Partition& partition : partitions_) partition.is_plain = false;
        queue_.clear();
        orders_.clear();
        for (Partition& partition : partitions_) {
            const auto& roots = partition.volume.roots;
            if (roots.empty() || (root_ && roots.front() == *root_)) continue;
            partition.is_plain = false;
            partition.is_ours = false;  // nobody knows it any more
        }
        rules_.on_service_lost();
        tell_volumes();
    }

    void deliver() {
        if (queue_.empty()) return;
        const auto next = queue_.front();
        queue_.pop_front();
        next();
    }

    void settle() {
        while (!queue_.empty() || !orders_.empty()) {
            while (!queue_.empty()) deliver();
            answer(0, true);
        }
    }

    /// Checks what must hold when nothing is under way.
    void check_settled() const {
        std::size_t ours = 0;
        for (const Partition& partition : partitions_) {
            if (!partition.is_ours) continue;
            ++ours;
            RC_ASSERT(root_.has_value());
            RC_ASSERT(partition.volume.roots.front() == *root_);
        }
        RC_ASSERT(ours <= 1);
        if (root_) {
            RC_ASSERT(std::any_of(partitions_.begin(), partitions_.end(), [this](const auto& one) {
                return !one.volume.roots.empty() && one.volume.roots.front() == *root_;
            }));
        }
        check_newest();
    }

  private:
    static bool is_in(const Partition& partition, int slot) {
        return partition.volume.object.starts_with("sd" + std::to_string(slot) + "-");
    }

    bool has_slot(int slot) const {
        return std::any_of(partitions_.begin(), partitions_.end(),
                           [slot](const auto& one) { return is_in(one, slot); });
    }

    Partition* find(const std::string& object) {
        const auto found =
            std::find_if(partitions_.begin(), partitions_.end(),
                         [&](const auto& one) { return one.volume.object == object; });
        return found == partitions_.end() ? nullptr : &*found;
    }

    static bool is_good(const Partition& partition) {
        const Volume& volume = partition.volume;
        return volume.bus == "usb" &&
               (volume.file_system == "vfat" || volume.file_system == "ext4") && !partition.fails;
    }

    /// Checks that the newest stick is offered if nothing stood in its way.
    void check_newest() const {
        const Partition* newest = nullptr;
        for (const Partition& one : partitions_)
            if (is_good(one) &&
                (newest == nullptr || one.volume.detected_us > newest->volume.detected_us))
                newest = &one;
        if (newest == nullptr) return;
        bool is_offered = false;
        for (const Partition& one : partitions_) {
            if (one.volume.detected_us < newest->volume.detected_us) continue;
            if (!one.is_plain) return;
            if (one.volume.detected_us > newest->volume.detected_us) continue;
            if (root_ && !one.volume.roots.empty())
                is_offered |= one.volume.roots.front() == *root_;
        }
        RC_ASSERT(is_offered);
    }

    void tell_volumes() {
        std::vector<Volume> all;
        for (const Partition& partition : partitions_) all.push_back(partition.volume);
        queue_.push_back([this, all] { carry_out(rules_.on_volumes(all)); });
    }

    void carry_out(const StickStep& step) {
        for (const StickOrder& order : step.orders) {
            RC_ASSERT(!order.object.starts_with("sd0-"));  // the kiosk's own disk
            RC_ASSERT(order.kind == OrderKind::unmount ||
                      order.options.starts_with("ro,nosuid,nodev,noexec,nosymfollow"));
            orders_.push_back(order);
        }
        for (const StickEvent& event : step.events) hear(event);
    }

    void hear(const StickEvent& event) {
        switch (event.news) {
            case StickNews::ready:
                RC_ASSERT(!root_.has_value());
                root_ = event.root;
                return;
            case StickNews::gone:
                RC_ASSERT(root_ == event.root);
                root_.reset();
                return;
            case StickNews::refused:
                RC_ASSERT(!root_.has_value());
                RC_ASSERT(!event.sentence.empty());
                return;
        }
    }

    MountRules rules_;
    std::vector<Partition> partitions_;
    std::deque<std::function<void()>> queue_;  // from udisks2 to us, in order
    std::vector<StickOrder> orders_;           // not answered yet
    std::optional<std::string> root_;          // what the visitor was told
    std::uint64_t time_ = 0;
    int mounts_ = 0;
};

void act(World& world) {
    const int slot = *rc::gen::inRange(0, 4);
    const auto which = static_cast<std::size_t>(*rc::gen::inRange(0, 8));
    switch (*rc::gen::weightedElement<int>(
        {{4, 0}, {3, 1}, {12, 2}, {6, 3}, {1, 4}, {1, 5}, {1, 6}, {1, 7}})) {
        case 0:
            return world.plug(slot,
                              *rc::gen::element<std::string>("vfat", "ext4", "vfat", "hfsplus"),
                              which == 0, 1 + slot / 2);
        case 1:
            return world.pull(slot);
        case 2:
            return world.deliver();
        case 3:
            return world.answer(which, slot > 1);
        case 4:
            return world.mount_by_others(which);
        case 5:
            return world.unmount_by_others(which);
        case 6:
            return world.end_session();
        default:
            return world.restart();
    }
}

RC_GTEST_PROP(StickWorld, WhateverComesTheVisitorHearsATrueStory, ()) {
    for (int histories = 0; histories < 20; ++histories) {
        World world;
        const int acts = *rc::gen::inRange(1, 120);
        for (int i = 0; i < acts; ++i) act(world);
        world.settle();
        world.check_settled();
    }
}

/// After a swap in less than a second, and five hundred plugs, nothing piles up and the last stick
/// is offered.
TEST(StickWorld, FiveHundredPlugsLeaveNothingBehind) {
    World world;
    for (int i = 0; i < 500; ++i) {
        world.plug(1 + i % 3, "vfat", i % 7 == 0, 1);
        if (i % 2 == 0) world.settle();
        world.pull(1 + (i + 1) % 3);
    }
    world.settle();
    world.check_settled();
}

}  // namespace
}  // namespace touchline
