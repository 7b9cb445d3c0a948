// OpenCV's random state of the calling thread, fixed for as long as an object lives.
#pragma once

#include "config/types/pinned.h"

#include <cstdint>

#include <opencv2/core.hpp>

namespace touchline {

/// Gives the same random numbers on every call, whatever else used the thread's random state.
class FixedRandomState : Pinned {
  public:
    FixedRandomState() : before_(cv::theRNG().state) { cv::theRNG().state = 20051; }

    ~FixedRandomState() { cv::theRNG().state = before_; }

  private:
    std::uint64_t before_;
};

}  // namespace touchline
