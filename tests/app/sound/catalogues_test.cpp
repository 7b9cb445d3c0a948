#include "app/sound/catalogues.h"

#include "config/settings/setting_rows.h"
#include "config/settings/settings.h"
#include "config/types/pinned.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

/// Sets a variable of the environment for as long as it lives.
class Chosen : private Pinned {
  public:
    Chosen(const char* name, const std::string& value) : name_(name) {
        setenv(name, value.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
    }

    ~Chosen() { unsetenv(name_); }  // NOLINT(concurrency-mt-unsafe)

  private:
    const char* name_;
};

class CataloguesTest : public testing::Test {
  protected:
    CataloguesTest() { fs::create_directories(folder_); }

    ~CataloguesTest() override { fs::remove_all(folder_); }

    fs::path folder_ =
        fs::temp_directory_path() / ("touchline-catalogues-" + std::to_string(getpid()));
};

TEST_F(CataloguesTest, AsBuiltAllLanguagesThatAKioskOffersAreFound) {
    std::vector<std::string> problems;
    const Languages languages = read_languages(words_folder(), problems);
    ASSERT_GE(languages.size(), 5U) << words_folder();
    EXPECT_EQ(languages[0].code(), "en");
    EXPECT_EQ(languages[1].name(), "Deutsch");
    EXPECT_TRUE(problems.empty());
    const auto codes = languages_in_text(Settings{}.languages).value();
    for (const std::string& code : codes)
        EXPECT_EQ(std::ranges::count(languages, code, &Language::code), 1) << code;
}

TEST_F(CataloguesTest, ABadCatalogueIsALineAndTheOthersAreThere) {
    fs::copy(fs::path(TOUCHLINE_CATALOGUES) / "fr.mo", folder_ / "fr.mo");
    std::ofstream(folder_ / "de.mo") << "no catalogue";
    const Chosen words("TOUCHLINE_WORDS", folder_.string());
    EXPECT_EQ(words_folder(), folder_);
    std::vector<std::string> problems;
    const Languages languages = read_languages(words_folder(), problems);
    ASSERT_EQ(languages.size(), 2U);
    EXPECT_EQ(languages[1].code(), "fr");
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_NE(problems[0].find("de.mo"), std::string::npos);
}

TEST_F(CataloguesTest, WithoutAFolderThereIsEnglish) {
    std::vector<std::string> problems;
    const Languages languages = read_languages(folder_ / "none", problems);
    ASSERT_EQ(languages.size(), 1U);
    EXPECT_EQ(languages[0].code(), "en");
    EXPECT_EQ(problems.size(), 1U);
}

TEST_F(CataloguesTest, TheKiosksOwnLevelsComeBeforeTheInstalledOnes) {
    const Chosen home("XDG_CONFIG_HOME", folder_.string());
    std::vector<std::string> problems;
    EXPECT_EQ(read_sound_settings(sound_file(), problems), SoundSettings{});
    fs::create_directories(folder_ / "touchline");
    std::ofstream(folder_ / "touchline" / "sound.toml") << "[headset]\ncap_dB = 90";
    EXPECT_EQ(read_sound_settings(sound_file(), problems).headset.cap_dB, 90.0);
    EXPECT_EQ(prompts_folder(), folder_ / "touchline" / "prompts");
    const Chosen file("TOUCHLINE_SOUND", (folder_ / "none").string());
    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(read_sound_settings(sound_file(), problems), SoundSettings{});
    EXPECT_EQ(problems.size(), 1U);
}

}  // namespace
}  // namespace touchline
