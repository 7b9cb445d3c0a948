// Tests that a worker reads from its command line what it was started for, bit for bit.
#include "app/documents/trace/trace_work.h"

#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

TraceWork any_work() {
    TraceWork work;
    work.step = static_cast<TraceStep>(*rc::gen::inRange(0, 3));
    work.options.area = {*rc::gen::arbitrary<double>(), *rc::gen::arbitrary<double>()};
    work.options.detail = *rc::gen::inRange(-9, 9);
    work.options.zoom = {{*rc::gen::arbitrary<double>(), *rc::gen::arbitrary<double>()},
                         *rc::gen::arbitrary<double>()};
    if (*rc::gen::arbitrary<bool>())
        work.options.picture_class = static_cast<PictureClass>(*rc::gen::inRange(0, 4));
    work.wants_edges = *rc::gen::arbitrary<bool>();
    work.cut = {*rc::gen::arbitrary<double>(), 1.5, *rc::gen::arbitrary<double>(), 40.0};
    return work;
}

RC_GTEST_PROP(TraceWork, ReadsBackBitForBit, ()) {
    const TraceWork work = any_work();
    const auto read = trace_work_in(arguments_of(work));
    RC_ASSERT(read.has_value());
    RC_ASSERT(read->step == work.step);
    RC_ASSERT(read->options.area == work.options.area);
    RC_ASSERT(read->options.detail == work.options.detail);
    RC_ASSERT(read->options.zoom == work.options.zoom);
    RC_ASSERT(read->options.picture_class == work.options.picture_class);
    RC_ASSERT(read->wants_edges == work.wants_edges);
    RC_ASSERT(read->cut.left == work.cut.left && read->cut.right == work.cut.right);
    RC_ASSERT(read->cut.top == work.cut.top && read->cut.bottom == work.cut.bottom);
}

TEST(TraceWork, AnythingElseIsRefused) {
    const auto right = arguments_of({});
    EXPECT_TRUE(trace_work_in(right).has_value());
    EXPECT_FALSE(trace_work_in({}).has_value());
    for (std::size_t i = 0; i < right.size(); ++i) {
        for (const char* const wrong : {"", "x", "1 ", "0x1"}) {
            auto arguments = right;
            arguments[i] = wrong;
            EXPECT_FALSE(trace_work_in(arguments).has_value()) << i << " " << wrong;
        }
    }
    for (const char* const step : {"3", "-1", "0.5", "nan", "1e300"}) {
        auto arguments = right;
        arguments[0] = step;
        EXPECT_FALSE(trace_work_in(arguments).has_value()) << step;
    }
    auto longer = right;
    longer.emplace_back("0");
    EXPECT_FALSE(trace_work_in(longer).has_value());
}

/// The code that uses a number checks it, so it must arrive unchanged.
TEST(TraceWork, NotANumberStaysOne) {
    TraceWork work;
    work.options.zoom.factor = std::numeric_limits<double>::quiet_NaN();
    const auto read = trace_work_in(arguments_of(work));
    ASSERT_TRUE(read.has_value());
    EXPECT_NE(read->options.zoom.factor, read->options.zoom.factor);
}

}  // namespace
}  // namespace touchline
