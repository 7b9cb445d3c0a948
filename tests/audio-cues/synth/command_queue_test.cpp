#include "audio-cues/synth/mixer.h"

#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(CommandQueue, GivesBackInOrderAndDropsTheNewestWhenFull) {
    CommandQueue<int, 4> queue;
    EXPECT_FALSE(queue.pop());
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(queue.push(i));
    EXPECT_FALSE(queue.push(4));
    EXPECT_EQ(queue.dropped(), 1U);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(queue.pop(), i);
    EXPECT_FALSE(queue.pop());
    EXPECT_TRUE(queue.push(5));
    EXPECT_EQ(queue.pop(), 5);
}

TEST(CommandQueue, KeepsTheOrderOfEveryWriterAndLosesNothing) {
    struct Value {
        int writer;
        int number;
    };

    constexpr int writers = 3;
    constexpr int count = 20000;
    const auto queue = std::make_unique<CommandQueue<Value, 64>>();
    std::vector<std::jthread> threads;
    for (int writer = 0; writer < writers; ++writer) {
        threads.emplace_back([&queue, writer] {
            for (int i = 0; i < count; ++i) {
                while (!queue->push({writer, i})) std::this_thread::yield();
            }
        });
    }
    std::vector<int> next(writers, 0);
    for (int taken = 0; taken < writers * count;) {
        const auto value = queue->pop();
        if (!value) {
            std::this_thread::yield();
            continue;
        }
        ASSERT_EQ(value->number, next[static_cast<std::size_t>(value->writer)]++);
        ++taken;
    }
    EXPECT_FALSE(queue->pop());
}

}  // namespace
}  // namespace touchline
