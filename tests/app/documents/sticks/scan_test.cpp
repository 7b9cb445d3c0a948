#include "app/documents/sticks/stick_reading.h"
#include "tests/app/documents/sticks/stick_folder.h"

#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

StickListing scan(const StickFolder& stick, const ScanLimits& limits = {},
                  StickSearch search = StickSearch::pictures) {
    const auto listing = scan_stick(stick.open(), NaturalOrder(), limits, search);
    EXPECT_TRUE(listing.has_value());
    return listing.value_or(StickListing{});
}

/// Returns "folder/name" of each.
std::vector<std::string> paths_of(const StickListing& listing) {
    std::vector<std::string> paths;
    for (const StickEntry& entry : listing.entries)
        paths.push_back(entry.folder.empty() ? entry.name : entry.folder + "/" + entry.name);
    return paths;
}

using Paths = std::vector<std::string>;

TEST(StickScan, ListsAFoldersFilesThenItsFoldersInNaturalOrder) {
    const StickFolder stick;
    for (const char* name :
         {"boat 10.png", "boat 9.png", "notes.txt", "letter.docx", ".hidden.png"})
        stick.file(name);
    for (const char* name : {"day 10", "day 2", "day 2/deeper", ".Trash", "day 10/.thumbnails",
                             "System Volume Information", "DCIM/100CANON", "DCIM/101CANON"})
        stick.folder(name);
    for (const char* name :
         {"day 10/a.png", "day 2/c.pdf", "day 2/b.jpg", "day 2/deeper/d.png", ".Trash/no.png",
          "day 10/.thumbnails/no.jpg", "System Volume Information/no.png",
          "DCIM/101CANON/IMG_0001.JPG", "DCIM/100CANON/IMG_0002.JPG"})
        stick.file(name);
    const StickListing listing = scan(stick);
    EXPECT_EQ(paths_of(listing),
              (Paths{"boat 9.png", "boat 10.png", "letter.docx", "day 2/b.jpg", "day 2/c.pdf",
                     "day 2/deeper/d.png", "day 10/a.png", "DCIM/100CANON/IMG_0002.JPG",
                     "DCIM/101CANON/IMG_0001.JPG"}));
    EXPECT_EQ(listing.entries[2].kind, StickFileKind::office);
    EXPECT_EQ(listing.rest, StickRest{});
}

TEST(StickScan, PassesOverEverythingThatIsNoFile) {
    const StickFolder stick;
    const StickFolder elsewhere;
    elsewhere.file("secret.png");
    stick.file("boat.png");
    fs::create_symlink("/etc/passwd", stick.path() / "link.png");
    fs::create_symlink("loop.png", stick.path() / "loop.png");
    fs::create_directory_symlink(elsewhere.path(), stick.path() / "linked");
    fs::create_directory_symlink("..", stick.path() / "up");
    stick.folder("folder.png");
    ASSERT_EQ(::mkfifo((stick.path() / "pipe.png").c_str(), 0644), 0);
    const Descriptor socket(::socket(AF_UNIX, SOCK_STREAM, 0));
    sockaddr_un address{AF_UNIX, {}};
    std::strncpy(address.sun_path, (stick.path() / "socket.png").c_str(),
                 sizeof(address.sun_path) - 1);
    ASSERT_EQ(::bind(socket.number(), reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0);
    if (::geteuid() == 0) {
        ASSERT_EQ(::mknod((stick.path() / "tty.png").c_str(), S_IFCHR | 0644, makedev(5, 0)), 0);
        ASSERT_EQ(::mknod((stick.path() / "disk.png").c_str(), S_IFBLK | 0644, makedev(7, 0)), 0);
    }
    const StickListing listing = scan(stick);
    EXPECT_EQ(paths_of(listing), Paths{"boat.png"});
    EXPECT_EQ(listing.rest, StickRest{});
}

TEST(StickScan, HostileNamesAreListedAsTheyAre) {
    const StickFolder stick;
    const Paths names{"-rf.png",      "%s.png",        "a\nb.png", "\x1b[2J.png",
                      "\xff\xfe.png", "\u202egnp.png", "..a.png",  std::string(251, 'w') + ".png"};
    for (const std::string& name : names) stick.file(name);
    const StickListing listing = scan(stick);
    EXPECT_EQ(listing.entries.size(), names.size() - 1);  // "..a.png" is hidden
    for (const StickEntry& entry : listing.entries)
        EXPECT_NE(std::find(names.begin(), names.end(), entry.name), names.end());
    EXPECT_TRUE(listing_of(bytes_of(listing)).has_value());
}

/// One name for the eye, but two for the file system, which keeps both: letters with marks written
/// as one character or as two.
TEST(StickScan, NamesOfEveryLanguageAreListedByTheirBytes) {
    const StickFolder stick;
    const Paths names{"Fu\u00df b\u00e4r.png", "Fu\u00df ba\u0308r.png",
                      "\u05e9\u05dc\u05d5\u05dd.png"};
    for (const std::string& name : names) stick.file(name);
    for (const char* name : {"y.png.", "z.png "}) stick.file(name);
    Paths listed = paths_of(scan(stick));
    std::sort(listed.begin(), listed.end());
    Paths wanted = names;
    std::sort(wanted.begin(), wanted.end());
    EXPECT_EQ(listed, wanted);
}

TEST(StickScan, ShowsTheFirstTenThousandAndCountsTheRest) {
    const StickFolder stick("/dev/shm");
    stick.files("f", most_listed + 200);
    stick.folder("more");
    stick.file("more/a.png");
    const StickListing listing = scan(stick);
    ASSERT_EQ(listing.entries.size(), most_listed);
    EXPECT_EQ(listing.entries[10].name, "f10.png");
    EXPECT_EQ(listing.entries[9999].name, "f9999.png");
    EXPECT_EQ(listing.rest, (StickRest{201U, false, false, false}));
    EXPECT_TRUE(listing_of(bytes_of(listing)).has_value());
}

TEST(StickScan, LooksIntoNoMoreFoldersThanItMay) {
    const StickFolder stick;
    for (const char* name : {"1", "2", "3"}) {
        stick.folder(name);
        stick.file(std::string(name) + "/a.png");
    }
    ScanLimits limits;
    limits.most_folders = 2;
    const StickListing listing = scan(stick, limits);
    EXPECT_EQ(paths_of(listing), (Paths{"1/a.png", "2/a.png"}));
    EXPECT_EQ(listing.rest, (StickRest{0, false, false, true}));
    stick.folder("1/within");
    stick.file("1/within/b.png");
    EXPECT_EQ(paths_of(scan(stick, limits)), (Paths{"1/a.png", "1/within/b.png"}))
        << "folder by folder";
}

TEST(StickScan, EndsWithWhatItHasWhenTimeOrNamesAreUp) {
    const StickFolder stick;
    stick.files("f", 3000);
    stick.folder("later");
    stick.file("later/a.png");
    ScanLimits few;
    few.most_names = 100;  // the first block of names holds more
    const StickListing part = scan(stick, few);
    EXPECT_TRUE(part.rest.is_cut_short);
    EXPECT_FALSE(part.entries.empty());
    EXPECT_LT(part.entries.size() + part.rest.not_listed, 3000U);
    ScanLimits none;
    none.is_time_up = [] { return true; };
    const StickListing nothing = scan(stick, none);
    EXPECT_TRUE(nothing.entries.empty());
    EXPECT_TRUE(nothing.rest.is_cut_short);
}

TEST(StickScan, AFolderThatCannotBeReadIsPassedOver) {
    const StickFolder stick;
    for (const char* name : {"shut", "open"}) stick.folder(name);
    for (const char* name : {"shut/a.png", "open/a.png"}) stick.file(name);
    fs::permissions(stick.path() / "shut", fs::perms::none);
    const bool is_root = ::geteuid() == 0;
    ASSERT_TRUE(!is_root || ::seteuid(65534) == 0);  // permissions bind this user
    const StickListing listing = scan(stick);
    ASSERT_TRUE(!is_root || ::seteuid(0) == 0);
    fs::permissions(stick.path() / "shut", fs::perms::owner_all);
    EXPECT_EQ(paths_of(listing), Paths{"open/a.png"});
    EXPECT_EQ(listing.rest, (StickRest{0, false, true, false}));
}

TEST(StickScan, FoldersAreEnteredToDepthEightAndDeeperOnesTold) {
    const StickFolder stick;
    std::string deep = "1";
    stick.folder(deep);
    stick.file("1/a.png");
    for (int depth = 2; depth <= 8; ++depth) deep += '/' + std::to_string(depth);
    stick.folder(deep);
    stick.file(deep + "/b.png");
    const Paths found{"1/a.png", deep + "/b.png"};
    EXPECT_EQ(paths_of(scan(stick)), found);
    EXPECT_EQ(scan(stick).rest, StickRest{});
    stick.folder(deep + "/.hidden");
    EXPECT_EQ(scan(stick).rest, StickRest{});
    for (int i = 0; i < 100; ++i) deep += "/d";
    stick.folder(deep);
    stick.file(deep + "/no.png");
    EXPECT_EQ(paths_of(scan(stick)), found);
    EXPECT_EQ(scan(stick).rest, (StickRest{0, true, false, false}));
}

/// Each folder has 255 bytes: the kernel takes no longer path, and the rest is still listed.
TEST(StickScan, PathsAsLongAsTheyGetAreReadOrTold) {
    const StickFolder stick;
    std::string deep(255, 'd');
    for (int depth = 2; depth <= 8; ++depth) deep += '/' + std::string(255, 'e');
    stick.folder(deep);
    stick.file("a.png");
    Descriptor at(::open((stick.path() / deep).c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    ASSERT_TRUE(at.is_open());
    const std::string name = std::string(251, 'f') + ".png";
    ASSERT_TRUE(
        Descriptor(::openat(at.number(), name.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0644))
            .is_open());
    const StickListing listing = scan(stick);
    EXPECT_EQ(paths_of(listing), (Paths{"a.png", deep + "/" + name}));
    EXPECT_TRUE(listing_of(bytes_of(listing)).has_value());
}

TEST(StickScan, NamesAndPathsTakeNoMoreThanTheyMay) {
    const StickFolder stick("/dev/shm");
    std::string deep(255, 'd');
    for (int depth = 2; depth <= 8; ++depth) deep += '/' + std::string(255, 'e');
    stick.folder(deep);
    const Descriptor at(::open((stick.path() / deep).c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    for (int i = 0; i < 5000; ++i) {
        const std::string name = std::to_string(i) + std::string(200, 'f') + ".png";
        (void)Descriptor(::openat(at.number(), name.c_str(), O_CREAT | O_WRONLY, 0644));
    }
    const StickListing listing = scan(stick);
    EXPECT_EQ(listing.entries.size() + listing.rest.not_listed, 5000U);
    EXPECT_GT(listing.rest.not_listed, 0U);
    EXPECT_LT(bytes_of(listing).size(), std::size_t{9} << 20U);
}

TEST(StickScan, ARootThatIsGoneIsRefused) {
    const Descriptor nothing(::open("/dev/null", O_PATH | O_CLOEXEC));
    EXPECT_FALSE(scan_stick(nothing, NaturalOrder(), {}, StickSearch::pictures).has_value());
}

TEST(StickScan, ForTheOperatorFindsPacksInTheRootAlone) {
    const StickFolder stick;
    for (const char* name :
         {"b.zip", "A.ZIP", "a.png", ".hidden.zip", "zip", "a.zip.txt", "c.onnx"})
        stick.file(name);
    stick.folder("d.zip");
    stick.folder("d");
    stick.file("d/c.zip");
    fs::create_symlink("/etc/passwd", stick.path() / "link.zip");
    const StickListing packs = scan(stick, {}, StickSearch::operator_files);
    EXPECT_EQ(paths_of(packs), (Paths{"A.ZIP", "b.zip", "c.onnx"}));
    EXPECT_EQ(packs.entries[0].kind, StickFileKind::pack);
    EXPECT_EQ(packs.entries[2].kind, StickFileKind::network);
    EXPECT_EQ(paths_of(scan(stick)), Paths{"a.png"}) << "visitors are offered no packs";
}

}  // namespace
}  // namespace touchline
