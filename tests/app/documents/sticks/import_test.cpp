// Tests the kiosk's side and the program together.
#include "app/documents/sticks/import.h"

#include "app/documents/decode/opening.h"
#include "app/isolation/process/memory.h"
#include "app/isolation/sandbox/limits.h"
#include "tests/app/documents/sticks/stick_folder.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

std::string text_of(const Descriptor& memory) {
    const auto mapping = map_sealed(memory, std::size_t{256} << 20U);
    if (!mapping) return "not sealed";
    return {reinterpret_cast<const char*>(mapping->bytes().data()), mapping->bytes().size()};
}

std::size_t open_descriptors() {
    const fs::directory_iterator all("/proc/self/fd");
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

StickEntry picture(std::string folder, std::string name) {
    return {StickFileKind::picture, std::move(folder), std::move(name)};
}

class StickImportTest : public testing::Test {
  protected:
    StickFolder stick;
    StickImport import{TOUCHLINE_IMPORT, {60.0, 60.0}};
};

TEST_F(StickImportTest, ListsAndReads) {
    stick.folder("day 2");
    stick.file("day 2/boat \n\x1b[2J.png", "picture");
    stick.file("a.pdf", "document");
    const auto listing = import.list(stick.root());
    ASSERT_TRUE(listing.has_value());
    ASSERT_EQ(listing->entries.size(), 2U);
    EXPECT_EQ(listing->rest, StickRest{});
    const auto first = import.read(stick.root(), listing->entries[0]);
    const auto second = import.read(stick.root(), listing->entries[1]);
    ASSERT_TRUE(first.has_value() && second.has_value());
    EXPECT_EQ(text_of(*first), "document");
    EXPECT_EQ(text_of(*second), "picture");
}

TEST_F(StickImportTest, ACamerasCardIsReadFolderByFolder) {
    for (const char* folder : {"DCIM/100CANON", "DCIM/101CANON", "DCIM/a/b/c/d/e/f/g"}) {
        stick.folder(folder);
        stick.file(std::string(folder) + "/IMG_0001.JPG", folder);
    }
    const auto listing = import.list(stick.root());
    ASSERT_TRUE(listing.has_value());
    ASSERT_EQ(listing->entries.size(), 3U);
    EXPECT_EQ(listing->rest, StickRest{});
    for (const StickEntry& entry : listing->entries) {
        const auto bytes = import.read(stick.root(), entry);
        ASSERT_TRUE(bytes.has_value()) << entry.folder;
        EXPECT_EQ(text_of(*bytes), entry.folder);
    }
}

TEST_F(StickImportTest, ListsAndReadsPacksForTheOperator) {
    stick.file("castles.zip", "a pack");
    stick.file("a.png");
    const auto packs = import.list_operator_files(stick.root());
    ASSERT_TRUE(packs.has_value());
    ASSERT_EQ(packs->entries.size(), 1U);
    const auto bytes = import.read(stick.root(), packs->entries[0]);
    ASSERT_TRUE(bytes.has_value());
    EXPECT_EQ(text_of(*bytes), "a pack");
    EXPECT_EQ(import.list_operator_files(stick.root() + "/gone").error(), StickRefusal::gone);
}

TEST_F(StickImportTest, ReadsTheTextBesideAPicture) {
    stick.file("boat.png");
    stick.file("boat.txt", "A boat with two sails");
    stick.file("long.png");
    stick.file("long.txt", std::string(max_side_car_bytes + 1, 'w'));
    stick.file("bare.png");
    const auto text = import.read_side_car(stick.root(), picture("", "boat.png"));
    ASSERT_TRUE(text.has_value());
    EXPECT_EQ(text_of(*text), "A boat with two sails");
    EXPECT_EQ(import.read_side_car(stick.root(), picture("", "long.png")).error(),
              StickRefusal::too_large);
    EXPECT_EQ(import.read_side_car(stick.root(), picture("", "bare.png")).error(),
              StickRefusal::no_such_file);
}

TEST_F(StickImportTest, EachRefusalArrives) {
    stick.file("empty.png", "");
    stick.file("large.png");
    fs::resize_file(stick.path() / "large.png", most_bytes_of(StickFileKind::picture) + 1);
    fs::create_symlink("/etc/passwd", stick.path() / "link.png");
    ASSERT_EQ(::mkfifo((stick.path() / "pipe.png").c_str(), 0644), 0);
    const auto refusal = [this](const char* name) {
        return import.read(stick.root(), picture("", name)).error();
    };
    EXPECT_EQ(refusal("empty.png"), StickRefusal::empty);
    EXPECT_EQ(refusal("large.png"), StickRefusal::too_large);
    EXPECT_EQ(refusal("link.png"), StickRefusal::no_file);
    EXPECT_EQ(refusal("pipe.png"), StickRefusal::no_file);
    EXPECT_EQ(refusal("none.png"), StickRefusal::no_such_file);
    EXPECT_EQ(refusal("../empty.png"), StickRefusal::no_such_file);
    EXPECT_EQ(import.list(stick.root() + "/gone").error(), StickRefusal::gone);
}

TEST_F(StickImportTest, TheLargestFileThatMayBeIsRead) {
    stick.file("large.png");
    const std::size_t bytes = most_bytes_of(StickFileKind::picture);
    EXPECT_EQ(bytes, limits_of(WorkerKind::raster).input_bytes);
    fs::resize_file(stick.path() / "large.png", bytes);
    const auto memory = import.read(stick.root(), picture("", "large.png"));
    ASSERT_TRUE(memory.has_value());

    struct stat status {};

    ASSERT_EQ(::fstat(memory->number(), &status), 0);
    EXPECT_EQ(static_cast<std::size_t>(status.st_size), bytes);
}

TEST_F(StickImportTest, AProgramThatIsMissingOrLiesIsOneRefusal) {
    EXPECT_EQ(StickImport("/nowhere/touchline-import").list(stick.root()).error(),
              StickRefusal::not_started);
    EXPECT_EQ(StickImport("/bin/true").list(stick.root()).error(), StickRefusal::unreadable);
    EXPECT_EQ(StickImport("/bin/false").list(stick.root()).error(), StickRefusal::unreadable);
    stick.file("fake.png", "no listing at all");
    EXPECT_EQ(StickImport(TOUCHLINE_LYING_IMPORT).list(stick.root()).error(),
              StickRefusal::unreadable);
}

TEST_F(StickImportTest, OneThatTheKernelKillsRanOutOfMemory) {
    EXPECT_EQ(StickImport(TOUCHLINE_LYING_IMPORT).read(stick.root(), picture("", "killed")).error(),
              StickRefusal::out_of_memory);
}

TEST_F(StickImportTest, OneThatNeverEndsIsEnded) {
    StickImport hanging(TOUCHLINE_LYING_IMPORT, {0.05, 0.05});
    EXPECT_EQ(hanging.read(stick.root(), picture("", "hang")).error(), StickRefusal::out_of_time);
    for (int i = 0; hanging.left_behind() > 0 && i < 1000; ++i) (void)hanging.list(stick.root());
    EXPECT_EQ(hanging.left_behind(), 0U);  // on a busy machine it takes a while to die
}

/// A hundred thousand files are listed within little memory. They lie in memory, since a busy disk
/// takes minutes to make so many.
TEST_F(StickImportTest, MemoryDoesNotGrowWithTheStick) {
    const StickFolder many("/dev/shm");
    many.files("f", 100'000);
    const auto listing = import.list(many.root());
    ASSERT_TRUE(listing.has_value());
    EXPECT_EQ(listing->entries.size(), most_listed);
    if (!listing->rest.is_cut_short) {
        EXPECT_EQ(listing->rest.not_listed, 100'000U - most_listed);
        EXPECT_EQ(listing->entries[9999].name, "f9999.png");
    }
    EXPECT_NE(listing->rest, StickRest{});
    rusage use{};
    ASSERT_EQ(::getrusage(RUSAGE_CHILDREN, &use), 0);
    EXPECT_LT(use.ru_maxrss, 50 * 1024);  // kB
}

TEST_F(StickImportTest, AThousandFilesLeaveNothingBehind) {
    stick.file("a.png");
    ASSERT_TRUE(import.list(stick.root()).has_value());
    const std::size_t before = open_descriptors();
    for (int i = 0; i < 1000; ++i)
        ASSERT_TRUE(import.read(stick.root(), picture("", "a.png")).has_value());
    EXPECT_EQ(open_descriptors(), before);
    EXPECT_EQ(import.left_behind(), 0U);
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);  // no child at all, so no zombie either
}

}  // namespace
}  // namespace touchline
