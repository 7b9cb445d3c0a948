// Tests touchline bundle and touchline counters, as a user types them on two kiosks of one house.
#include "app/cli/options.h"
#include "app/documents/decode/files.h"
#include "app/operator/counters.h"
#include "tests/config/scratch_folder.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

struct Told {
    int status;
    std::string out;
    std::string err;
};

Told type(const std::vector<std::string>& words) {
    std::ostringstream out;
    std::ostringstream err;
    const int status = run_command_line(words, {}, out, err);
    return {status, out.str(), err.str()};
}

/// What tells this machine's kiosk from another: its files.
class HouseCommand : public testing::Test {
  protected:
    HouseCommand() {
        folder_.write("first/kiosk.toml", "[feel]\nstiffness_N_per_m = 400\n");
        folder_.write("other/kiosk.toml", "[screen]\nsize_inches = 24\n");
        be("first");
    }

    ~HouseCommand() override {
        for (const char* name : {"TOUCHLINE_SETTINGS", "TOUCHLINE_LIBRARY", "TOUCHLINE_MODELS"})
            ::unsetenv(name);  // NOLINT(concurrency-mt-unsafe)
    }

    void be(const std::string& kiosk) const {
        const auto set = [&](const char* name, const char* part) {
            ::setenv(name, at(kiosk + "/" + part).c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
        };
        set("TOUCHLINE_SETTINGS", "kiosk.toml");
        set("TOUCHLINE_LIBRARY", "packs");
        set("TOUCHLINE_MODELS", "models");
    }

    [[nodiscard]] std::string at(const std::string& name) const {
        return (folder_.path() / name).string();
    }

    [[nodiscard]] std::string settings_of(const std::string& kiosk) const {
        return read_text(at(kiosk + "/kiosk.toml")).value_or("cannot be read");
    }

    /// The first kiosk's key and bundle; returns the digits.
    std::string make() {
        be("first");
        const Told key = type({"bundle", "key", "-o", key_});
        EXPECT_EQ(key.status, 0) << key.err;
        const Told bundle = type({"bundle", "make", "-o", bundle_});
        EXPECT_EQ(bundle.status, 0) << bundle.err;
        EXPECT_EQ(bundle.out, bundle_ + ": 1 kB\n") << "begun, not 0";
        be("other");
        const std::string mark = "the key of this house: ";
        EXPECT_TRUE(key.out.starts_with(mark)) << key.out;
        return key.out.substr(mark.size(), 29);
    }

    ScratchFolder folder_;
    std::string key_ = at("house.touchline-key");
    std::string bundle_ = at("all.touchline-bundle");
};

TEST_F(HouseCommand, TrustsAKeyOnlyWithItsDigits) {
    const std::string digits = make();
    const Told none = type({"bundle", "key", key_});
    EXPECT_EQ(none.status, 1);
    EXPECT_NE(none.err.find("nothing was changed"), std::string::npos) << none.err;
    std::string wrong = digits;
    wrong.back() = wrong.back() == '0' ? '1' : '0';
    for (const std::string& typed : {wrong, digits.substr(0, 24), digits + "0"})
        EXPECT_EQ(type({"bundle", "key", key_, "--fingerprint", typed}).status, 1) << typed;
    EXPECT_EQ(type({"bundle", "check", bundle_}).status, 1) << "no key is trusted";
    EXPECT_EQ(type({"bundle", "key", key_, "--fingerprint", digits}).status, 0);
    EXPECT_EQ(type({"bundle", "check", bundle_}).status, 0);
}

TEST_F(HouseCommand, ChecksAppliesAndUndoes) {
    const std::string before = settings_of("other");
    ASSERT_EQ(type({"bundle", "key", key_, "--fingerprint", make()}).status, 0);
    const Told checked = type({"bundle", "check", bundle_});
    EXPECT_NE(checked.out.find("Firmness: from 500"), std::string::npos) << checked.out;
    EXPECT_NE(checked.out.find("; nothing was changed"), std::string::npos) << checked.out;
    EXPECT_EQ(settings_of("other"), before);
    const Told applied = type({"bundle", "apply", bundle_});
    EXPECT_EQ(applied.status, 0) << applied.err;
    EXPECT_NE(settings_of("other").find("stiffness_N_per_m = 400"), std::string::npos);
    EXPECT_NE(settings_of("other").find("size_inches = 24"), std::string::npos);
    const std::string after = settings_of("other");
    const Told asked = type({"bundle", "undo"});
    EXPECT_EQ(asked.status, 0) << asked.err;
    EXPECT_NE(asked.out.find("Firmness: from 400"), std::string::npos) << asked.out;
    EXPECT_NE(asked.out.find("nothing was changed"), std::string::npos) << asked.out;
    EXPECT_EQ(settings_of("other"), after);
    const Told undone = type({"bundle", "undo", "--yes"});
    EXPECT_EQ(undone.status, 0) << undone.err;
    EXPECT_NE(undone.out.find("Firmness: from 400"), std::string::npos) << undone.out;
    EXPECT_EQ(settings_of("other"), before);
    for (const char* word : {"undo", "check"})
        EXPECT_NE(type({"bundle", word, "--yes"}).status, 0) << word;
}

TEST_F(HouseCommand, RefusesInOneLine) {
    ASSERT_EQ(type({"bundle", "key", key_, "--fingerprint", make()}).status, 0);
    for (const std::string& file : {key_, at("nobody")}) {
        const Told said = type({"bundle", "apply", file});
        EXPECT_EQ(said.status, 1);
        EXPECT_EQ(said.err.find('\n'), said.err.size() - 1) << said.err;
    }
    EXPECT_EQ(type({"bundle", "make", "-o", at("b")}).status, 1) << "it cannot sign";
    EXPECT_FALSE(fs::exists(at("b")));
}

TEST_F(HouseCommand, JoinsTheCountersOfTwoKiosks) {
    const std::string counted = at("counted.csv");
    CountedDays days;
    counts_on(std::chrono::sys_days(std::chrono::days(20'000)), days).visits = 5;
    folder_.write("hall.csv", counters_csv(days));
    folder_.write("attic.csv", counters_csv(days));
    const Told said = type({"counters", at("hall.csv"), at("attic.csv"), "-o", counted});
    EXPECT_EQ(said.status, 0) << said.err;
    const std::string table = read_text(counted).value_or("");
    EXPECT_TRUE(table.starts_with("kiosk,day,visits,")) << table;
    EXPECT_LT(table.find("\nattic,2024-10-04,5,"), table.find("\nhall,2024-10-04,5,")) << table;
    EXPECT_EQ(type({"counters", at("nobody.csv"), "-o", at("none.csv")}).status, 1);
    EXPECT_FALSE(fs::exists(at("none.csv")));
}

}  // namespace
}  // namespace touchline
