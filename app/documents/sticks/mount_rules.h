// Decides which volume of which stick is mounted, when, and what the visitor is told about it: a
// state machine without a bus.
// Threads: a value.
#pragma once

#include "app/documents/sticks/stick_port.h"

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

/// A block device and its drive, as reported by udisks2.
struct Volume {
    std::string object;              // its name on the bus
    std::string drive;               // the drive's name on the bus
    std::string bus;                 // the drive's connection: "usb", "sdio", ...
    std::string usage;               // "filesystem", "crypto", ""
    std::string file_system;         // the kernel's name
    std::uint64_t detected_us = 0;   // when the drive's medium came
    std::vector<std::string> roots;  // where it is mounted
    std::uint64_t bytes = 0;         // 0: a card reader without a card
    bool is_of_system = false;
    bool is_ignored = false;      // by the machine's udev rules
    bool is_partitioned = false;  // it holds volumes instead of files
};

enum class OrderKind : std::uint8_t { mount, unmount };

/// An order for udisks2. `number` tells the answers of two orders apart.
struct StickOrder {
    OrderKind kind = OrderKind::mount;
    std::uint64_t number = 0;
    std::string object;
    std::string file_system;  // of the volume to mount
    std::string options;
};

/// What to do. Report each order's answer to the rules, and after it all volumes anew.
struct StickStep {
    std::vector<StickOrder> orders;
    std::vector<StickEvent> events;
};

/// Each call reports one event. There is one order at a time, and the next is decided only from
/// volumes reported after its answer. What is already mounted in the first report belongs to the
/// operator, not to a visitor, and is left alone.
class MountRules {
  public:
    /// For sticks mounted from now on; FAT and exFAT at first.
    void allow(FileSystems allowed) { allowed_ = allowed; }

    /// Reports all present block devices.
    [[nodiscard]] StickStep on_volumes(std::vector<Volume> all);

    /// This one has just gone; the next one under its name is another.
    [[nodiscard]] StickStep on_vanished(const std::string& object);

    /// It is mounted on `root` now.
    void on_mounted(std::uint64_t number, const std::string& object, const std::string& root);
    /// We did not mount it. It may have been mounted already; the next volumes show that.
    void on_mount_failed(std::uint64_t number, bool is_mounted_already);
    void on_unmounted(std::uint64_t number, bool is_done);

    /// The visitor is done: unmounts what we mounted, and does not offer again what is plugged in.
    [[nodiscard]] StickStep on_session_ended();

    /// udisks2 ended. What is mounted stays mounted; orders get no answer.
    void on_service_lost();

  private:
    /// A volume of a stick, and one of its roots.
    using Mount = std::pair<std::string, std::string>;

    /// The stick that was reported to the visitor as ready.
    struct Offer {
        std::string object;
        std::string drive;
        std::string root;
        std::uint64_t detected_us = 0;
    };

    [[nodiscard]] const Volume* find(const std::string& object) const;
    [[nodiscard]] bool is_mounted(const Mount& mount) const;

    [[nodiscard]] std::optional<std::string> options_for(const Volume& volume) const {
        return mount_options(volume.file_system, allowed_);
    }

    [[nodiscard]] std::string sentence_for(const Volume& volume) const;
    [[nodiscard]] bool can_be_read(const Volume& volume) const;
    [[nodiscard]] const Volume* best() const;
    void apply_answers();
    void begin_anew();
    void forget_absent();
    [[nodiscard]] StickStep decide();
    void check_offer(StickStep& step);
    void withdraw(StickStep& step);
    void give(StickOrder order, StickStep& step);
    [[nodiscard]] const Mount* superfluous(const Volume* wanted) const;
    void mount_or_offer(const Volume& volume, StickStep& step);
    void refuse_what_cannot_be_read(StickStep& step);

    FileSystems allowed_ = FileSystems::usual;
    std::vector<Volume> all_;
    std::optional<Offer> offer_;
    std::optional<StickOrder> order_;     // not answered yet
    std::optional<Mount> coming_;         // mounted, though the volumes may not show it yet
    std::optional<Mount> leaving_;        // unmounted, though the volumes may still show it
    std::optional<std::string> unknown_;  // an object whose mount order gets no answer any more
    std::set<Mount> ours_;                // mounted by our orders
    std::set<std::pair<std::string, std::string>> spent_;  // object and drive: not tried again
    std::set<std::string> told_;                           // drives that were refused or let go
    std::uint64_t last_number_ = 0;
    bool is_first_ = true;  // no volumes were reported yet, or none since udisks2 restarted
};

}  // namespace touchline
