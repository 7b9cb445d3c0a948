// Tests a braille line on a machine that has no thread left for it.
#include "app/braille/braille_line.h"
#include "tests/config/no_threads.h"

#include <memory>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(BrailleLine, WithoutAThreadTheKioskGoesOnAndTheLogSaysWhy) {
    std::unique_ptr<BrailleLine> line;
    {
        const NoThreads none;
        line = std::make_unique<BrailleLine>(BrailleUse::contracted);
    }
    line->say({"en", "the house"}, LineUse::now);
    line->rest({"en", "a door"});
    line->choose(BrailleUse::uncontracted);
    line->forget();
    EXPECT_FALSE(line->is_there());
    EXPECT_EQ(line->next_event(), std::nullopt);
    EXPECT_EQ(line->take_report(),
              "the braille line has no thread to run on; start the kiosk again");
    EXPECT_EQ(line->take_report(), "") << "told once";
}

}  // namespace
}  // namespace touchline
