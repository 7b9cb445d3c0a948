// What is known of a picture that is felt. Threads: a value.
#pragma once

#include "app/session/page_place.h"

#include <string>

namespace touchline {

struct LoadedFacts {
    std::string title;
    int outline_count = 0;
    int coarsest_level = 0;
    std::string note;  // one sentence worth telling; may be empty
    PagePlace place = {1, 1, 1, 1};
};

}  // namespace touchline
