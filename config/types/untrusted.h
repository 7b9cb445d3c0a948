// A value that came from somebody else: it cannot be used before it was looked at.
// Threads: a value.
#pragma once

#include <utility>

namespace touchline {

template <class T>
class Untrusted {
  public:
    explicit Untrusted(T value) : value_(std::move(value)) {}

    /// What `check` makes of it: the only way to what is inside.
    template <class Check>
    [[nodiscard]] auto verify(Check&& check) const {
        return std::forward<Check>(check)(value_);
    }

  private:
    T value_;
};

}  // namespace touchline
