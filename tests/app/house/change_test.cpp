// Tests that several files and folders change together or not at all, wherever the power fails.
#include "app/house/changing.h"
#include "tests/app/house/folder_picture.h"
#include "tests/app/house/lost_power.h"
#include "tests/config/scratch_folder.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr int beyond_all_steps = 1000;

std::span<const std::byte> bytes_in(std::string_view text) {
    return std::as_bytes(std::span(text));
}

/// A kiosk with settings, a pack and a network; its profiles and one more pack are still to come.
class OneKiosk : public testing::Test {
  protected:
    OneKiosk() {
        folder_.write("settings/kiosk.toml", "old settings");
        folder_.write("packs/boats/pack.toml", "old boats");
        folder_.write("packs/boats/voices/sail.ogg", "old voice");
        folder_.write("packs/other/pack.toml", "nobody's business");
        folder_.write("networks/figure.onnx", "old network");
    }

    [[nodiscard]] HousePlaces places() const {
        const fs::path all = folder_.path();
        return {all / "settings/house",
                {all / "settings/kiosk.toml", all / "settings/kiosk.good"},
                all / "settings/profiles",
                all / "installed",
                all / "packs",
                all / "networks"};
    }

    static std::vector<NewThing> things() {
        return {{HouseRoot::settings, "kiosk.toml", {{"", bytes_in("new settings")}}},
                {HouseRoot::profiles, "school.toml", {{"", bytes_in("new profile")}}},
                {HouseRoot::packs,
                 "boats",
                 {{"pack.toml", bytes_in("new boats")}, {"hull.svg", bytes_in("new hull")}}},
                {HouseRoot::packs, "gardens", {{"pack.toml", bytes_in("new gardens")}}},
                {HouseRoot::networks, "figure.onnx", {{"", bytes_in("new network")}}}};
    }

    [[nodiscard]] FolderPicture picture() const { return picture_of_folder(folder_.path()); }

    void do_change() const { EXPECT_TRUE(change(places(), things(), 100).has_value()); }

    void do_change_back() const {
        const auto record = read_change_record(places());
        ASSERT_TRUE(record.has_value() && record->has_value());
        EXPECT_TRUE(change_back(places(), **record).has_value());
    }

    /// Nothing of a change lies about, but for what leads back.
    [[nodiscard]] int hidden_things() const {
        int count = 0;
        for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
            count += entry.path().filename().string().starts_with(".house-") ? 1 : 0;
        return count;
    }

    void put_back(const fs::path& kept) {
        fs::remove_all(folder_.path());
        fs::copy(kept, folder_.path(), fs::copy_options::recursive);
    }

    /// Loses the power at each step of `work`, and once more at each step of what finishes it.
    void lose_power_everywhere(const std::function<void()>& work) {
        const ScratchFolder kept(fast_folder());
        fs::copy(folder_.path(), kept.path(), fs::copy_options::recursive);
        const FolderPicture before = picture();
        work();
        const FolderPicture after = picture();
        ASSERT_NE(before, after);
        bool has_ended = false;
        bool was_kept = false;
        bool was_changed = false;
        for (int step = 1; !has_ended; ++step) {
            ASSERT_LT(step, beyond_all_steps);
            bool has_finished = false;
            for (int next = 1; !has_finished; ++next) {
                ASSERT_LT(next, beyond_all_steps);
                put_back(kept.path());
                has_ended = ends_before_step(step, work);
                has_finished = ends_before_step(next, [this] { (void)finish_change(places()); });
                ASSERT_TRUE(finish_change(places()).has_value());
                const FolderPicture now = picture();
                ASSERT_TRUE(now == before || now == after) << "step " << step << ", " << next;
                was_kept = was_kept || now == before;
                was_changed = was_changed || (now == after && !has_ended);
            }
        }
        EXPECT_TRUE(was_kept);
        EXPECT_TRUE(was_changed);
    }

    ScratchFolder folder_{fast_folder()};
};

TEST_F(OneKiosk, ChangesAllOfIt) {
    do_change();
    FolderPicture now = picture();
    EXPECT_EQ(now["settings/kiosk.toml"], "new settings");
    EXPECT_EQ(now["settings/profiles/school.toml"], "new profile");
    EXPECT_EQ(now["packs/boats/hull.svg"], "new hull");
    EXPECT_FALSE(now.contains("packs/boats/voices/sail.ogg"));
    EXPECT_EQ(now["packs/gardens/pack.toml"], "new gardens");
    EXPECT_EQ(now["packs/other/pack.toml"], "nobody's business");
    EXPECT_EQ(now["networks/figure.onnx"], "new network");
    EXPECT_EQ(hidden_things(), 3);  // settings, pack, network: the way back
}

TEST_F(OneKiosk, GoesBackToTheBit) {
    const FolderPicture before = picture();
    do_change();
    do_change_back();
    EXPECT_EQ(picture(), before);
    EXPECT_EQ(hidden_things(), 0);
}

TEST_F(OneKiosk, GoesBackFromTheLastOfTwo) {
    do_change();
    const FolderPicture first = picture();
    ASSERT_TRUE(
        change(places(), {{HouseRoot::settings, "kiosk.toml", {{"", bytes_in("newer")}}}}, 200));
    do_change_back();
    EXPECT_EQ(picture(), first);
    const auto record = read_change_record(places());
    ASSERT_TRUE(record.has_value() && record->has_value());
    EXPECT_FALSE(can_change_back(places(), **record)) << "only the last change has a way back";
}

TEST_F(OneKiosk, IsAsBeforeOrAsAfterWhereverThePowerFails) {
    lose_power_everywhere([this] { do_change(); });
}

TEST_F(OneKiosk, IsAsBeforeOrAsAfterWhereverThePowerFailsOnTheWayBack) {
    do_change();
    lose_power_everywhere([this] { do_change_back(); });
}

/// What was not there is put back as it was, and all of it comes.
TEST_F(OneKiosk, WaitsForAFolderThatIsNotThereWhenTheChangeIsFinished) {
    const ScratchFolder kept(fast_folder());
    fs::copy(folder_.path(), kept.path(), fs::copy_options::recursive);
    do_change();
    const FolderPicture after = picture();
    const fs::path packs = folder_.path() / "packs";
    const fs::path elsewhere = folder_.path() / "elsewhere";
    int waits = 0;
    for (const bool is_empty_folder_there : {false, true}) {
        bool has_ended = false;
        for (int step = 1; !has_ended; ++step) {
            put_back(kept.path());
            has_ended = ends_before_step(step, [this] { do_change(); });
            if (!fs::exists(places().house / ".house-change")) continue;
            fs::rename(packs, elsewhere);
            if (is_empty_folder_there) fs::create_directory(packs);
            EXPECT_FALSE(finish_change(places()).has_value() && picture()["packs"].empty() &&
                         !fs::exists(places().house / ".house-change") &&
                         fs::exists(elsewhere / ".house-in-1-gardens"))
                << "step " << step;
            fs::remove(packs);
            fs::rename(elsewhere, packs);
            ASSERT_TRUE(finish_change(places()).has_value()) << "step " << step;
            EXPECT_EQ(picture(), after) << "step " << step;
            ++waits;
        }
    }
    EXPECT_GT(waits, 10);
}

TEST_F(OneKiosk, KeepsTheWayBackWhenABundleChangesNothing) {
    const FolderPicture before = picture();
    do_change();
    ASSERT_TRUE(change(places(), {}, 200).has_value());
    const auto record = read_change_record(places());
    ASSERT_TRUE(record.has_value() && record->has_value());
    EXPECT_EQ((*record)->made_s, 200) << "older bundles stay refused";
    do_change_back();
    EXPECT_EQ(picture(), before);
}

TEST_F(OneKiosk, ForgetsNoAgeByASecondWayBack) {
    const auto only_new = [](const char* name) {
        return std::vector<NewThing>{{HouseRoot::packs, name, {{"pack.toml", bytes_in("new")}}}};
    };
    ASSERT_TRUE(change(places(), only_new("one"), 100).has_value());
    ASSERT_TRUE(change(places(), only_new("two"), 200).has_value());
    ASSERT_TRUE(change(places(), only_new("three"), 300).has_value());
    do_change_back();
    const auto record = read_change_record(places());
    ASSERT_TRUE(record.has_value() && record->has_value());
    EXPECT_EQ((*record)->made_s, 200);
    EXPECT_FALSE(can_change_back(places(), **record));
}

TEST_F(OneKiosk, IsUnchangedWhereWhoeverJudgesSaysNo) {
    const FolderPicture before = picture();
    EXPECT_FALSE(change(places(), things(), 100, [] { return failure("no"); }).has_value());
    EXPECT_EQ(picture(), before);
    EXPECT_EQ(hidden_things(), 0);
}

/// What takes long is over by then: a running kiosk may write its settings meanwhile.
TEST_F(OneKiosk, IsJudgedOnceAllThatIsNewIsWritten) {
    int staged = 0;
    const auto judge = [&]() -> Result<void> {
        staged = hidden_things();
        return {};
    };
    ASSERT_TRUE(change(places(), things(), 100, judge).has_value());
    EXPECT_EQ(staged, static_cast<int>(things().size()) + 1) << "with the record";
}

TEST_F(OneKiosk, IsUnchangedWhereSomethingCannotBeWritten) {
    const FolderPicture before = picture();
    std::vector<NewThing> all = things();
    all.push_back({HouseRoot::packs, "kites", {{"pack.toml/inner", bytes_in("a")}}});
    all.back().files.insert(all.back().files.begin(), {"pack.toml", bytes_in("b")});
    EXPECT_FALSE(change(places(), all, 100).has_value());
    EXPECT_EQ(picture(), before);
    EXPECT_EQ(hidden_things(), 0);
}

TEST_F(OneKiosk, RefusesANameThatTheListsCannotHold) {
    for (const char* name : {"a b", "a\nb", "../a", "", ".."}) {
        const auto done = change(places(), {{HouseRoot::settings, name, {{"", {}}}}}, 100);
        EXPECT_FALSE(done.has_value()) << name;
    }
}

TEST_F(OneKiosk, LeavesAllAsItIsWhenItsRecordIsDamaged) {
    do_change();
    folder_.write("settings/house/applied.txt", "Touchline applied 1\nchange x\n");
    const FolderPicture before = picture();
    EXPECT_FALSE(change(places(), things(), 200).has_value());
    EXPECT_TRUE(finish_change(places()).has_value());
    EXPECT_EQ(picture(), before);
    EXPECT_EQ(hidden_things(), 3);
}

TEST(ChangeLists, ReadOnlyWhatTheyWrite) {
    const ChangeRecord record{
        7,
        1796069692,
        {{HouseRoot::packs, "boats", true}, {HouseRoot::settings, "kiosk.toml", false}}};
    EXPECT_EQ(record_in(record_text(record)), record);
    for (const char* text : {"", "Touchline applied 1\n", "Touchline applied 2\nchange 1 2\n",
                             "Touchline applied 1\nchange 1 2\npacks ../a was\n",
                             "Touchline applied 1\nchange 1 2\nroots a was\n",
                             "Touchline applied 1\nchange 1 2\npacks a was\npacks b"})
        EXPECT_FALSE(record_in(text).has_value()) << text;
    for (const char* text :
         {"", "Touchline change 1\npacks a b\n", "Touchline change 1\npacks a b/../c d\n",
          "Touchline change 1\npacks a b d"})
        EXPECT_FALSE(moves_in(text).has_value()) << text;
}

}  // namespace
}  // namespace touchline
