#include "app/isolation/process/memory.h"

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <malloc.h>

namespace touchline {
namespace {

/// Returns how many arenas glibc has.
int arenas() {
    char* text = nullptr;
    std::size_t size = 0;
    FILE* const stream = open_memstream(&text, &size);
    (void)malloc_info(0, stream);
    (void)std::fclose(stream);
    const std::string told(text, size);
    std::free(text);  // NOLINT: as open_memstream says
    int count = 0;
    for (std::size_t at = 0; (at = told.find("<heap ", at)) != std::string::npos; ++at) ++count;
    return count;
}

/// Returns the number after several threads allocated memory at once.
int arenas_after_threads() {
    std::atomic<int> ready{0};
    std::array<std::vector<char>, 4> taken;
    std::array<std::thread, 4> threads;
    for (std::size_t i = 0; i < threads.size(); ++i) {
        threads.at(i) = std::thread([&ready, &one = taken.at(i)] {
            one.resize(5000);
            for (++ready; ready < 4;) std::this_thread::yield();
        });
    }
    for (std::thread& thread : threads) thread.join();
    return arenas();
}

/// Each case has its own process, since glibc keeps the arenas that it once has.
TEST(CompactMemoryDeathTest, ThreadsShareOneArena) {
    EXPECT_EXIT(
        {
            keep_memory_compact();
            std::exit(arenas_after_threads() == 1 ? 0 : 1);
        },
        testing::ExitedWithCode(0), "");
    EXPECT_EXIT(std::exit(arenas_after_threads() > 1 ? 0 : 1), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace touchline
