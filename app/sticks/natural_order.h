// The order in which people look for names: "page 2" before "page 10", "a" beside "A" and "ä".
// Threads: each object by one thread at a time.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <unicode/coll.h>

namespace touchline {

/// Construct it before the sandbox closes: its tables come with the library, but may be read late.
class NaturalOrder {
  public:
    /// The order that all languages share. Aborts if the library has no tables, because then the
    /// installation is broken.
    NaturalOrder();

    /// Compared as bytes, keys order the names; no two names have the same key. Stray bytes stand
    /// for U+FFFD. O(n), at most some 20 bytes per byte.
    [[nodiscard]] std::string key_of(std::string_view name) const;

  private:
    std::unique_ptr<icu::Collator> collator_;
};

}  // namespace touchline
