#include "app/gallery/gallery.h"

#include "app/decode/files.h"

#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

const std::string pictures_folder = TOUCHLINE_SOURCE_DIR "/app/gallery/pictures";

class GalleryFolder : public testing::Test {
  protected:
    GalleryFolder()
        : folder_(testing::TempDir() + "touchline-gallery-" + std::to_string(::getpid())) {
        fs::create_directory(folder_);
    }

    ~GalleryFolder() override {
        ::unsetenv("TOUCHLINE_GALLERY");  // NOLINT(concurrency-mt-unsafe): one thread
        fs::remove_all(folder_);
    }

    [[nodiscard]] std::string folder() const { return folder_; }

    void put(const std::string& name, const std::string& text) const {
        ASSERT_TRUE(write_whole_file(folder_ / name, text));
    }

  private:
    fs::path folder_;
};

constexpr auto smallest = "<svg viewBox='0 0 9 9'><title>T</title><path d='M1 1L2 2'/></svg>";

TEST_F(GalleryFolder, MapsAreListedByFileNameAndOtherFilesAreNot) {
    put("20-b.svg", smallest);
    put("10-c.svg", smallest);
    put("05-notes.txt", "no map");
    const auto entries = list_gallery(folder());
    ASSERT_TRUE(entries) << entries.error().line;
    ASSERT_EQ(entries->size(), 2U);
    EXPECT_EQ(entries->at(0).path, folder() + "/10-c.svg");
    EXPECT_EQ(entries->at(1).path, folder() + "/20-b.svg");
    EXPECT_EQ(entries->at(0).title, "T");
}

TEST_F(GalleryFolder, MissingEmptyAndBrokenAreOneLine) {
    const auto missing = list_gallery(folder() + "/none");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().line.find("No such file or directory"), std::string::npos);
    const auto empty = list_gallery(folder());
    ASSERT_FALSE(empty);
    EXPECT_NE(empty.error().line.find("holds no .svg file"), std::string::npos);
    put("01-broken.svg", "<svg");
    const auto broken = list_gallery(folder());
    ASSERT_FALSE(broken);
    EXPECT_TRUE(broken.error().line.starts_with(folder() + "/01-broken.svg: "));
}

TEST_F(GalleryFolder, SpeaksTheLanguageAndKnowsTheDifficulty) {
    put("1.svg",
        "<svg viewBox='0 0 9 9' data-difficulty='4'><title>Sea</title><title "
        "xml:lang='fr'>Mer</title>"
        "<path d='M1 1L2 2'/></svg>");
    put("2.svg", smallest);
    const auto entries = list_gallery(folder(), {"fr"}).value();
    EXPECT_EQ(entries[0].title, "Mer");
    EXPECT_EQ(entries[0].difficulty, 4);
    EXPECT_EQ(entries[1].title, "T");
    EXPECT_EQ(entries[1].difficulty, std::nullopt);
    EXPECT_EQ(list_gallery(folder()).value()[0].title, "Sea");
    put("3.svg", "<svg viewBox='0 0 9 9' data-difficulty='9'><path d='M1 1L2 2'/></svg>");
    const auto broken = list_gallery(folder());
    ASSERT_FALSE(broken);
    EXPECT_TRUE(broken.error().line.starts_with(folder() + "/3.svg: ")) << broken.error().line;
}

TEST_F(GalleryFolder, TheEnvironmentChoosesAnother) {
    EXPECT_EQ(gallery_folder(), pictures_folder);
    ::setenv("TOUCHLINE_GALLERY", folder().c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
    EXPECT_EQ(gallery_folder(), folder());
    ::setenv("TOUCHLINE_GALLERY", "", 1);  // NOLINT(concurrency-mt-unsafe)
    EXPECT_EQ(gallery_folder(), pictures_folder);
}

}  // namespace
}  // namespace touchline
