// Prints the contents of shipped_outputs.csv.
#include "tests/app/documents/models/shipped_outputs.h"

#include <fmt/core.h>
#include <fmt/format.h>

int main() {
    for (const auto& row : touchline::testing::shipped_outputs())
        fmt::print("{},{:.7g}\n", row.name, fmt::join(row.numbers, ","));
}
