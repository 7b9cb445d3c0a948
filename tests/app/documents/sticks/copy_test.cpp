#include "app/documents/sticks/stick_reading.h"
#include "app/isolation/process/memory.h"
#include "tests/app/documents/sticks/stick_folder.h"

#include <cerrno>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

class StickCopy : public testing::Test {
  protected:
    Result<std::string, StickRefusal> copy(const std::string& folder, const std::string& name) {
        const Descriptor output = fresh_memory().value();
        const auto copied = copy_from_stick(stick.open(), folder, name, output, limits);
        if (!copied) return tl::unexpected(copied.error());
        std::string bytes(most_bytes + 1, '\0');
        bytes.resize(
            static_cast<std::size_t>(::pread(output.number(), bytes.data(), bytes.size(), 0)));
        return bytes;
    }

    StickRefusal refusal(const std::string& folder, const std::string& name) {
        const auto copied = copy(folder, name);
        EXPECT_FALSE(copied.has_value()) << name;
        return copied ? StickRefusal::not_started : copied.error();
    }

    static constexpr std::size_t most_bytes = 1 << 20;
    StickFolder stick;
    CopyLimits limits{most_bytes};
};

TEST_F(StickCopy, EveryByteArrives) {
    std::string bytes;
    for (int i = 0; i < 700'000; ++i) bytes += static_cast<char>(i * 7 + i / 251);
    stick.folder("day 2");
    stick.file("day 2/boat.png", bytes);
    stick.file("root.png", std::string(most_bytes, 'r'));
    EXPECT_EQ(copy("day 2", "boat.png"), bytes);
    EXPECT_EQ(copy("", "root.png"), std::string(most_bytes, 'r'));
}

TEST_F(StickCopy, TooLargeEmptyOrGoneIsRefused) {
    stick.file("large.png", std::string(most_bytes + 1, 'l'));
    stick.file("empty.png", "");
    EXPECT_EQ(refusal("", "large.png"), StickRefusal::too_large);
    EXPECT_EQ(refusal("", "empty.png"), StickRefusal::empty);
    EXPECT_EQ(refusal("", "none.png"), StickRefusal::no_such_file);
    EXPECT_EQ(refusal("none", "a.png"), StickRefusal::no_such_file);
}

TEST_F(StickCopy, ALinkIsNotFollowed) {
    stick.file("boat.png");
    stick.folder("real");
    stick.file("real/a.png");
    fs::create_symlink("/etc/passwd", stick.path() / "shadow.png");
    fs::create_symlink("boat.png", stick.path() / "near.png");
    fs::create_symlink("loop.png", stick.path() / "loop.png");
    fs::create_directory_symlink("real", stick.path() / "linked");
    fs::create_directory_symlink("/", stick.path() / "out");
    for (const char* name : {"shadow.png", "near.png", "loop.png"})
        EXPECT_EQ(refusal("", name), StickRefusal::no_file) << name;
    EXPECT_EQ(copy("real", "a.png"), "x");
    for (const char* folder : {"linked", "out"}) {
        const StickRefusal why = refusal(folder, "a.png");
        EXPECT_TRUE(why == StickRefusal::no_file || why == StickRefusal::no_such_file) << folder;
    }
}

TEST_F(StickCopy, NamesThatAreNoNamesAreNotTried) {
    stick.folder("in");
    stick.file("a.png");
    for (const char* name : {"", ".", "..", "../a.png", "in/../a.png", "/etc/passwd"})
        EXPECT_EQ(refusal("in", name), StickRefusal::no_such_file) << name;
    for (const char* folder : {".", "..", "in/..", "/"})
        EXPECT_EQ(refusal(folder, "a.png"), StickRefusal::no_such_file) << folder;
}

TEST_F(StickCopy, WhatIsNoFileIsNotOpened) {
    stick.folder("folder.png");
    ASSERT_EQ(::mkfifo((stick.path() / "pipe.png").c_str(), 0644), 0);
    EXPECT_EQ(refusal("", "folder.png"), StickRefusal::no_file);
    EXPECT_EQ(refusal("", "pipe.png"), StickRefusal::no_file);  // and did not wait for a writer
    if (::geteuid() != 0) return;                               // only root can make devices
    ASSERT_EQ(::mknod((stick.path() / "zero.png").c_str(), S_IFCHR | 0644, makedev(1, 5)), 0);
    ASSERT_EQ(::mknod((stick.path() / "disk.png").c_str(), S_IFBLK | 0644, makedev(7, 0)), 0);
    EXPECT_EQ(refusal("", "zero.png"), StickRefusal::no_file);
    EXPECT_EQ(refusal("", "disk.png"), StickRefusal::no_file);
}

TEST_F(StickCopy, AFileThatGrowsOrShrinksMeanwhileIsRefused) {
    stick.file("a.png", std::string(600'000, 'a'));
    int asked = 0;
    const auto resize = [this, &asked](std::size_t bytes) {
        asked = 0;
        limits.is_time_up = [this, &asked, bytes] {
            if (++asked == 2) fs::resize_file(stick.path() / "a.png", bytes);
            return false;
        };
    };
    resize(500'000);
    EXPECT_EQ(refusal("", "a.png"), StickRefusal::unreadable);
    resize(700'000);
    EXPECT_EQ(refusal("", "a.png"), StickRefusal::unreadable);
}

TEST_F(StickCopy, AFileThatIsLockedIsToldSo) {
    stick.file("a.png");
    fs::permissions(stick.path() / "a.png", fs::perms::none);
    const bool is_root = ::geteuid() == 0;
    ASSERT_TRUE(!is_root || ::seteuid(65534) == 0);  // permissions bind this user
    const StickRefusal why = refusal("", "a.png");
    ASSERT_TRUE(!is_root || ::seteuid(0) == 0);
    EXPECT_EQ(why, StickRefusal::locked);
}

TEST_F(StickCopy, TimeHasAnEnd) {
    stick.file("a.png", std::string(600'000, 'a'));
    int asked = 0;
    limits.is_time_up = [&asked] { return ++asked > 2; };
    EXPECT_EQ(refusal("", "a.png"), StickRefusal::out_of_time);
    EXPECT_EQ(asked, 3);
}

TEST(StickErrno, SaysWhatItMeans) {
    EXPECT_EQ(refusal_of(EIO), StickRefusal::unreadable);
    EXPECT_EQ(refusal_of(ENODEV), StickRefusal::gone);
    EXPECT_EQ(refusal_of(ENOTCONN), StickRefusal::gone);
    EXPECT_EQ(refusal_of(ELOOP), StickRefusal::no_file);
    EXPECT_EQ(refusal_of(EXDEV), StickRefusal::no_file);
    EXPECT_EQ(refusal_of(ENOENT), StickRefusal::no_such_file);
    EXPECT_EQ(refusal_of(EACCES), StickRefusal::locked);
}

}  // namespace
}  // namespace touchline
