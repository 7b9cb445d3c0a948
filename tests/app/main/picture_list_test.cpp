#include "app/main/picture_list.h"

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::vector<FilePtr> some_files(int count) {
    std::vector<FilePtr> files;
    for (int i = 0; i < count; ++i)
        files.push_back(
            std::make_shared<const PictureFile>(PictureFile{std::to_string(i), "", "", false, {}}));
    return files;
}

TEST(PictureList, TheSticksFilesComeFirstWhileItIsThere) {
    const auto standing = some_files(3);
    const auto of_stick = some_files(2);
    PictureList list(standing);
    EXPECT_EQ(list.size(), 3);
    EXPECT_EQ(list.place_of(standing[1]), 1);
    list.put_stick(of_stick);
    EXPECT_EQ(list.size(), 5);
    EXPECT_EQ(list.at(0), of_stick[0]);
    EXPECT_EQ(list.at(2), standing[0]);
    EXPECT_EQ(list.place_of(of_stick[1]), 1);
    EXPECT_EQ(list.place_of(standing[1]), 3);
    list.put_stick({});
    EXPECT_EQ(list.size(), 3);
    EXPECT_EQ(list.place_of(of_stick[0]), std::nullopt);
    EXPECT_EQ(list.place_of(nullptr), std::nullopt);
}

}  // namespace
}  // namespace touchline
