// Tests the table of several kiosks' days.
#include "app/house/joined_counters.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

using std::chrono::sys_days;
using namespace std::chrono_literals;

CountedDays days_from(std::chrono::year_month_day first, int count, std::uint64_t visits) {
    CountedDays days;
    for (int i = 0; i < count; ++i)
        counts_on(sys_days(first) + std::chrono::days(i), days).visits = visits;
    return days;
}

TEST(JoinedCounters, HaveALineForAKioskAndADay) {
    const auto csv = joined_counters_csv({{"hall", days_from(2026y / 3 / 1, 2, 5)},
                                          {"cellar", days_from(2026y / 3 / 2, 1, 7)},
                                          {"attic", {}}});
    ASSERT_TRUE(csv.has_value());
    EXPECT_EQ(*csv,
              "kiosk,day,visits,gallery_pictures,stick_pictures,camera_pictures,minutes,faults\n"
              "cellar,2026-03-02,7,0,0,0,0,0\n"
              "hall,2026-03-01,5,0,0,0,0,0\n"
              "hall,2026-03-02,5,0,0,0,0,0\n");
}

TEST(JoinedCounters, RefuseNamesThatAreNotTheirOwn) {
    EXPECT_FALSE(joined_counters_csv({{"hall", {}}, {"hall", {}}}).has_value());
    for (const char* name : {"", "=1+1", "a,b", "a\"b", "a\nb", "-a", "@a", "+a", "ä"})
        EXPECT_FALSE(joined_counters_csv({{name, {}}}).has_value()) << name;
}

TEST(JoinedCounters, NameAKioskByItsFile) {
    EXPECT_EQ(kiosk_of_file("/from/hall 2.csv"), "hall 2");
    EXPECT_EQ(kiosk_of_file("/from/hall 2/touchline-days.csv"), "hall 2");
    EXPECT_EQ(kiosk_of_file("/from/hall 2/counters.csv"), "hall 2");
}

}  // namespace
}  // namespace touchline
