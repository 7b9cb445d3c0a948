#include "config/types/utf8.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(PlainLine, LeavesWordsOfEveryScriptAsTheyAre) {
    for (const char* text : {"", "a b", "Fisch \xc3\xa4\xc3\xb6\xc3\xbc.png", "\xe9\xb1\xbc",
                             "\xd8\xb3\xd9\x85\xd9\x83\xd8\xa9", "\xf0\x9f\x90\x9f"})
        EXPECT_EQ(plain_line(text), text);
}

TEST(PlainLine, HasNothingThatATerminalObeysOrThatHides) {
    EXPECT_EQ(plain_line("a\nb\rc\td\x1b[2J\x7f"), "a b c d [2J ");
    EXPECT_EQ(plain_line(std::string_view("a\0b", 3)), "a b");
    EXPECT_EQ(plain_line("\xc2\x80\xc2\x9b\xc2\x9f\xc2\xa0"), "   \xc2\xa0");
    for (const char* mark :
         {"\xd8\x9c", "\xe2\x80\x8b", "\xe2\x80\x8f", "\xe2\x80\xa8", "\xe2\x80\xae",
          "\xe2\x81\xa0", "\xe2\x81\xa9", "\xef\xbb\xbf", "\xf3\xa0\x81\x81"})
        EXPECT_EQ(plain_line(mark), " ") << mark;
}

TEST(PlainLine, ShowsWhatIsNoText) {
    EXPECT_EQ(plain_line("\x9b\xff\xc3"), "???");
    EXPECT_EQ(plain_line("a\xe2\x80"), "a??");
}

}  // namespace
}  // namespace touchline
