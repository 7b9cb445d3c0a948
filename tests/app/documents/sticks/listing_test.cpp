#include "app/documents/sticks/listing.h"

#include "app/documents/sticks/names.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

using namespace std::string_literals;

TEST(StickFileKind, IsToldByTheEnding) {
    for (const char* name : {"a.png", "a.JPG", "b.c.jpeg", "IMG_1.HEIC", "a.tif", "a.pnm", "a.gif"})
        EXPECT_EQ(kind_of_name(name), StickFileKind::picture) << name;
    for (const char* name : {"a.pdf", "a.SVG", "a.svgz", "a.SVGZ"})
        EXPECT_EQ(kind_of_name(name), StickFileKind::document) << name;
    for (const char* name : {"a.docx", "a.PPTX", "a.odt", "a.pages"})
        EXPECT_EQ(kind_of_name(name), StickFileKind::office) << name;
    for (const char* name :
         {"a.txt", "a.mp4", "a.zip", "a.exe", "a", "", "png", ".png", "a.", "a.png "})
        EXPECT_EQ(kind_of_name(name), std::nullopt) << name;
}

TEST(StickFileKind, LeavesOutWhatIsHiddenOrOfSystems) {
    for (const char* name : {".", "..", ".boat.png", "._boat.png", "System Volume Information",
                             "$RECYCLE.BIN", "lost+found", "__MACOSX", "~$letter.docx", ""})
        EXPECT_TRUE(is_left_out(name)) << name;
    for (const char* name : {"boat.png", "a~.png", "$5.png", "lost", "DCIM"})
        EXPECT_FALSE(is_left_out(name)) << name;
}

TEST(NaturalOrder, IsAsPeopleCount) {
    const NaturalOrder order;
    const std::vector<std::string> wanted{
        "1.png",    "2.png",         "10.png",      "boat 9.png",   "Boat 10.png",
        "boot.png", "b\u00f6ot.png", "page 2b.png", "page 10a.png", "zebra.png"};
    std::vector<std::string> names = wanted;
    std::reverse(names.begin(), names.end());
    std::sort(names.begin(), names.end(),
              [&order](const auto& a, const auto& b) { return order.key_of(a) < order.key_of(b); });
    EXPECT_EQ(names, wanted);
}

RC_GTEST_PROP(NaturalOrder, NoTwoNamesHaveTheSameKey,
              (const std::string& a, const std::string& b)) {
    const NaturalOrder order;
    RC_ASSERT((order.key_of(a) == order.key_of(b)) == (a == b));
}

rc::Gen<std::string> file_name() {
    return rc::gen::suchThat(rc::gen::string<std::string>(),
                             [](const std::string& name) { return is_file_name(name); });
}

rc::Gen<std::string> folder_path() {
    return rc::gen::map(
        rc::gen::resize(deepest_folder, rc::gen::container<std::vector<std::string>>(file_name())),
        [](const std::vector<std::string>& names) {
            std::string path;
            for (std::size_t i = 0; i < names.size() && i < deepest_folder; ++i)
                path += (path.empty() ? "" : "/") + names[i];
            return path;
        });
}

rc::Gen<StickListing> listing() {
    const auto entry = rc::gen::build<StickEntry>(
        rc::gen::set(
            &StickEntry::kind,
            rc::gen::element(StickFileKind::picture, StickFileKind::document, StickFileKind::office,
                             StickFileKind::pack, StickFileKind::network, StickFileKind::bundle,
                             StickFileKind::house_key)),
        rc::gen::set(&StickEntry::folder, folder_path()),
        rc::gen::set(&StickEntry::name, file_name()));
    return rc::gen::build<StickListing>(
        rc::gen::set(&StickListing::entries, rc::gen::container<std::vector<StickEntry>>(entry)),
        rc::gen::set(&StickListing::rest,
                     rc::gen::build<StickRest>(rc::gen::set(&StickRest::not_listed),
                                               rc::gen::set(&StickRest::has_deeper),
                                               rc::gen::set(&StickRest::has_unreadable),
                                               rc::gen::set(&StickRest::is_cut_short))));
}

RC_GTEST_PROP(StickListing, ComesBackAsItWasSent, ()) {
    const StickListing sent = *listing();
    const auto got = listing_of(bytes_of(sent));
    RC_ASSERT(got.has_value());
    RC_ASSERT(*got == sent);
}

RC_GTEST_PROP(StickListing, CutShortOrWithMoreIsRefused, ()) {
    auto bytes = bytes_of(*listing());
    const auto kept = *rc::gen::inRange<std::size_t>(0, bytes.size());
    RC_ASSERT(!listing_of(std::span(bytes).first(kept)));
    bytes.push_back({});
    RC_ASSERT(!listing_of(bytes));
}

TEST(StickListing, OfALiarIsRefused) {
    const auto refused = [](const StickListing& listing) { return !listing_of(bytes_of(listing)); };
    const auto one = [](std::string folder, std::string name) {
        return StickListing{{{StickFileKind::picture, std::move(folder), std::move(name)}}, {}};
    };
    EXPECT_FALSE(refused(one("", "a.png")));
    for (const auto& name : {""s, "."s, ".."s, "../a.png"s, "/etc/shadow"s, "a\0b"s,
                             std::string(longest_name_bytes + 1, 'a')})
        EXPECT_TRUE(refused(one("", name)));
    EXPECT_FALSE(refused(one("a/b", "a")));
    for (const auto& folder : {"."s, ".."s, "a/../b"s, "/etc"s, "\0"s, "1/2/3/4/5/6/7/8/9"s})
        EXPECT_TRUE(refused(one(folder, "a")));
    StickListing long_one;
    long_one.entries.assign(most_listed, {StickFileKind::picture, "", "a"});
    EXPECT_FALSE(refused(long_one));
    long_one.entries.push_back({StickFileKind::picture, "", "a"});
    EXPECT_TRUE(refused(long_one));
    auto bytes = bytes_of(one("", "a"));
    bytes[11] = std::byte{stick_file_kind_count};  // the first entry's kind
    EXPECT_FALSE(listing_of(bytes));
    bytes[11] = {};
    EXPECT_TRUE(listing_of(bytes));
    bytes[8] = {};  // not whole, but without a reason
    EXPECT_FALSE(listing_of(bytes));
    bytes.back() = std::byte{1};
    EXPECT_TRUE(listing_of(bytes));
    bytes.back() = std::byte{8};
    EXPECT_FALSE(listing_of(bytes));
}

TEST(StickListing, PathsOfFoldersAreEightNamesAtMost) {
    for (const auto& path : {""s, "a"s, "DCIM/100CANON"s, "1/2/3/4/5/6/7/8"s})
        EXPECT_TRUE(is_folder_path(path)) << path;
    for (const auto& path : {"/"s, "a/"s, "/a"s, "a//b"s, "a/../b"s, "./a"s, "1/2/3/4/5/6/7/8/9"s,
                             "a\0b"s, std::string(4096, 'a')})
        EXPECT_FALSE(is_folder_path(path)) << path;
}

TEST(StickRefusal, IsOneOwnSentenceWithWhatToDo) {
    std::set<std::string> sentences;
    for (int i = 0; i < stick_refusal_count; ++i) {
        const std::string sentence = sentence_of(static_cast<StickRefusal>(i), "boat.jpg");
        EXPECT_TRUE(sentence.starts_with("boat.jpg ")) << sentence;
        EXPECT_NE(sentence.find("; "), std::string::npos) << sentence;
        EXPECT_EQ(sentence.find_first_of("\n0123456789"), std::string::npos) << sentence;
        sentences.insert(sentence);
    }
    EXPECT_EQ(sentences.size(), static_cast<std::size_t>(stick_refusal_count));
    EXPECT_TRUE(sentence_of(StickRefusal::gone, "").starts_with("The stick "));
}

}  // namespace
}  // namespace touchline
