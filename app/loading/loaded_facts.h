// What is known of a picture that is felt. Threads: a value.
#pragma once

#include "app/session/page_place.h"
#include "config/types/thing_name.h"

#include <string>
#include <vector>

namespace touchline {

struct LoadedFacts {
    std::string title;
    int outline_count = 0;
    int coarsest_level = 0;
    std::string note;  // one sentence worth telling; may be empty
    PagePlace place = {1, 1, 1, 1};
    std::vector<NamedThing> names = {};  // what the things of a photograph are taken for
};

}  // namespace touchline
