#include "app/kiosk/pictures.h"

#include "app/gallery/gallery.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace touchline {
namespace {

FilePtr file_named(const std::string& name) {
    return std::make_shared<const PictureFile>(PictureFile{name, name, "", true, {}});
}

TEST(Pictures, TheGalleryIsReadInEveryLanguage) {
    std::vector<Language> languages(1);
    languages.push_back(Language::load(TOUCHLINE_CATALOGUES, "de").value());
    const auto gallery = read_gallery(TOUCHLINE_SOURCE_DIR "/app/gallery/pictures", "", languages);
    ASSERT_TRUE(gallery.has_value()) << gallery.error().line;
    ASSERT_EQ(gallery->titles.size(), 2U);
    ASSERT_EQ(gallery->titles[0].size(), gallery->titles[1].size());
    ASSERT_EQ(gallery->files[1].size(), gallery->titles[1].size());
    EXPECT_NE(gallery->titles[0][5].title, gallery->titles[1][5].title);
    ASSERT_NE(gallery->circle, nullptr);
    ASSERT_NE(gallery->square, nullptr);
    EXPECT_NE(gallery->circle, gallery->square);
}

TEST(Pictures, ThatCannotBeReadAreOneLine) {
    const auto gallery = read_gallery("/nowhere", "", std::vector<Language>(1));
    ASSERT_FALSE(gallery.has_value());
    EXPECT_NE(gallery.error().line.find("/nowhere"), std::string::npos);
}

TEST(Pictures, OneThatCannotBeOpenedIsToldByItsTitle) {
    namespace fs = std::filesystem;
    const fs::path folder =
        fs::path(testing::TempDir()) / ("touchline-gallery-" + std::to_string(getpid()));
    fs::copy(TOUCHLINE_SOURCE_DIR "/app/gallery/pictures", folder);
    const auto gallery = read_gallery(folder, "", std::vector<Language>(1));
    fs::remove_all(folder);
    ASSERT_TRUE(gallery.has_value()) << gallery.error().line;
    const FilePtr picture = gallery->files.front().front();
    const auto page = picture->open({});
    ASSERT_FALSE(page.has_value());
    EXPECT_TRUE(page.error().line.starts_with(picture->name + ": ")) << page.error().line;
    EXPECT_EQ(page.error().line.find(folder.string()), std::string::npos) << page.error().line;
}

TEST(Pictures, AChoiceIsAFileOrNothing) {
    Gallery gallery;
    gallery.files = {{file_named("a"), file_named("b")}};
    gallery.circle = file_named("circle");
    gallery.square = file_named("square");
    Pictures pictures(gallery);
    const auto of = [&pictures](PictureSource source, std::size_t index) {
        LoadPicture order;
        order.source = source;
        order.index = index;
        const FilePtr file = pictures.of(order);
        return file ? file->name : "nothing";
    };
    EXPECT_EQ(of(PictureSource::practice, 0), "circle");
    EXPECT_EQ(of(PictureSource::practice, 1), "square");
    EXPECT_EQ(of(PictureSource::gallery, 1), "b");
    EXPECT_EQ(of(PictureSource::gallery, 2), "nothing");
    EXPECT_EQ(of(PictureSource::stick, 0), "nothing");
    EXPECT_EQ(of(PictureSource::camera, 0), "nothing");
    pictures.put_stick({file_named("stick")});
    pictures.put_photo(file_named("photo"));
    EXPECT_EQ(of(PictureSource::stick, 0), "stick");
    EXPECT_EQ(of(PictureSource::camera, 0), "photo");
    pictures.forget();
    EXPECT_EQ(of(PictureSource::stick, 0), "nothing");
    EXPECT_EQ(of(PictureSource::camera, 0), "nothing");
    EXPECT_EQ(of(PictureSource::gallery, 0), "a");
}

}  // namespace
}  // namespace touchline
