// Tests a stick's files in the list and on the operator's screen: a scripted port, the real
// touchline-import, real workers.
#include "app/kiosk/stick_source.h"

#include "app/documents/sticks/stick_port.h"
#include "tests/app/documents/decode/files_of_formats.h"
#include "tests/app/documents/sticks/stick_folder.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// A port whose events the test sets.
class ToldPort final : public StickPort {
  public:
    std::vector<StickEvent> poll(std::int64_t) override { return std::exchange(events, {}); }

    void allow(FileSystems now) override { allowed = now; }

    void end_session() override { is_ended = true; }

    [[nodiscard]] bool is_watching() const override { return true; }

    std::vector<StickEvent> events;
    bool is_ended = false;
    FileSystems allowed = FileSystems::usual;
};

std::string text_of(const encoders::Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

class StickSourceTest : public testing::Test {
  protected:
    void ready() { port->events.push_back({StickNews::ready, stick.root(), ""}); }

    /// Waits for a change, which must come.
    FilesChange change() {
        for (;;) {
            if (auto changed = sticks.poll(0)) return std::move(*changed);
            std::this_thread::yield();
        }
    }

    StickFolder stick;
    ToldPort* port = new ToldPort;
    StickSource sticks{std::unique_ptr<StickPort>(port), TOUCHLINE_IMPORT};
};

TEST_F(StickSourceTest, AStickThatComesOffersItsFilesAndTakesThemAlong) {
    stick.file("b10.png");
    stick.file("b9.pdf");
    stick.file("letter.docx");
    EXPECT_FALSE(sticks.poll(0).has_value());
    ready();
    const FilesChange come = change();
    ASSERT_EQ(come.files.size(), 3U);
    EXPECT_EQ(come.files[0]->name, "b9.pdf");
    EXPECT_EQ(come.files[1]->file_name, "b10.png");
    EXPECT_TRUE(come.files[2]->is_private);
    EXPECT_EQ(come.sentence, "");
    EXPECT_TRUE(come.rest.is_nothing());
    port->events.push_back({StickNews::gone, "", ""});
    EXPECT_TRUE(change().files.empty());
}

TEST_F(StickSourceTest, ItsFilesAreOpenedWithTheTextBesideThem) {
    stick.file("fish.pdf", text_of(drawn_pdf({{{100, 100, 200, 200}}, {}})));
    stick.file("fish.txt", "The fish\nA fish that swims\n");
    ready();
    const FilesChange come = change();
    ASSERT_EQ(come.files.size(), 1U);
    const auto page = come.files[0]->open({2, 72});
    ASSERT_TRUE(page.has_value()) << page.error().line;
    EXPECT_EQ(page->number, 2);
    EXPECT_EQ(page->told.title, "The fish");
    EXPECT_EQ(page->told.description, "A fish that swims");
}

TEST_F(StickSourceTest, ADocumentIsReadOnce) {
    stick.file("fish.pdf", text_of(drawn_pdf({{}, {}, {}})));
    ready();
    const FilesChange come = change();
    ASSERT_TRUE(come.files.at(0)->open({1, 72}).has_value());
    std::filesystem::remove(stick.path() / "fish.pdf");
    EXPECT_TRUE(come.files.at(0)->open({3, 72}).has_value());
}

TEST_F(StickSourceTest, WhatCannotBeOpenedIsOneSentenceWithItsName) {
    stick.file("a.docx", "office");
    stick.file("b\n.png", "no picture");
    stick.file("c.png", "gone soon");
    ready();
    const FilesChange come = change();
    ASSERT_EQ(come.files.size(), 3U);
    std::filesystem::remove(stick.path() / "c.png");
    for (const FilePtr& file : come.files) {
        const auto page = file->open({1, 150});
        ASSERT_FALSE(page.has_value());
        const std::string& line = page.error().line;
        EXPECT_EQ(line.find(file->name), 0U) << line;
        EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    }
    EXPECT_NE(come.files[0]->open({1, 150}).error().line.find("PDF"), std::string::npos);
}

TEST_F(StickSourceTest, OneThatOffersNothingWasRead) {
    ready();
    const FilesChange come = change();
    EXPECT_TRUE(come.files.empty());
    EXPECT_TRUE(come.is_read);
    EXPECT_EQ(come.sentence, "");
}

TEST_F(StickSourceTest, FilesOfFoldersAreOpenedFromTheirDepth) {
    stick.folder("DCIM/100CANON/3/4/5/6/7/8/9");
    stick.file("DCIM/100CANON/fish.pdf", text_of(drawn_pdf({{{100, 100, 200, 200}}})));
    stick.file("DCIM/100CANON/fish.txt", "A fish that swims\n");
    ready();
    const FilesChange come = change();
    ASSERT_EQ(come.files.size(), 1U);
    const auto page = come.files[0]->open({1, 72});
    ASSERT_TRUE(page.has_value()) << page.error().line;
    EXPECT_EQ(page->told.description, "A fish that swims");
    EXPECT_TRUE(come.rest.has_deeper);
}

TEST_F(StickSourceTest, ARefusedStickIsItsSentence) {
    port->events.push_back({StickNews::refused, "", "The stick cannot be read."});
    EXPECT_EQ(change().sentence, "The stick cannot be read.");
}

TEST_F(StickSourceTest, OneThatWasPulledOutWhileItWasListedOffersNothing) {
    stick.file("a.png");
    ready();
    (void)sticks.poll(0);
    port->events.push_back({StickNews::gone, "", ""});
    EXPECT_TRUE(change().files.empty());
    const StickFolder other;
    other.file("other.png");
    port->events.push_back({StickNews::ready, other.root(), ""});
    const FilesChange come = change();
    ASSERT_EQ(come.files.size(), 1U);
    EXPECT_EQ(come.files[0]->name, "other.png");
}

TEST_F(StickSourceTest, OneAfterTheOtherInOneMomentIsTheLast) {
    stick.file("a.png");
    const StickFolder other;
    other.file("other.png");
    ready();
    port->events.push_back({StickNews::gone, "", ""});
    port->events.push_back({StickNews::ready, other.root(), ""});
    for (;;) {
        const FilesChange come = change();
        if (come.files.empty()) continue;
        EXPECT_EQ(come.files[0]->name, "other.png");
        break;
    }
}

TEST_F(StickSourceTest, TheEndOfTheSessionIsToldToThePort) {
    sticks.end_session();
    EXPECT_TRUE(port->is_ended);
}

TEST(StickSourceOfAFolder, OffersWhatIsPutThere) {
    const StickFolder folder;
    StickSource sticks(open_stick_port(folder.root()), TOUCHLINE_IMPORT);
    std::int64_t now_ns = 0;
    const auto next = [&] {
        for (;;) {
            now_ns += 1'000'000'000;
            if (auto changed = sticks.poll(now_ns)) return std::move(*changed);
            std::this_thread::yield();
        }
    };
    (void)sticks.poll(now_ns);
    folder.file("a.png");
    FilesChange come = next();
    while (come.files.empty()) come = next();
    EXPECT_EQ(come.files[0]->name, "a.png");
    std::filesystem::remove(folder.path() / "a.png");
    EXPECT_TRUE(next().files.empty());
}

using Names = std::vector<std::string>;

class OperatorStickTest : public testing::Test {
  protected:
    /// Waits until there are `count` names, which must come.
    void wait_for_names(std::size_t count) {
        for (int i = 0; i < 6000 && packs.names().size() != count; ++i) {
            EXPECT_EQ(packs.poll(), "");
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        ASSERT_EQ(packs.names().size(), count);
    }

    StickFolder stick;
    OperatorStick packs{TOUCHLINE_IMPORT};
};

TEST_F(OperatorStickTest, AreListedByNamesThatAreSafeAndRead) {
    stick.file("letters.zip", "of letters");
    stick.file("castles\n\x1b[2J.zip", "of castles");
    packs.look_at(stick.root());
    ASSERT_NO_FATAL_FAILURE(wait_for_names(2));
    EXPECT_EQ(packs.names()[0].find_first_of("\n\x1b"), std::string::npos);
    EXPECT_EQ(packs.names()[1], "letters");
    const auto read = packs.reader_of(1);
    const auto bytes = read();
    ASSERT_TRUE(bytes.has_value());
    EXPECT_EQ(bytes->bytes().size(), std::string("of letters").size());
}

TEST_F(OperatorStickTest, AreForgottenWithTheirStick) {
    stick.file("letters.zip");
    packs.look_at(stick.root());
    ASSERT_NO_FATAL_FAILURE(wait_for_names(1));
    const auto read = packs.reader_of(0);
    packs.look_at("");
    EXPECT_EQ(packs.names(), Names{});
    const StickFolder other;
    other.file("a.zip");
    other.file("b.zip");
    packs.look_at(stick.root());  // pulled while it is being listed
    (void)packs.poll();
    packs.look_at(other.root());
    ASSERT_NO_FATAL_FAILURE(wait_for_names(2));
    EXPECT_EQ(packs.names(), (Names{"a", "b"}));
}

TEST_F(OperatorStickTest, OfAStickThatIsGoneAreOneSentence) {
    packs.look_at(stick.root() + "/gone");
    std::string sentence;
    for (int i = 0; i < 6000 && sentence.empty(); ++i) {
        sentence = packs.poll();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_EQ(sentence,
              "The stick cannot be read because the stick was pulled out; put it in again");
}

}  // namespace
}  // namespace touchline
