// Tests real file systems with real mount options. Only root can mount some, so only a run by root
// tests them.
#include "app/documents/sticks/import.h"
#include "app/documents/sticks/stick_port.h"
#include "tests/app/documents/sticks/hung_stick.h"
#include "tests/app/documents/sticks/mounted_image.h"
#include "tests/app/documents/sticks/stick_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

StickEntry picture(std::string name) {
    return {StickFileKind::picture, "", std::move(name)};
}

class MountedStick : public testing::Test {
  protected:
    /// Makes an ext4 image of what `content` holds.
    void make_image() {
        ASSERT_TRUE(does("mkfs.ext4 -q -F -d " + content.root() + " " + image.string() + " 16M"));
    }

    /// Makes the same image, but with a full journal, as if the stick was pulled out while it was
    /// written.
    void make_dirty_image() {
        make_image();
        const fs::path live = desk.path() / "live";
        {
            const MountedImage mounted(image, mount_point.path(), "rw");
            ASSERT_TRUE(mounted.is_mounted());
            for (int i = 0; i < 50; ++i)
                std::ofstream(mount_point.path() / ("late" + std::to_string(i) + ".png")) << i;
            ASSERT_TRUE(does("sync -f " + mount_point.root()));
            fs::copy_file(image, live);
        }
        fs::rename(live, image);
    }

    static std::string options() {
        return mount_options("ext4", FileSystems::more).value_or("none");
    }

    StickFolder content;
    StickFolder mount_point;
    StickFolder desk;
    fs::path image = desk.path() / "image";
    StickImport import{TOUCHLINE_IMPORT, {60.0, 60.0}};
};

TEST_F(MountedStick, IsReadWithoutChangingAByte) {
    if (!may_mount()) return;
    content.file("boat.png", "a boat");
    content.folder("day 2");
    content.file("day 2/dog.png", "a dog");
    make_dirty_image();
    const std::string before = bytes_of_file(image);
    {
        const MountedImage mounted(image, mount_point.path(), options());
        ASSERT_TRUE(mounted.is_mounted());
        const auto listing = import.list(mount_point.root());
        ASSERT_TRUE(listing.has_value());
        EXPECT_GE(listing->entries.size(), 2U);
        for (const StickEntry& entry : listing->entries)
            EXPECT_TRUE(import.read(mount_point.root(), entry).has_value() ||
                        entry.name.starts_with("late"));
        EXPECT_FALSE(std::ofstream(mount_point.path() / "new.png").is_open());
    }
    EXPECT_TRUE(bytes_of_file(image) == before);
    {
        // Otherwise the line above would prove nothing: read-only alone allows the journal to be
        // replayed.
        const MountedImage mounted(image, mount_point.path(), "ro");
        ASSERT_TRUE(mounted.is_mounted());
    }
    EXPECT_FALSE(bytes_of_file(image) == before);
}

TEST_F(MountedStick, LeadsNowhereAndRunsNothing) {
    if (!may_mount()) return;
    fs::create_symlink("/etc/passwd", content.path() / "link.png");
    fs::create_symlink("..", content.path() / "up.png");
    content.file("tool.png", "#!/bin/sh\nexit 0\n");
    fs::permissions(content.path() / "tool.png", fs::perms(04755));
    ASSERT_EQ(::mknod((content.path() / "zero.png").c_str(), S_IFCHR | 0666, makedev(1, 5)), 0);
    ASSERT_EQ(::mknod((content.path() / "console.png").c_str(), S_IFCHR | 0666, makedev(5, 0)), 0);
    ASSERT_EQ(::mkfifo((content.path() / "pipe.png").c_str(), 0644), 0);
    make_image();
    const MountedImage mounted(image, mount_point.path(), options());
    ASSERT_TRUE(mounted.is_mounted());
    const auto listing = import.list(mount_point.root());
    ASSERT_TRUE(listing.has_value());
    ASSERT_EQ(listing->entries.size(), 1U);
    EXPECT_EQ(listing->entries[0].name, "tool.png");
    for (const char* name : {"link.png", "up.png", "zero.png", "console.png", "pipe.png"})
        EXPECT_EQ(import.read(mount_point.root(), picture(name)).error(), StickRefusal::no_file)
            << name;
    EXPECT_FALSE(std::ifstream(mount_point.path() / "link.png").is_open());  // nosymfollow
    EXPECT_FALSE(std::ifstream(mount_point.path() / "zero.png").is_open());  // nodev
    EXPECT_FALSE(does((mount_point.path() / "tool.png").string()));          // noexec
}

TEST_F(MountedStick, AMountOnAFolderOfItIsNotEntered) {
    if (!may_mount()) return;
    content.folder("inner");
    content.file("boat.png");
    make_image();
    StickFolder other;
    other.file("secret.png", "secret");
    const MountedImage mounted(image, mount_point.path(), options());
    ASSERT_TRUE(mounted.is_mounted());
    const std::string inner = mount_point.root() + "/inner";
    ASSERT_TRUE(does("mount --bind " + other.root() + " " + inner));
    const auto listing = import.list(mount_point.root());
    const auto secret =
        import.read(mount_point.root(), {StickFileKind::picture, "inner", "secret.png"});
    ASSERT_TRUE(does("umount " + inner));
    ASSERT_TRUE(listing.has_value());
    EXPECT_EQ(listing->entries.size(), 1U);
    EXPECT_TRUE(listing->rest.has_unreadable);
    EXPECT_EQ(secret.error(), StickRefusal::no_file);
}

TEST_F(MountedStick, PulledOutInTheMidstIsOneRefusalAndTheNextWorks) {
    if (!may_mount()) return;
    content.file("boat.png", std::string(3'000'000, 'b'));
    make_image();
    const fs::path spare = desk.path() / "spare";
    fs::copy_file(image, spare);
    {
        const MountedImage mounted(image, mount_point.path(), options());
        ASSERT_TRUE(mounted.is_mounted());
        ASSERT_TRUE(import.list(mount_point.root()).has_value());
        fs::resize_file(image, 0);  // from now on the device gives only errors
        const auto refused = import.read(mount_point.root(), picture("boat.png"));
        ASSERT_FALSE(refused.has_value());
        EXPECT_EQ(refused.error(), StickRefusal::unreadable);
    }
    EXPECT_EQ(import.read(mount_point.root(), picture("boat.png")).error(),
              StickRefusal::no_such_file);
    const MountedImage mounted(spare, mount_point.path(), options());
    ASSERT_TRUE(mounted.is_mounted());
    EXPECT_TRUE(import.read(mount_point.root(), picture("boat.png")).has_value());
}

TEST_F(MountedStick, OneThatHoldsTheImportForEverIsLeftBehind) {
    if (!may_mount()) return;
    StickImport hasty(TOUCHLINE_IMPORT, {1.0, 60.0});
    HungStick hung(mount_point.path());
    ASSERT_TRUE(hung.is_mounted());
    EXPECT_EQ(hasty.list(mount_point.root()).error(), StickRefusal::out_of_time);
    EXPECT_EQ(hasty.left_behind(), 1U);
    // Meanwhile the next stick works.
    content.file("boat.png");
    EXPECT_TRUE(hasty.read(content.root(), picture("boat.png")).has_value());
    EXPECT_EQ(hasty.left_behind(), 1U);
    hung.pull_out();
    for (int i = 0; hasty.left_behind() > 0 && i < 1000; ++i)
        (void)hasty.read(content.root(), picture("boat.png"));
    EXPECT_EQ(hasty.left_behind(), 0U);
}

}  // namespace
}  // namespace touchline
