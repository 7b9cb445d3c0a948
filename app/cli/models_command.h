// touchline models: the networks that Touchline can use, their licences, and how they are got.
// Threads: one.
#pragma once

#include "config/types/result.h"

#include <cstdint>
#include <iosfwd>
#include <string>

namespace touchline {

/// list: what is known of each, and whether it is here. check: whether those that are here, or
/// ship, are whole. get: one of the others from its publisher, after its licence was shown and
/// agreed to.
enum class ModelsAction : std::uint8_t { list, check, get };

struct ModelsCommandOptions {
    ModelsAction action = ModelsAction::list;
    std::string name;        // of get
    bool is_agreed = false;  // get does not ask
};

/// `in`: where the answer "yes" is read from. Fails with one line: a network that is damaged, a
/// name that nobody knows, an answer other than yes, whatever keeps it from being got.
[[nodiscard]] Result<void> run_models(const ModelsCommandOptions& options, std::istream& in,
                                      std::ostream& out);

}  // namespace touchline
