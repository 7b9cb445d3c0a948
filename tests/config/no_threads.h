// A machine that has no thread left. Threads: the test's.
#pragma once

#include "config/types/pinned.h"

#include <cstddef>

#include <gtest/gtest.h>
#include <pthread.h>

namespace touchline {

/// While it lives, no thread can be started: each would need a stack larger than any memory.
class NoThreads : private Pinned {
  public:
    NoThreads() {
        EXPECT_EQ(pthread_getattr_default_np(&before_), 0);
        pthread_attr_t none;
        EXPECT_EQ(pthread_attr_init(&none), 0);
        EXPECT_EQ(pthread_attr_setstacksize(&none, std::size_t{1} << 50U), 0);
        EXPECT_EQ(pthread_setattr_default_np(&none), 0);
        pthread_attr_destroy(&none);
    }

    ~NoThreads() {
        EXPECT_EQ(pthread_setattr_default_np(&before_), 0);
        pthread_attr_destroy(&before_);
    }

  private:
    pthread_attr_t before_{};
};

}  // namespace touchline
