// Tests two kiosks of one house: what one makes, the other takes, refuses, and goes back from.
#include "app/documents/packs/pack_library.h"
#include "app/house/bundle_making.h"
#include "app/house/bundle_plan.h"
#include "app/house/house_keys.h"
#include "app/operator/settings_files.h"
#include "audio-cues/words/language.h"
#include "tests/app/documents/packs/made_packs.h"
#include "tests/app/house/folder_picture.h"
#include "tests/config/scratch_folder.h"

#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

using Bytes = std::vector<std::byte>;
using testing::Test;

constexpr std::chrono::sys_seconds first_day{std::chrono::seconds(1'796'000'000)};

std::span<const std::byte> bytes_in(std::string_view text) {
    return std::as_bytes(std::span(text));
}

class OneOfHouse {
  public:
    [[nodiscard]] HousePlaces places() const {
        const fs::path all = folder_.path();
        return {all / "settings/house",
                {all / "settings/kiosk.toml", all / "settings/kiosk.toml.good"},
                all / "settings/profiles",
                TOUCHLINE_SOURCE_DIR "/config/defaults/profiles",
                all / "packs",
                all / "networks"};
    }

    void set(const std::string& toml) const { folder_.write("settings/kiosk.toml", toml); }

    void add_profile(const std::string& name, const std::string& toml) const {
        folder_.write("settings/profiles/" + name + ".toml", toml);
    }

    void add_pack(PackVersion version) const {
        auto pack = read_pack(made::example_pack());
        ASSERT_TRUE(pack.has_value());
        pack->info.version = version;
        for (PackFile& file : pack->files)
            if (file.name == pack_table_name) file.bytes = made::bytes_of(toml_of(pack->info));
        ASSERT_TRUE(import_pack(*pack, places().library, OlderPack::take).has_value());
    }

    [[nodiscard]] Settings settings() const { return read_settings(places().settings).settings; }

    [[nodiscard]] FolderPicture picture() const { return picture_of_folder(folder_.path()); }

  private:
    ScratchFolder folder_;
};

class House : public Test {
  protected:
    House() {
        maker_.set("[feel]\nstiffness_N_per_m = 400\n[camera]\ncut_left_percent = 10\n");
        maker_.add_profile("school", "[feel]\nfriction = 0.2\n");
        maker_.add_pack({1, 0, 0});
        other_.set("[feel]\ngives_way = true\n[screen]\nsize_inches = 24\n");
        const auto key = make_house_key(maker_.places());
        EXPECT_TRUE(key && trust_house_key(other_.places(), *key)) << "no key";
    }

    [[nodiscard]] Bytes made(std::chrono::seconds later = {}) const {
        auto bytes = make_bundle(maker_.places(), first_day + later);
        EXPECT_TRUE(bytes.has_value()) << bytes.error().line;
        return bytes.value_or(Bytes{});
    }

    [[nodiscard]] BundleResult<BundlePlan> plan(const Bytes& bytes) const {
        return plan_of_bundle(bytes, "x.touchline-bundle", other_.places(), languages_);
    }

    void apply(const Bytes& bytes) const {
        const auto planned = plan(bytes);
        ASSERT_TRUE(planned.has_value()) << planned.error().line;
        const auto applied = apply_plan(*planned, other_.places());
        ASSERT_TRUE(applied.has_value()) << applied.error().line;
    }

    /// The bundle is refused so, in one line, and the kiosk is as before.
    void expect_refused(const Bytes& bytes, BundleFault fault, const std::string& part) const {
        const FolderPicture before = other_.picture();
        const auto planned = plan(bytes);
        ASSERT_FALSE(planned.has_value());
        EXPECT_EQ(planned.error().fault, fault) << planned.error().line;
        EXPECT_NE(planned.error().line.find(part), std::string::npos) << planned.error().line;
        EXPECT_EQ(planned.error().line.find('\n'), std::string::npos);
        EXPECT_EQ(other_.picture(), before);
    }

    /// Signed by the house, whatever it holds.
    [[nodiscard]] Bytes holding(std::vector<BundleFile> files,
                                const std::string& program = "0.0.1") const {
        const auto secret = read_secret_key(maker_.places());
        auto bytes = signed_bundle({program, first_day.time_since_epoch().count(), files}, *secret);
        return bytes.value_or(Bytes{});
    }

    OneOfHouse maker_;
    OneOfHouse other_;
    std::vector<std::string> languages_{"de", "en", "es", "fr", "it"};
};

TEST_F(House, TellsWhatABundleWouldChangeAndChangesNothing) {
    const FolderPicture before = other_.picture();
    const auto planned = plan(made());
    ASSERT_TRUE(planned.has_value()) << planned.error().line;
    EXPECT_EQ(
        plan_lines(*planned, Language()),
        (std::vector<std::string>{"Firmness: from 500 newtons per metre to 400 newtons per metre",
                                  "Walls give way: from on to off", "Profile school: new",
                                  "Pack Shapes and a boat: new"}));
    EXPECT_EQ(other_.picture(), before);
}

TEST_F(House, TakesWhatIsOfTheHouseAndKeepsWhatIsOfTheKiosk) {
    apply(made());
    Settings wanted;
    wanted.stiffness_N_per_m = 400.0;
    wanted.screen_inches = 24.0;
    EXPECT_EQ(other_.settings(), wanted);
    std::vector<std::string> problems;
    const auto profiles =
        read_profiles(other_.places().installed_profiles, other_.places().profiles, problems);
    EXPECT_NE(std::ranges::find(profiles, "school", &Profile::name), profiles.end());
    EXPECT_NE(std::ranges::find(profiles, "child", &Profile::name), profiles.end());
    const auto pack = read_pack((other_.places().library / "shapes-and-a-boat").string());
    ASSERT_TRUE(pack.has_value());
    const auto theirs = read_pack((maker_.places().library / "shapes-and-a-boat").string());
    ASSERT_TRUE(theirs.has_value());
    EXPECT_TRUE(pack->files == theirs->files);
}

TEST_F(House, IsAlikeAfterwardsAndSaysSo) {
    const Bytes bundle = made();
    apply(bundle);
    const auto again = plan(bundle);
    ASSERT_TRUE(again.has_value());
    EXPECT_TRUE(plan_lines(*again, Language()).empty());
    apply(bundle);
    EXPECT_TRUE(find_way_back(other_.places()).has_value()) << "applied again, nothing is lost";
}

TEST_F(House, GoesBackToBeforeTheBundle) {
    const FolderPicture before = other_.picture();
    apply(made());
    const auto way = find_way_back(other_.places());
    ASSERT_TRUE(way.has_value()) << way.error().line;
    EXPECT_EQ(
        way_back_lines(*way, Language()),
        (std::vector<std::string>{"Firmness: from 400 newtons per metre to 500 newtons per metre",
                                  "Walls give way: from off to on", "Profile school: removed",
                                  "Pack Shapes and a boat: removed"}));
    ASSERT_TRUE(go_back(*way, other_.places()).has_value());
    EXPECT_EQ(other_.picture(), before);
    const auto none = find_way_back(other_.places());
    ASSERT_FALSE(none.has_value());
    EXPECT_EQ(none.error().fault, BundleFault::nothing_to_undo);
    apply(made());
}

/// A typo in the settings: the kiosk runs on with others, which are nobody's to pass on.
TEST_F(House, NeitherSignsNorReplacesSettingsThatItCannotRead) {
    const Bytes bundle = made();
    maker_.set("[feel\n");
    const auto none = make_bundle(maker_.places(), first_day);
    ASSERT_FALSE(none.has_value());
    EXPECT_EQ(none.error().fault, BundleFault::disk);
    EXPECT_NE(none.error().line.find("mend that file first"), std::string::npos);
    other_.set("[feel\n");
    expect_refused(bundle, BundleFault::disk, "mend that file first");
}

TEST_F(House, GoesBackAlsoToSettingsThatCannotBeTold) {
    apply(made());
    const fs::path kept = other_.places().settings.site.parent_path() / ".house-out-1-kiosk.toml";
    ASSERT_TRUE(fs::exists(kept));
    std::ofstream(kept) << "[feel\n";
    const auto way = find_way_back(other_.places());
    ASSERT_TRUE(way.has_value()) << way.error().line;
    EXPECT_EQ(way_back_lines(*way, Language()).size(), 2U);
    EXPECT_TRUE(go_back(*way, other_.places()).has_value());
    EXPECT_EQ(other_.picture()["settings/kiosk.toml"], "[feel\n");
}

TEST_F(House, ReadsNoProfileOfBefore) {
    maker_.add_profile("school", "[feel]\nfriction = 0.1\n");
    const auto key = read_house_key(maker_.places());
    const Bytes bundle = made();
    maker_.add_profile("school", "[feel]\nfriction = 0.3\n");
    const auto planned = plan_of_bundle(bundle, "x", maker_.places(), languages_);
    ASSERT_TRUE(planned.has_value());
    ASSERT_TRUE(apply_plan(*planned, maker_.places()).has_value());
    ASSERT_TRUE(fs::exists(maker_.places().profiles / ".house-out-1-school.toml"));
    std::vector<std::string> problems;
    EXPECT_EQ(read_profiles(maker_.places().profiles, problems).size(), 1U);
    EXPECT_TRUE(problems.empty()) << problems.front();
    EXPECT_FALSE(made().empty());
}

TEST_F(House, AppliesNothingIfTheKioskWasChangedMeanwhile) {
    const auto planned = plan(made());
    ASSERT_TRUE(planned.has_value());
    maker_.add_profile("club", "[feel]\nfriction = 0.3\n");
    apply(made(std::chrono::hours(1)));
    const FolderPicture newer = other_.picture();
    const auto late = apply_plan(*planned, other_.places());
    ASSERT_FALSE(late.has_value());
    EXPECT_EQ(late.error().fault, BundleFault::changed_since);
    EXPECT_EQ(other_.picture(), newer);
    maker_.set("[feel]\nstiffness_N_per_m = 300\n");
    const auto again = plan(made(std::chrono::hours(2)));
    ASSERT_TRUE(again.has_value());
    other_.set("[feel]\nfriction = 0.4\n");
    EXPECT_FALSE(apply_plan(*again, other_.places()).has_value());
    EXPECT_EQ(other_.settings().friction, 0.4);
}

/// Whoever imports a newer pack between the look and the "yes" keeps it.
TEST_F(House, JudgesPacksAndProfilesAnewBeforeItAppliesThem) {
    const auto refuses = [this](const BundlePlan& plan) {
        const FolderPicture before = other_.picture();
        const auto late = apply_plan(plan, other_.places());
        return !late && late.error().fault == BundleFault::changed_since &&
               other_.picture() == before;
    };
    const auto new_pack = plan(made());
    ASSERT_TRUE(new_pack.has_value());
    other_.add_pack({2, 0, 0});
    EXPECT_TRUE(refuses(*new_pack)) << "a newer pack was imported";
    maker_.add_pack({2, 0, 0});
    const auto pack_alike = plan(made());
    ASSERT_TRUE(pack_alike && pack_alike->packs.empty());
    fs::remove_all(other_.places().library);
    EXPECT_TRUE(refuses(*pack_alike)) << "the pack was taken out";
    const auto new_profile = plan(made());
    ASSERT_TRUE(new_profile.has_value());
    other_.add_profile("school", "[feel]\nfriction = 0.4\n");
    EXPECT_TRUE(refuses(*new_profile)) << "somebody wrote a profile of that name";
    apply(made());
}

TEST_F(House, FinishesWhatWasBegunBeforeItMakesABundle) {
    const HousePlaces at = maker_.places();
    const fs::path folder = at.settings.site.parent_path();
    std::ofstream(folder / ".house-in-1-kiosk.toml") << "[feel]\nstiffness_N_per_m = 250\n";
    std::ofstream(at.house / ".house-change")
        << journal_text({{HouseRoot::settings, "kiosk.toml", incoming_name(1, "kiosk.toml"),
                          outgoing_name(1, "kiosk.toml")}});
    apply(made());
    EXPECT_EQ(other_.settings().stiffness_N_per_m, 250.0);
}

/// The two switches are plugged in at one kiosk.
TEST_F(House, LeavesToEachKioskItsButtonSwitches) {
    other_.set("[keys]\ntwo_switches = 'by itself'\nscan_s = 3.0\n");
    const auto before = other_.settings();
    apply(made());
    EXPECT_EQ(other_.settings().two_switches, before.two_switches);
    EXPECT_EQ(other_.settings().scan_s, 3.0);
}

TEST_F(House, RefusesAnOlderBundleUntilItHasGoneBack) {
    const Bytes old = made();
    maker_.set("[feel]\nstiffness_N_per_m = 300\n");
    apply(made(std::chrono::hours(1)));
    expect_refused(old, BundleFault::older, "older than the bundle");
    ASSERT_TRUE(go_back(*find_way_back(other_.places()), other_.places()).has_value());
    apply(old);
    EXPECT_EQ(other_.settings().stiffness_N_per_m, 400.0);
}

TEST_F(House, MakesEachBundleLaterThanTheLastWhateverTheClockSays) {
    const auto first = plan(made());
    const auto second = plan(made(std::chrono::hours(-24)));
    ASSERT_TRUE(first && second);
    EXPECT_GT(second->made_s, first->made_s);
}

TEST_F(House, ReplacesAnOlderPackAndRefusesToReplaceANewer) {
    other_.add_pack({0, 9, 0});
    const auto planned = plan(made());
    ASSERT_TRUE(planned.has_value());
    EXPECT_EQ(plan_lines(*planned, Language()).back(),
              "Pack Shapes and a boat: from version 0.9.0 to version 1.0.0");
    other_.add_pack({1, 1, 0});
    expect_refused(made(), BundleFault::older_pack,
                   "version 1.0.0 in the bundle, and 1.1.0 on this kiosk");
}

TEST_F(House, RefusesABundleWithoutAKeyAndOfAnotherHouse) {
    const OneOfHouse stranger;
    const auto none = plan_of_bundle(made(), "x", stranger.places(), languages_);
    ASSERT_FALSE(none.has_value());
    EXPECT_EQ(none.error().fault, BundleFault::no_key);
    const OneOfHouse elsewhere;
    ASSERT_TRUE(make_house_key(elsewhere.places()).has_value());
    const auto bytes = make_bundle(elsewhere.places(), first_day);
    ASSERT_TRUE(bytes.has_value());
    expect_refused(*bytes, BundleFault::other_key, "another key");
    EXPECT_EQ(make_bundle(other_.places(), first_day).error().fault, BundleFault::no_secret_key);
}

TEST_F(House, RefusesABundleWithAByteChangedAnywhere) {
    const Bytes whole = made();
    const FolderPicture before = other_.picture();
    for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 500) {
        if (at >= 17 && at < 70) continue;  // the comment of minisign that means nothing
        Bytes bytes = whole;
        bytes[at] ^= std::byte{0x10};
        EXPECT_FALSE(plan(bytes).has_value()) << at;
    }
    EXPECT_EQ(other_.picture(), before);
}

/// Sound and signed, but nothing that a kiosk can use.
TEST_F(House, RefusesContentsThatNoKioskCanUse) {
    const auto settings = [](std::string_view text) {
        return BundleFile{BundlePart::settings, "kiosk", bytes_in(text)};
    };
    const auto refused = [this](const BundleFile& file, const std::string& part) {
        expect_refused(holding({file}), BundleFault::bad_contents, part);
    };
    refused(settings("[feel]\nstiffness_N_per_m = 5000\n"), "stiffness_N_per_m");
    refused(settings("[feel\n"), "bundle, kiosk:1");
    refused(settings("[wings]\nspan = 1\n"), "wings");
    refused(settings("[operator]\ndevice = '/dev/input/event1'\n"), "belongs to each kiosk");
    refused(settings("[language]\noffered = 'en eo'\n"), "there are no words of 'eo'");
    refused(settings("[profile]\nuse = 'nobody'\n"), "nobody");
    refused({BundlePart::settings, "other", bytes_in("# nothing")}, "no file of settings");
    refused({BundlePart::profile, "school", bytes_in("[stick]\nwatched_folder = '/'\n")},
            "watched_folder");
    refused({BundlePart::pack, "boats", bytes_in("no zip file")}, "boats");
    refused({BundlePart::network, "figure", bytes_in("no network")}, "figure");
    auto members = made::small_pack();
    members.back().name = "../evil.svg";
    const auto zip = made::zip(members);
    refused({BundlePart::pack, "boats", zip}, "evil.svg");
}

TEST_F(House, RefusesAPackUnderAnotherName) {
    const Bytes whole = made();
    const auto again = bundle_in(whole, *read_house_key(other_.places()), "x");
    ASSERT_TRUE(again.has_value());
    const auto pack = std::ranges::find(again->files, BundlePart::pack, &BundleFile::part);
    ASSERT_NE(pack, again->files.end());
    expect_refused(holding({{BundlePart::pack, "gardens", pack->bytes}}), BundleFault::bad_contents,
                   "another pack");
}

TEST_F(House, SaysThatANewerTouchlineIsNeeded) {
    expect_refused(
        holding({{BundlePart::settings, "kiosk", bytes_in("[wings]\nspan = 1\n")}}, "9999.0.0"),
        BundleFault::newer_program, "update the program");
}

TEST_F(House, MayNotRaiseTheForceByAProfile) {
    const auto bytes =
        holding({{BundlePart::settings, "kiosk",
                  bytes_in("[feel]\nforce_ceiling_N = 1\n[profile]\nuse = 'strong'\n")},
                 {BundlePart::profile, "strong", bytes_in("[feel]\nforce_ceiling_N = 2\n")}});
    expect_refused(bytes, BundleFault::bad_contents, "force_ceiling_N");
}

TEST_F(House, KeepsItsKeyAndTrustsOneAlone) {
    const auto key = read_house_key(maker_.places());
    ASSERT_TRUE(key.has_value());
    EXPECT_EQ(make_house_key(maker_.places()).value(), *key) << "made once";
    const PublicKey stranger = public_key_of(new_secret_key());
    EXPECT_EQ(trust_house_key(maker_.places(), stranger).error().fault, BundleFault::has_key);
    EXPECT_TRUE(trust_house_key(other_.places(), stranger).has_value());
    expect_refused(made(), BundleFault::other_key, "another key");
    const fs::path secret = maker_.places().house / "secret-key";
    EXPECT_EQ(fs::status(secret).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    fs::permissions(secret, fs::perms::others_read, fs::perm_options::add);
    EXPECT_EQ(make_bundle(maker_.places(), first_day).error().fault, BundleFault::disk);
    EXPECT_FALSE(trust_house_key(maker_.places(), stranger).has_value())
        << "it has a secret key, although it cannot be read";
}

TEST_F(House, SaysThatBundlesAreMadeOnTheFirstKiosk) {
    const auto none = make_bundle(other_.places(), first_day);
    ASSERT_FALSE(none.has_value());
    EXPECT_NE(none.error().line.find("first kiosk"), std::string::npos) << none.error().line;
    const OneOfHouse stranger;
    EXPECT_NE(make_bundle(stranger.places(), first_day).error().line.find("touchline bundle key"),
              std::string::npos);
}

}  // namespace
}  // namespace touchline
