// Failures that the world can cause (files, devices, users) are returned as a Result; those that
// only a bug can cause are asserts. No exception leaves a folder.
#pragma once

#include <string>

#include <tl/expected.hpp>

namespace touchline {

/// One clear line for a person: what happened, why, and what to do. No trailing newline.
struct Error {
    std::string line;
};

template <class T, class E = Error>
using Result = tl::expected<T, E>;

[[nodiscard]] inline tl::unexpected<Error> failure(std::string line) {
    return tl::unexpected<Error>(Error{std::move(line)});
}

}  // namespace touchline
