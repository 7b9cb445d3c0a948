#include "app/documents/models/networks.h"

#include "tests/config/scratch_folder.h"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

/// A network whose file holds "abc", in a separate folder.
class Networks : public ::testing::Test {
  protected:
    Networks() {
        // NOLINTNEXTLINE(concurrency-mt-unsafe)
        ::setenv("TOUCHLINE_MODELS", folder_.path_of("models").c_str(), 1);
    }

    ~Networks() override {
        ::unsetenv("TOUCHLINE_MODELS");  // NOLINT(concurrency-mt-unsafe)
    }

    fs::path write(const std::string& name, const std::string& text) const {
        return folder_.write(name, text);
    }

    static void expect_line(const Error& error, const std::string& part) {
        EXPECT_NE(error.line.find(part), std::string::npos) << error.line;
        EXPECT_NE(error.line.find("touchline models get small"), std::string::npos) << error.line;
        EXPECT_EQ(error.line.find('\n'), std::string::npos);
    }

    ScratchFolder folder_;
    const Network small_{
        .name = "small",
        .file = "small.onnx",
        .bytes = 3,
        .sha256 = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"};
};

TEST_F(Networks, TheTableNamesEachOnceWithItsLicenceAndSums) {
    std::set<std::string_view> names;
    for (const Network& network : networks()) {
        EXPECT_TRUE(names.insert(network.name).second);
        EXPECT_EQ(network_named(network.name), &network);
        EXPECT_EQ(network.sha256.size(), 64U);
        EXPECT_FALSE(network.licence.empty() || network.note.empty() || network.version.empty());
        if (network.package.empty()) continue;  // trained for Touchline
        EXPECT_EQ(network.package_sha256.size(), 64U);
        EXPECT_TRUE(fs::exists(fs::path(TOUCHLINE_SOURCE_DIR) / "app/documents/models" /
                               network.converter));
    }
    EXPECT_EQ(network_named("nobody"), nullptr);
}

TEST_F(Networks, WhatShipsIsWholeAndItsPageTellsWhereItComesFrom) {
    const fs::path folder = fs::path(TOUCHLINE_SOURCE_DIR) / "app/documents/models/shipped";
    std::ifstream file(folder / "README.md");
    const std::string page(std::istreambuf_iterator<char>(file), {});
    std::set<std::string_view> shipped;
    for (const Network& network : networks()) {
        if (!network.ships) continue;
        shipped.insert(network.name);
        EXPECT_TRUE(fs::equivalent(installed_file(network), folder / network.file));
        const auto bytes = read_network(network);
        ASSERT_TRUE(bytes) << bytes.error().line;
        EXPECT_EQ(network_of(*bytes), nullptr) << "nobody brings " << network.name;
        for (const std::string_view told : {network.file, network.package, network.version,
                                            network.package_sha256, network.licence})
            EXPECT_NE(page.find(told), std::string::npos) << told;
    }
    EXPECT_EQ(shipped, (std::set<std::string_view>{"blazeface", "facemesh", "nanodet", "selfie",
                                                   "small-figure"}));
}

TEST_F(Networks, OneThatShipsAndIsAbsentOrDamagedIsForWhoeverInstalls) {
    Network network = *network_named("selfie");
    network.sha256 = small_.sha256;
    const auto damaged = read_network(network);
    ASSERT_FALSE(damaged);
    EXPECT_EQ(damaged.error().line,
              installed_file(network).string() +
                  ": the network is damaged, or of another version; install Touchline anew");
    network.file = "absent.onnx";
    const auto absent = read_network(network);
    ASSERT_FALSE(absent);
    EXPECT_EQ(absent.error().line,
              "the network \"selfie\" is not installed here; install Touchline anew");
}

TEST_F(Networks, OneThatIsAbsentDamagedOrOfAnotherVersionIsOneLine) {
    EXPECT_FALSE(is_installed(small_));
    expect_line(read_network(small_).error(), "not installed here");
    for (const std::string wrong : {"", "ab", "abd", "abcd"}) {
        write("models/small.onnx", wrong);
        EXPECT_TRUE(is_installed(small_));
        expect_line(read_network(small_).error(), "damaged, or of another version");
    }
    write("models/small.onnx", "abc");
    EXPECT_EQ(read_network(small_)->size(), 3U);
}

TEST_F(Networks, AFileThatSomebodyBringsIsTakenByItsSum) {
    const std::array<std::byte, 3> abc{std::byte{'a'}, std::byte{'b'}, std::byte{'c'}};
    EXPECT_EQ(network_of(abc), nullptr);
    EXPECT_EQ(network_of(abc, {&small_, 1}), &small_);
    EXPECT_EQ(network_of(std::span(abc).first(2), {&small_, 1}), nullptr);
    EXPECT_EQ(network_of(std::vector<std::byte>(networks().front().bytes)), nullptr);
    ASSERT_TRUE(install_network(small_, abc));
    EXPECT_EQ(*read_network(small_), std::vector(abc.begin(), abc.end()));
}

/// A fake npm gives an archive that is not the publisher's.
TEST_F(Networks, WhereItCannotBeGotNothingIsLeft) {
    const fs::path npm = write("bin/npm", "#!/bin/sh\necho other > other.tgz; echo other.tgz\n");
    fs::permissions(npm, fs::perms::owner_all);
    const std::string path = ::getenv("PATH");  // NOLINT(concurrency-mt-unsafe)
    // NOLINTNEXTLINE(concurrency-mt-unsafe)
    ::setenv("PATH", (folder_.path_of("bin") + ":" + path).c_str(), 1);
    testing::internal::CaptureStderr();
    EXPECT_FALSE(get_network(networks().front()));
    const std::string said = testing::internal::GetCapturedStderr();
    ::setenv("PATH", path.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
    // NOLINTNEXTLINE(concurrency-mt-unsafe,cert-env33-c)
    const bool can_rewrite = std::system("/usr/bin/python3 -c 'import numpy, onnx' 2>&-") == 0;
    EXPECT_EQ(said, can_rewrite
                        ? "the package is not the one that was tried: its checksum differs\n"
                        : "what rewrites the network is missing: install the packages "
                          "python3-onnx and python3-numpy\n");
    EXPECT_TRUE(fs::is_empty(models_folder()));
}

}  // namespace
}  // namespace touchline
