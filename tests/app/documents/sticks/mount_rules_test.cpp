#include "app/documents/sticks/mount_rules.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

using Events = std::vector<StickEvent>;
using Objects = std::vector<std::string>;

Volume stick(std::string object, std::string drive, std::uint64_t detected_us,
             std::string file_system = "vfat") {
    Volume volume;
    volume.object = std::move(object);
    volume.drive = std::move(drive);
    volume.bus = "usb";
    volume.usage = "filesystem";
    volume.file_system = std::move(file_system);
    volume.detected_us = detected_us;
    volume.bytes = 1;
    return volume;
}

Volume mounted(Volume volume, std::string root) {
    volume.roots.push_back(std::move(root));
    return volume;
}

StickEvent ready(std::string root) {
    return {StickNews::ready, std::move(root), ""};
}

StickEvent gone(std::string root) {
    return {StickNews::gone, std::move(root), ""};
}

class StickRulesTest : public testing::Test {
  protected:
    StickRulesTest() { (void)rules.on_volumes({}); }

    /// Returns the number of a step's only order; 0 if it is not one to `kind` this object.
    static std::uint64_t number_of(const StickStep& step, OrderKind kind,
                                   const std::string& object) {
        const bool is_it = step.orders.size() == 1 && step.orders[0].kind == kind &&
                           step.orders[0].object == object;
        return is_it ? step.orders[0].number : 0;
    }

    static std::uint64_t mounts(const StickStep& step, const std::string& object) {
        return number_of(step, OrderKind::mount, object);
    }

    static std::uint64_t unmounts(const StickStep& step, const std::string& object) {
        return number_of(step, OrderKind::unmount, object);
    }

    /// Mounts sdb1 on "/m" by our order, and offers it.
    void hold() {
        const auto number = mounts(rules.on_volumes({first}), "sdb1");
        ASSERT_NE(number, 0U);
        rules.on_mounted(number, "sdb1", "/m");
        ASSERT_EQ(rules.on_volumes({mounted(first, "/m")}).events, Events{ready("/m")});
    }

    MountRules rules;
    const Volume first = stick("sdb1", "one", 10);
    const Volume second = stick("sdc1", "two", 20);
};

TEST_F(StickRulesTest, AStickIsMountedAndOffered) {
    const auto step = rules.on_volumes({first});
    ASSERT_EQ(step.orders.size(), 1U);
    EXPECT_EQ(step.orders[0].object, "sdb1");
    EXPECT_EQ(step.orders[0].file_system, "vfat");
    EXPECT_EQ(step.orders[0].options, "ro,nosuid,nodev,noexec,nosymfollow");
    EXPECT_TRUE(step.events.empty());
    EXPECT_TRUE(rules.on_volumes({first}).orders.empty());  // once
    rules.on_mounted(step.orders[0].number, "sdb1", "/m");
    // The volumes may not know it yet, but the answer does.
    EXPECT_EQ(rules.on_volumes({first}).events, Events{ready("/m")});
    EXPECT_TRUE(rules.on_volumes({first}).events.empty());
    EXPECT_TRUE(rules.on_volumes({mounted(first, "/m")}).events.empty());
}

TEST_F(StickRulesTest, EachFileSystemHasItsOptions) {
    const std::string plain = "ro,nosuid,nodev,noexec,nosymfollow";
    const auto options = [](const std::string& file_system, FileSystems allowed) {
        MountRules fresh;
        fresh.allow(allowed);
        (void)fresh.on_volumes({});
        const auto step = fresh.on_volumes({stick("sdb1", "one", 10, file_system)});
        return step.orders.empty() ? "not mounted" : step.orders[0].options;
    };
    for (const FileSystems allowed : {FileSystems::usual, FileSystems::more}) {
        EXPECT_EQ(options("vfat", allowed), plain);
        EXPECT_EQ(options("exfat", allowed), plain);
        for (const char* other : {"ext2", "btrfs", "hfsplus", "iso9660", "udf", "xfs", "", "VFAT"})
            EXPECT_EQ(options(other, allowed), "not mounted") << other;
    }
    EXPECT_EQ(options("ext4", FileSystems::usual), "not mounted");
    EXPECT_EQ(options("ntfs", FileSystems::usual), "not mounted");
    EXPECT_EQ(options("ext4", FileSystems::more), plain + ",noload");
    EXPECT_EQ(options("ntfs", FileSystems::more), plain + ",norecover");
}

/// A file system that the operator has not allowed is not read, whoever mounted it.
TEST_F(StickRulesTest, WhatIsNotAllowedIsRefusedWithWhatToDo) {
    for (const char* kind : {"ext4", "ntfs"}) {
        MountRules fresh;
        (void)fresh.on_volumes({});
        const auto step = fresh.on_volumes({mounted(stick("sdb1", "one", 10, kind), "/m")});
        EXPECT_TRUE(step.orders.empty());
        ASSERT_EQ(step.events.size(), 1U);
        EXPECT_EQ(step.events[0].sentence,
                  "The USB stick’s format is not read here. Bring one formatted as FAT or exFAT.");
        fresh.allow(FileSystems::more);
        EXPECT_EQ(mounts(fresh.on_volumes({stick("sdc1", "two", 20, kind)}), "sdc1"), 1U);
    }
}

TEST_F(StickRulesTest, WhatIsNoVisitorsIsNeitherMountedNorTold) {
    std::vector<Volume> all(7, first);
    all[0].bus = "ata";
    all[1].bus = "";
    all[2].is_of_system = true;
    all[3].drive = "";
    all[4].bytes = 0;
    all[5].is_partitioned = true;
    all[6].is_ignored = true;
    const auto step = rules.on_volumes(all);
    EXPECT_TRUE(step.orders.empty());
    EXPECT_TRUE(step.events.empty());
}

TEST_F(StickRulesTest, WhatWasMountedBeforeIsTheOperators) {
    MountRules fresh;
    const auto step = fresh.on_volumes({mounted(first, "/data")});
    EXPECT_TRUE(step.orders.empty());
    EXPECT_TRUE(step.events.empty());
    EXPECT_TRUE(fresh.on_volumes({first}).orders.empty());
}

TEST_F(StickRulesTest, PulledOutIsTold) {
    hold();
    EXPECT_EQ(rules.on_vanished("sdb1").events, Events{gone("/m")});
    EXPECT_TRUE(rules.on_volumes({}).events.empty());
    EXPECT_EQ(rules.on_volumes({first}).orders.size(), 1U);  // and plugged in again
}

TEST_F(StickRulesTest, TheLastOneWinsAndTheFirstComesBack) {
    hold();
    auto step = rules.on_volumes({mounted(first, "/m"), second});
    EXPECT_EQ(step.events, Events{gone("/m")});
    rules.on_unmounted(unmounts(step, "sdb1"), true);
    // The volumes may still show what is already unmounted.
    const auto number = mounts(rules.on_volumes({mounted(first, "/m"), second}), "sdc1");
    rules.on_mounted(number, "sdc1", "/n");
    EXPECT_EQ(rules.on_volumes({first, mounted(second, "/n")}).events, Events{ready("/n")});
    step = rules.on_volumes({first});
    EXPECT_EQ(step.events, Events{gone("/n")});
    EXPECT_NE(mounts(step, "sdb1"), 0U);
}

TEST_F(StickRulesTest, ASlowStickDoesNotKeepANewerOneWaiting) {
    const auto slow = mounts(rules.on_volumes({first}), "sdb1");
    const auto quick = mounts(rules.on_volumes({first, second}), "sdc1");
    ASSERT_NE(quick, 0U);
    rules.on_mounted(quick, "sdc1", "/n");
    EXPECT_EQ(rules.on_volumes({first, mounted(second, "/n")}).events, Events{ready("/n")});
    rules.on_mounted(slow, "sdb1", "/m");
    const auto step = rules.on_volumes({mounted(first, "/m"), mounted(second, "/n")});
    EXPECT_NE(unmounts(step, "sdb1"), 0U);
    EXPECT_TRUE(step.events.empty());
}

TEST_F(StickRulesTest, TheSessionsEndUnmountsAndOffersItNoMore) {
    hold();
    const auto step = rules.on_session_ended();
    EXPECT_NE(unmounts(step, "sdb1"), 0U);
    EXPECT_TRUE(step.events.empty());
    rules.on_unmounted(step.orders[0].number, true);
    EXPECT_TRUE(rules.on_volumes({first}).orders.empty());
    EXPECT_TRUE(rules.on_volumes({}).orders.empty());
    EXPECT_NE(mounts(rules.on_volumes({first}), "sdb1"), 0U);
}

TEST_F(StickRulesTest, WhatCannotBeUnmountedIsNotTriedForEver) {
    hold();
    rules.on_unmounted(unmounts(rules.on_session_ended(), "sdb1"), false);
    EXPECT_TRUE(rules.on_volumes({mounted(first, "/m")}).orders.empty());
}

TEST_F(StickRulesTest, AnAnswerThatComesTooLateIsUndone) {
    const auto number = mounts(rules.on_volumes({first}), "sdb1");
    EXPECT_TRUE(rules.on_session_ended().orders.empty());
    rules.on_mounted(number, "sdb1", "/m");
    const auto step = rules.on_volumes({mounted(first, "/m")});
    EXPECT_NE(unmounts(step, "sdb1"), 0U);
    EXPECT_TRUE(step.events.empty());
}

TEST_F(StickRulesTest, MountedByADesktopItIsReadAndLeftMounted) {
    rules.on_mount_failed(mounts(rules.on_volumes({first}), "sdb1"), true);
    EXPECT_EQ(rules.on_volumes({mounted(first, "/d")}).events, Events{ready("/d")});
    EXPECT_TRUE(rules.on_session_ended().orders.empty());
}

TEST_F(StickRulesTest, UnmountedByADesktopItIsGoneAndStaysGone) {
    hold();
    EXPECT_EQ(rules.on_volumes({first}).events, Events{gone("/m")});
    EXPECT_TRUE(rules.on_volumes({first}).orders.empty());
}

TEST_F(StickRulesTest, TheNextPartitionIsTriedWhenOneFails) {
    const auto next = stick("sdb2", "one", 10, "exfat");
    auto step = rules.on_volumes({next, first});
    ASSERT_EQ(step.orders.size(), 1U);
    EXPECT_EQ(step.orders[0].object, "sdb1");
    rules.on_mount_failed(step.orders[0].number, false);
    step = rules.on_volumes({next, first});
    ASSERT_EQ(step.orders.size(), 1U);
    EXPECT_EQ(step.orders[0].object, "sdb2");
    EXPECT_TRUE(step.events.empty());
    rules.on_mount_failed(step.orders[0].number, false);
    step = rules.on_volumes({next, first});
    EXPECT_TRUE(step.orders.empty());
    ASSERT_EQ(step.events.size(), 1U);
    EXPECT_EQ(step.events[0].news, StickNews::refused);
    EXPECT_TRUE(rules.on_volumes({first, next}).events.empty());  // told once
}

TEST_F(StickRulesTest, NoMoreThanFourPartitionsAreTried) {
    std::vector<Volume> all;
    for (int i = 1; i <= 12; ++i) all.push_back(stick("sdb" + std::to_string(i), "one", 10));
    auto step = rules.on_volumes(all);
    std::vector<std::string> tried;
    while (!step.orders.empty()) {
        tried.push_back(step.orders[0].object);
        rules.on_mount_failed(step.orders[0].number, false);
        step = rules.on_volumes(all);
    }
    EXPECT_EQ(tried, (Objects{"sdb1", "sdb2", "sdb3", "sdb4"}));
}

TEST_F(StickRulesTest, WhatCannotBeReadIsOneSentence) {
    const auto sentence = [](Volume volume) {
        MountRules fresh;
        (void)fresh.on_volumes({});
        const auto step = fresh.on_volumes({std::move(volume)});
        EXPECT_TRUE(step.orders.empty());
        return step.events.size() == 1 ? step.events[0].sentence : "no sentence";
    };
    Volume locked = first;
    locked.usage = "crypto";
    locked.file_system = "crypto_LUKS";
    Volume blank = first;
    blank.usage = "";
    blank.file_system = "";
    EXPECT_NE(sentence(stick("sdb1", "one", 10, "hfsplus")).find("FAT or exFAT"),
              std::string::npos);
    Volume ignored = stick("sdb1", "one", 10, "hfsplus");
    ignored.is_ignored = true;  // by the udev rules that are installed
    EXPECT_NE(sentence(ignored).find("FAT or exFAT"), std::string::npos);
    EXPECT_NE(sentence(locked).find("password"), std::string::npos);
    EXPECT_NE(sentence(blank).find("cannot be read"), std::string::npos);
}

TEST_F(StickRulesTest, ARestartOfUdisksChangesNothingForTheVisitor) {
    hold();
    rules.on_service_lost();
    const auto step = rules.on_volumes({mounted(first, "/m")});
    EXPECT_TRUE(step.events.empty());
    EXPECT_TRUE(step.orders.empty());
    EXPECT_NE(unmounts(rules.on_session_ended(), "sdb1"), 0U);
}

TEST_F(StickRulesTest, AnOrderThatARestartSwallowedIsGivenAgain) {
    (void)rules.on_volumes({first});
    rules.on_service_lost();
    EXPECT_EQ(rules.on_volumes({first}).orders.size(), 1U);
    // Or the order was carried out, and only the answer is lost.
    rules.on_service_lost();
    EXPECT_EQ(rules.on_volumes({mounted(first, "/m")}).events, Events{ready("/m")});
    EXPECT_NE(unmounts(rules.on_session_ended(), "sdb1"), 0U);
}

}  // namespace
}  // namespace touchline
