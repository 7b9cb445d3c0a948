// Memory in large pages, for arrays of megabytes: the system hands it out in a fraction of the
// time, and a processor finds its way in it sooner. Threads: any.
#pragma once

#include <cstddef>
#include <vector>

namespace touchline {

/// Asks for large pages behind memory that nobody has touched yet. Changes nothing below 4 MiB, nor
/// where the system has none or refuses.
void ask_for_large_pages(void* start, std::size_t bytes);

/// Reserves room for `count` values, in large pages where that is much. Throws as reserve().
template <class T>
void reserve_in_large_pages(std::vector<T>& values, std::size_t count) {
    values.reserve(count);
    ask_for_large_pages(values.data(), count * sizeof(T));
}

}  // namespace touchline
