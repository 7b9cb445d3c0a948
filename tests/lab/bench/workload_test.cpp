#include "tests/lab/bench/workload.h"

#include <gtest/gtest.h>

namespace touchline::workload {
namespace {

struct Sum {
    Kind kind;
    std::size_t points;
    std::uint64_t checksum;
};

TEST(Workload, CurvesHaveThePublishedChecksums) {
    for (const Sum& sum :
         {Sum{Kind::radial, 512, 0x12675f5b9dcd8f68}, Sum{Kind::radial, 4096, 0x68e9ccdc7264018d},
          Sum{Kind::radial, 65536, 0x34442995016cda58}, Sum{Kind::fractal, 512, 0x78e03191733d155e},
          Sum{Kind::fractal, 4096, 0xf396adf941b5f0af},
          Sum{Kind::fractal, 65536, 0x0364448d3d00db2f}}) {
        EXPECT_EQ(checksum(curve(sum.kind, sum.points)), sum.checksum) << sum.points;
    }
}

TEST(Workload, HandsHaveThePublishedChecksums) {
    EXPECT_EQ(checksum(hand(Kind::radial)), 0x056c3a4deb068bdbU);
    EXPECT_EQ(checksum(hand(Kind::fractal)), 0x28213903107805e3U);
}

}  // namespace
}  // namespace touchline::workload
