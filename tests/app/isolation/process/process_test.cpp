#include "app/isolation/process/child.h"
#include "app/isolation/process/memory.h"
#include "app/isolation/process/places.h"
#include "tests/config/scratch_folder.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/mman.h>
#include <unistd.h>

namespace touchline {
namespace {

std::vector<std::byte> some_bytes() {
    return {std::byte{1}, std::byte{2}, std::byte{3}};
}

TEST(Memory, GivesBackWhatWasSealedAndNobodyCanChangeIt) {
    const Descriptor memory = sealed_copy(some_bytes()).value();
    const auto mapping = map_sealed(memory, 3);
    ASSERT_TRUE(mapping.has_value());
    EXPECT_TRUE(std::ranges::equal(mapping->bytes(), some_bytes()));
    EXPECT_FALSE(map_sealed(memory, 2).has_value());
    EXPECT_LT(write(memory.number(), "x", 1), 0);
    EXPECT_NE(ftruncate(memory.number(), 1), 0);
    EXPECT_EQ(mmap(nullptr, 1, PROT_WRITE, MAP_SHARED, memory.number(), 0), MAP_FAILED);
}

TEST(Memory, WhatIsNotSealedIsRefused) {
    const Descriptor open = fresh_memory().value();
    ASSERT_EQ(ftruncate(open.number(), 100), 0);
    EXPECT_FALSE(map_sealed(open, 1000).has_value());
    EXPECT_FALSE(map_shared(open).has_value());
    EXPECT_FALSE(map_sealed(Descriptor{}, 1000).has_value());
    EXPECT_FALSE(map_sealed(memory_of_size(100).value(), 1000).has_value());
}

TEST(Memory, IsNotSealedUnderAWriter) {
    const Descriptor memory = fresh_memory().value();
    ASSERT_EQ(ftruncate(memory.number(), 4096), 0);
    void* const page = mmap(nullptr, 4096, PROT_WRITE, MAP_SHARED, memory.number(), 0);
    EXPECT_FALSE(seal(memory).has_value());
    munmap(page, 4096);
    EXPECT_TRUE(seal(memory).has_value());
}

/// Returns what `script` wrote into the second of two descriptors, and how it ended. The first
/// descriptor holds `text_in`.
std::pair<std::string, ChildEnd> run(const std::string& script, bool is_swapped) {
    const std::string text_in = "hello\n";
    Descriptor first = sealed_copy(std::as_bytes(std::span(text_in))).value();
    Descriptor second = fresh_memory().value();
    // These numbers cross those in the child.
    if (is_swapped) {
        const int low = dup(second.number());
        const int high = dup(first.number());
        first = Descriptor(high);
        second = Descriptor(low);
    }
    lseek(first.number(), 0, SEEK_SET);
    Child child =
        Child::start("/bin/sh", {"-c", script}, std::array<const Descriptor*, 2>{&first, &second})
            .value();
    pollfd dead{child.pidfd().number(), POLLIN, 0};
    poll(&dead, 1, 10'000);
    const ChildEnd end = child.reap();
    std::array<char, 100> text{};
    const ssize_t size = pread(second.number(), text.data(), text.size(), 0);
    return {std::string(text.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))), end};
}

TEST(Child, IsHandedItsDescriptorsAndNoOther) {
    const Descriptor other(::open("/dev/null", O_RDONLY));
    for (const bool is_swapped : {false, true}) {
        const auto [text, end] = run("cat <&3 >&4; ls /proc/self/fd | wc -l >&4", is_swapped);
        EXPECT_EQ(text, "hello\n6\n");  // 0 to 4, and the folder that ls reads
        EXPECT_TRUE(end.is_good());
    }
}

TEST(Child, HasOurEnvironmentButForItsSettings) {
    setenv("TOUCHLINE_TEST_OURS", "kept", 1);
    setenv("TOUCHLINE_TEST_BOTH", "old", 1);
    const Descriptor output = fresh_memory().value();
    const std::string script =
        "printf '%s %s' \"$TOUCHLINE_TEST_OURS\" \"$TOUCHLINE_TEST_BOTH\" >&3";
    Child child = Child::start("/bin/sh", {"-c", script}, std::array<const Descriptor*, 1>{&output},
                               StandardStreams::nothing, {"TOUCHLINE_TEST_BOTH=new"})
                      .value();
    EXPECT_TRUE(child.reap().is_good());
    std::array<char, 20> text{};
    EXPECT_EQ(pread(output.number(), text.data(), text.size() - 1, 0), 8);
    EXPECT_STREQ(text.data(), "kept new");
}

TEST(Child, TellsHowItEnded) {
    EXPECT_EQ(run("exit 3", false).second, (ChildEnd{3, 0}));
    EXPECT_EQ(run("kill -9 $$", false).second, (ChildEnd{0, 9}));
    EXPECT_FALSE(Child::start("/no/such/program", {}, {}).has_value());
}

TEST(Places, WhatIsInstalledBesideTheProgramComesBeforeWhatWasBuilt) {
    const ScratchFolder scratch;
    const std::filesystem::path installed = scratch.path() / "installed";
    const std::string beside = std::filesystem::relative(installed, own_folder()).string();
    EXPECT_EQ(installed_place(beside, "/built/from"), "/built/from");
    std::filesystem::create_directories(installed);
    EXPECT_TRUE(std::filesystem::equivalent(installed_place(beside, "/built/from"), installed));
}

TEST(Places, AUsersSettingsAreWhereTheSystemSaysElseInTheHomeElseTheMachines) {
    // NOLINTBEGIN(concurrency-mt-unsafe)
    setenv("XDG_CONFIG_HOME", "/settings", 1);
    setenv("HOME", "/someone", 1);
    EXPECT_EQ(user_settings_folder(), "/settings");
    unsetenv("XDG_CONFIG_HOME");
    EXPECT_EQ(user_settings_folder(), "/someone/.config");
    unsetenv("HOME");
    EXPECT_EQ(user_settings_folder(), "/etc");
    // NOLINTEND(concurrency-mt-unsafe)
}

}  // namespace
}  // namespace touchline
