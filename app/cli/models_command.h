// touchline models: the networks that Touchline can use, their licences, and how to get them.
// Threads: one.
#pragma once

#include "config/types/result.h"

#include <cstdint>
#include <iosfwd>
#include <string>

namespace touchline {

/// list: what is known of each, and whether it is here. check: whether those that are here, or
/// ship, are whole. get: downloads one of the others from its publisher, after showing its licence
/// and getting the user's agreement.
enum class ModelsAction : std::uint8_t { list, check, get };

struct ModelsCommandOptions {
    ModelsAction action = ModelsAction::list;
    std::string name;        // for get
    bool is_agreed = false;  // get does not ask
};

/// `in`: where the answer "yes" is read from. Fails with one line: a damaged network, an unknown
/// name, an answer other than yes, or a failed download.
[[nodiscard]] Result<void> run_models(const ModelsCommandOptions& options, std::istream& in,
                                      std::ostream& out);

}  // namespace touchline
