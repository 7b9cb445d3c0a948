// Tests untrusted zip files with the worker: what is accepted, and what is refused with which
// words.
#include "app/documents/packs/pack.h"
#include "app/documents/packs/unpacking.h"
#include "audio-cues/words/language.h"
#include "tests/app/documents/decode/liar_in_place.h"
#include "tests/app/documents/packs/made_packs.h"
#include "tests/config/mutated.h"

#include <chrono>
#include <cstdlib>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using made::Member;

std::vector<Member> with(Member member) {
    auto members = made::small_pack();
    members.push_back(std::move(member));
    return members;
}

Member named(const std::string& name) {
    Member member;
    member.name = name;
    member.contents = "text";
    return member;
}

void expect_refused(const std::vector<Member>& members, FindingKind kind) {
    const auto files = unpack_zip(made::zip(members));
    ASSERT_FALSE(files.has_value()) << members.back().name;
    EXPECT_EQ(static_cast<int>(files.error().kind), static_cast<int>(kind))
        << members.back().name << ": " << sentence_of(files.error(), Language());
    EXPECT_TRUE(is_one_sentence(sentence_of(files.error(), Language())));
}

TEST(Zip, OfAGoodPackIsTaken) {
    const auto pack = read_pack(made::zip(made::small_pack()));
    ASSERT_TRUE(pack.has_value()) << sentence_of(pack.error(), Language());
    EXPECT_EQ(pack->info.id, "small");
    EXPECT_EQ(pack->files.size(), 2U);
}

TEST(Zip, DeflatedWithAFolderAroundAndLitterIsTaken) {
    auto members = made::small_pack();
    for (Member& member : members) {
        member.name = "My pack/" + member.name;
        member.is_deflated = true;
    }
    Member folder;
    folder.name = "My pack/";
    folder.attributes = 040755U << 16U | 0x10U;
    members.insert(members.begin(), folder);
    members.push_back(named("__MACOSX/My pack/._a.svg"));
    members.push_back(named("My pack/.DS_Store"));
    const auto pack = read_pack(made::zip(members));
    ASSERT_TRUE(pack.has_value()) << sentence_of(pack.error(), Language());
    EXPECT_NE(find_file(*pack, "a.svg"), nullptr);
    EXPECT_EQ(pack->files.size(), 2U);
}

TEST(Zip, NamesThatLeadOutAreRefused) {
    for (const char* name : {"../a.txt", "b/../../a.txt", "/etc/a.txt", "b/..", "..\\a.txt",
                             "b\\a.txt", "C:/a.txt", "c:a.txt"})
        expect_refused(with(named(name)), FindingKind::leads_outside);
}

TEST(Zip, NamesThatAreNotPlainAreRefused) {
    using namespace std::string_literals;
    for (const auto& name : {"a\0b.txt"s, "a.txt\0"s, "\xff\xfe.txt"s, "\xc3\x28.txt"s,
                             "\xc0\xae\xc0\xae/a.txt"s, "a\nb.txt"s, "\x1b[2J.txt"s, ".hidden.txt"s,
                             "a//b.txt"s, "./a.txt"s, ""s, "a*.txt"s, "\xe2\x80\xae.txt"s, "a. "s})
        expect_refused(with(named(name)), FindingKind::name_not_plain);
}

TEST(Zip, NamesThatAreTooLongOrDeepAreRefused) {
    expect_refused(with(named(std::string(204, 'a'))), FindingKind::name_too_long);
    expect_refused(with(named("a/b/c/d/e.txt")), FindingKind::too_deep);
}

TEST(Zip, LinksAndDevicesAreRefused) {
    Member link = named("link.txt");
    link.contents = "/etc/passwd";
    link.attributes = 0120777U << 16U;
    expect_refused(with(link), FindingKind::link);
    link.made_by = 19;
    expect_refused(with(link), FindingKind::link);
    for (const std::uint32_t type : {0020000U, 0060000U, 0010000U, 0140000U}) {
        Member device = named("device.txt");
        device.attributes = (type | 0666U) << 16U;
        expect_refused(with(device), FindingKind::no_file);
    }
}

TEST(Zip, NamesThatAreThereTwiceAreRefused) {
    expect_refused(with(named("a.svg")), FindingKind::twice);
    expect_refused(with(named("A.SVG")), FindingKind::twice);
}

TEST(Zip, ListAndMemberThatDisagreeAreRefused) {
    Member two_faced = named("b.txt");
    two_faced.local_name = "c.txt";
    expect_refused(with(two_faced), FindingKind::damaged_zip);
}

TEST(Zip, LockedMembersAreRefused) {
    Member locked = named("b.txt");
    locked.flags = 1;
    expect_refused(with(locked), FindingKind::locked);
    locked.flags = 1U | 1U << 6U;
    expect_refused(with(locked), FindingKind::locked);
}

TEST(Zip, PackedFilesInsideAreRefusedWhateverTheirName) {
    Member inner = named("inner.txt");
    inner.contents = made::text_of(made::zip(made::small_pack()));
    expect_refused(with(inner), FindingKind::nested);
    inner.contents = "\x1f\x8b\x08 gzip";
    expect_refused(with(inner), FindingKind::nested);
    inner.contents = std::string(257, 'x') + "ustar";
    expect_refused(with(inner), FindingKind::nested);
}

TEST(Zip, OtherKindsOfFilesAreRefused) {
    for (const char* name : {"run.exe", "page.html", "picture.png", "other.toml", "noending"})
        expect_refused(with(named(name)), FindingKind::odd_kind);
}

TEST(Zip, ManyFilesAreRefused) {
    std::vector<Member> members;
    for (std::size_t i = 0; i <= pack_limits.files; ++i)
        members.push_back(named("f" + std::to_string(i) + ".txt"));
    expect_refused(members, FindingKind::too_many_files);
}

TEST(Zip, NoiseIsNoZip) {
    for (const char* noise : {"x", "not a zip file at all", "PK"}) {
        const auto files = unpack_zip(made::bytes_of(noise));
        ASSERT_FALSE(files.has_value());
        EXPECT_EQ(files.error().kind, FindingKind::no_zip);
    }
    EXPECT_EQ(unpack_zip({}).error().kind, FindingKind::empty);
}

/// Expects no effect on the kiosk's memory, and little time.
void expect_no_harm(const made::Bytes& bytes, FindingKind kind) {
    (void)unpack_zip(made::bytes_of("warm"));
    const long before_kB = resident_kB();
    const int descriptors = open_descriptors();
    const auto start = std::chrono::steady_clock::now();
    const auto files = unpack_zip(bytes);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    ASSERT_FALSE(files.has_value());
    EXPECT_EQ(static_cast<int>(files.error().kind), static_cast<int>(kind));
    EXPECT_LT(resident_kB() - before_kB, 1024);
    EXPECT_EQ(open_descriptors(), descriptors);
    EXPECT_FALSE(has_a_child());
    EXPECT_LT(took.count(), 2000.0);
    std::printf("%zu bytes: %.1f ms\n", bytes.size(), took.count());
}

TEST(Bombs, ThatSayTheirSizeAreRefusedByTheList) {
    expect_no_harm(made::zip(with(made::zeros("a.txt", pack_limits.file_bytes + 1))),
                   FindingKind::file_too_large);
    std::vector<Member> many = made::small_pack();
    for (int i = 0; i < 8; ++i)
        many.push_back(made::zeros("z" + std::to_string(i) + ".txt", pack_limits.file_bytes));
    expect_no_harm(made::zip(many), FindingKind::all_too_large);
}

/// More bytes come than the list says: none of them is kept.
TEST(Bombs, ThatLieAboutTheirSizeAreRefused) {
    Member liar = made::zeros("a.txt", std::size_t{64} << 20U);
    liar.claimed_bytes = 10;
    expect_no_harm(made::zip(with(liar)), FindingKind::damaged_zip);
}

TEST(Worker, ThatIsNotThereIsSaid) {
    const LiarInPlace nothing("/nowhere");
    EXPECT_EQ(unpack_zip(made::zip(made::small_pack())).error().kind, FindingKind::no_worker);
}

TEST(Mutations, OfAZipAreFilesOrOneSentence) {
    std::mt19937 random(2026);
    auto members = made::small_pack();
    members[1].is_deflated = true;
    const auto bytes = made::zip(members);
    const int count = made::mutation_count(60);
    int taken = 0;
    for (int i = 0; i < count; ++i) {
        const auto files = unpack_zip(mutated(bytes, random));
        taken += files ? 1 : 0;
        ASSERT_TRUE(files || is_one_sentence(sentence_of(files.error(), Language()))) << i;
        ASSERT_TRUE(files || files.error().kind != FindingKind::harmful) << i;
    }
    std::printf("%d of %d taken\n", taken, count);
}

TEST(Export, ReadAgainIsTheSameBitForBit) {
    const auto pack = read_pack(made::example_pack());
    ASSERT_TRUE(pack.has_value()) << sentence_of(pack.error(), Language());
    const auto zip = zip_of(*pack);
    ASSERT_TRUE(zip.has_value()) << sentence_of(zip.error(), Language());
    const auto back = read_pack(*zip);
    ASSERT_TRUE(back.has_value()) << sentence_of(back.error(), Language());
    EXPECT_TRUE(*back == *pack);
    EXPECT_TRUE(zip_of(*back).value() == *zip);
}

/// The first day that a zip file can tell, and neither the user nor the machine's time zone.
TEST(Export, TellsNoDateAndNoOwner) {
    const auto pack = read_pack(made::zip(made::small_pack()));
    ASSERT_TRUE(pack.has_value());
    const std::string zip = made::text_of(zip_of(*pack).value());
    std::size_t members = 0;
    for (auto at = zip.find("PK\1\2"); at != std::string::npos; at = zip.find("PK\1\2", at + 4)) {
        EXPECT_EQ(zip.substr(at + 10, 2), std::string("\0\0", 2)) << "stored, not packed";
        EXPECT_EQ(zip.substr(at + 12, 4), std::string("\0\0\x21\0", 4));
        ++members;
    }
    EXPECT_EQ(members, pack->files.size());
    ::setenv("TZ", "XST-9", 1);
    EXPECT_TRUE(made::text_of(zip_of(*pack).value()) == zip);
    ::unsetenv("TZ");
}

TEST(Export, WhatNoKioskWouldTakeIsRefused) {
    auto pack = read_pack(made::zip(made::small_pack()));
    ASSERT_TRUE(pack.has_value());
    for (const char* name : {"v.txt", "w.txt", "x.txt", "y.txt", "z.txt"})
        pack->files.push_back({name, std::vector<std::byte>(pack_limits.file_bytes)});
    const auto zip = zip_of(*pack);
    ASSERT_FALSE(zip.has_value());
    EXPECT_EQ(zip.error().kind, FindingKind::zip_too_large);
    EXPECT_EQ(zip.error().value, 64.0);
}

TEST(Export, WithoutTheWorkerIsSaid) {
    const auto pack = read_pack(made::zip(made::small_pack()));
    ASSERT_TRUE(pack.has_value());
    const LiarInPlace nothing("/nowhere");
    EXPECT_EQ(zip_of(*pack).error().kind, FindingKind::no_worker);
}

}  // namespace
}  // namespace touchline
