// Tests the port against a mocked udisks2 on a private bus.
#include "app/documents/sticks/stick_port.h"
#include "tests/app/documents/sticks/mocked_udisks.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using Lines = std::vector<std::string>;

class UdisksPortTest : public testing::Test {
  protected:
    /// Polls until so many events have come and returns all of them, as "ready ROOT", "gone ROOT"
    /// or "refused".
    Lines news(std::size_t count) {
        Lines lines;
        EXPECT_TRUE(becomes([&] {
            for (const StickEvent& event : port.poll(now_ns)) lines.push_back(line_of(event));
            return lines.size() >= count;
        }));
        return lines;
    }

    static std::string line_of(const StickEvent& event) {
        switch (event.news) {
            case StickNews::ready:
                return "ready " + event.root;
            case StickNews::gone:
                return "gone " + event.root;
            case StickNews::refused:
                return "refused";
        }
        return {};
    }

    bool watches(bool wanted) {
        return becomes([&] {
            for (const StickEvent& event : port.poll(now_ns)) unexpected.push_back(line_of(event));
            return port.is_watching() == wanted;
        });
    }

    MockedUdisks udisks{TOUCHLINE_SOURCE_DIR "/tests/app/documents/sticks/udisks_mock.py"};
    std::unique_ptr<StickPort> udisks_port = open_stick_port("");
    StickPort& port = *udisks_port;
    std::int64_t now_ns = 0;
    Lines unexpected;
};

TEST_F(UdisksPortTest, AStickIsMountedReadOnlyAndUnmountedAtTheSessionsEnd) {
    udisks.start_service();
    ASSERT_TRUE(udisks.is_up());
    ASSERT_TRUE(watches(true));
    port.allow(FileSystems::more);
    udisks.plug("sdb1", "one", "ext4", 10);
    EXPECT_EQ(news(1), Lines{"ready /media/sdb1"});
    EXPECT_EQ(udisks.asked("sdb1"), Lines{"Mount ext4 ro,nosuid,nodev,noexec,nosymfollow,noload"});
    port.end_session();
    EXPECT_TRUE(becomes([&] {
        return port.poll(now_ns).empty() && udisks.asked("sdb1").back() == "Unmount forced";
    }));
}

TEST_F(UdisksPortTest, OneThatIsThereAtTheStartIsOffered) {
    udisks.start_service();
    udisks.plug("sdb1", "one", "vfat", 10);
    udisks.plug("sda1", "disk", "ext4", 99, "good", "ata");
    udisks.plug("sdz1", "backup", "ext4", 98, "mounted");
    EXPECT_EQ(news(1), Lines{"ready /media/sdb1"});
    EXPECT_TRUE(udisks.asked("sda1").empty());
    EXPECT_TRUE(udisks.asked("sdz1").empty());
}

TEST_F(UdisksPortTest, PulledOutAndAnotherPutIn) {
    udisks.start_service();
    ASSERT_TRUE(watches(true));
    udisks.plug("sdb1", "one", "vfat", 10);
    EXPECT_EQ(news(1), Lines{"ready /media/sdb1"});
    udisks.pull("sdb1", "one");
    udisks.plug("sdb1", "two", "exfat", 20);  // under the same name, at once
    EXPECT_EQ(news(2), (Lines{"gone /media/sdb1", "ready /media/sdb1"}));
    port.allow(FileSystems::more);
    udisks.plug("sdc1", "three", "ntfs", 30);
    EXPECT_EQ(news(2), (Lines{"gone /media/sdb1", "ready /media/sdc1"}));
    EXPECT_EQ(udisks.asked("sdc1"),
              Lines{"Mount ntfs ro,nosuid,nodev,noexec,nosymfollow,norecover"});
    udisks.pull("sdc1", "three");
    EXPECT_EQ(news(2), (Lines{"gone /media/sdc1", "ready /media/sdb1"}));
}

TEST_F(UdisksPortTest, WhatTheOperatorHasNotAllowedIsNeverAskedFor) {
    udisks.start_service();
    ASSERT_TRUE(watches(true));
    udisks.plug("sdb1", "one", "ext4", 10);
    udisks.plug("sdc1", "two", "ntfs", 20);
    EXPECT_EQ(news(2), (Lines{"refused", "refused"}));
    EXPECT_TRUE(udisks.asked("sdb1").empty());
    EXPECT_TRUE(udisks.asked("sdc1").empty());
}

TEST_F(UdisksPortTest, WhatCannotBeReadIsRefused) {
    udisks.start_service();
    ASSERT_TRUE(watches(true));
    udisks.plug("sdb1", "one", "hfsplus", 10);
    EXPECT_EQ(news(1), Lines{"refused"});
    EXPECT_TRUE(udisks.asked("sdb1").empty());
    udisks.plug("sdc1", "two", "crypto_LUKS", 20);
    EXPECT_EQ(news(1), Lines{"refused"});
    udisks.plug("sdd1", "three", "vfat", 30, "fails");
    EXPECT_EQ(news(1), Lines{"refused"});
    EXPECT_EQ(udisks.asked("sdd1").size(), 1U);
}

TEST_F(UdisksPortTest, TheAnswerCountsWhereThePropertyIsLate) {
    udisks.start_service();
    ASSERT_TRUE(watches(true));
    udisks.plug("sdb1", "one", "vfat", 10, "late");
    EXPECT_EQ(news(1), Lines{"ready /media/sdb1"});
}

TEST_F(UdisksPortTest, ADesktopThatIsQuickerIsJoined) {
    udisks.start_service();
    ASSERT_TRUE(watches(true));
    udisks.plug("sdb1", "one", "vfat", 10, "desktop");
    EXPECT_EQ(news(1), Lines{"ready /desktop/sdb1"});
    port.end_session();
    udisks.plug("sdc1", "two", "vfat", 20);
    EXPECT_EQ(news(1), Lines{"ready /media/sdc1"});
    EXPECT_EQ(udisks.asked("sdb1").size(), 1U);  // and not unmounted
}

TEST_F(UdisksPortTest, UdisksMayBeAbsentAndComeAndGo) {
    ASSERT_TRUE(udisks.is_up());
    EXPECT_TRUE(watches(false));
    udisks.start_service();
    EXPECT_TRUE(watches(true));
    udisks.plug("sdb1", "one", "vfat", 10);
    EXPECT_EQ(news(1), Lines{"ready /media/sdb1"});
    udisks.stop_service();
    EXPECT_TRUE(watches(false));
    udisks.start_service(R"([["sdb1", "one", "usb", "vfat", 11, "mounted"]])");
    EXPECT_TRUE(watches(true));
    EXPECT_TRUE(unexpected.empty());  // for the visitor nothing has happened
    port.end_session();
    EXPECT_TRUE(
        becomes([&] { return port.poll(now_ns).empty() && !udisks.asked("sdb1").empty(); }));
    EXPECT_EQ(udisks.asked("sdb1"), Lines{"Unmount forced"});
}

TEST_F(UdisksPortTest, TheBusMayEndAndComeBack) {
    udisks.start_service();
    ASSERT_TRUE(watches(true));
    udisks.stop_service();
    udisks.stop_bus();
    EXPECT_TRUE(watches(false));
    port.end_session();
    udisks.start_bus();
    udisks.start_service();
    ASSERT_TRUE(udisks.is_up());
    now_ns += 10'000'000'000;
    EXPECT_TRUE(watches(true));
    udisks.plug("sdb1", "one", "vfat", 10);
    EXPECT_EQ(news(1), Lines{"ready /media/sdb1"});
    EXPECT_TRUE(unexpected.empty());
}

TEST_F(UdisksPortTest, ManyPlugsLeaveNothingBehind) {
    udisks.start_service();
    ASSERT_TRUE(watches(true));
    const auto count_descriptors = [] {
        const std::filesystem::directory_iterator all("/proc/self/fd");
        return std::distance(begin(all), end(all));
    };
    std::ptrdiff_t before = 0;
    for (std::uint64_t i = 1; i <= 100; ++i) {
        udisks.plug("sdb1", "one", "vfat", i);
        ASSERT_EQ(news(1), Lines{"ready /media/sdb1"});
        udisks.pull("sdb1", "one");
        ASSERT_EQ(news(1), Lines{"gone /media/sdb1"});
        if (i == 10) before = count_descriptors();  // libraries keep some after their first use
    }
    EXPECT_EQ(count_descriptors(), before);
}

}  // namespace
}  // namespace touchline
