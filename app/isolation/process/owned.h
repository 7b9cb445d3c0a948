// An object of a C library, released with its owner. Threads: those of the library.
#pragma once

#include <memory>

namespace touchline {

/// Calls one function of a library, whatever it returns.
template <auto release>
struct ReleasedBy {
    void operator()(auto* object) const { (void)release(object); }
};

template <class T, auto release>
using Owned = std::unique_ptr<T, ReleasedBy<release>>;

}  // namespace touchline
