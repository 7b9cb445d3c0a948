// Measures the stability maps and writes one CSV file per slice, and a hash of all their lines.
#include "tests/lab/stability/slices.h"

#include <fstream>

#include <fmt/core.h>

int main(int argc, char** argv) {
    using namespace touchline::stability;
    if (argc != 2) {
        fmt::print(stderr, "usage: stability_bench FOLDER\n");
        return 2;
    }
    std::uint64_t hash = hashed("");
    int unstable = 0;
    for (const Slice& slice : slices()) {
        fmt::print("{:<10} {:4} cells: {}\n", slice.name, slice.cells.size(), slice.title);
        const auto results = measure_all(slice.cells);
        std::ofstream csv(std::string(argv[1]) + "/" + slice.name + ".csv");
        csv << "# The same on every machine: tests/lab/stability/run\n" << cell_columns << '\n';
        for (std::size_t i = 0; i < results.size(); ++i) {
            const std::string line = csv_line(slice.cells[i], results[i]);
            csv << line << '\n';
            hash = hashed(line, hash);
            unstable += results[i].unstable_below;
        }
        if (!csv.flush()) {
            fmt::print(stderr, "stability_bench: cannot write into {}\n", argv[1]);
            return 1;
        }
    }
    fmt::print("unstable below the limits of passivity: {}\n", unstable);
    std::ofstream(std::string(argv[1]) + "/hash.txt") << fmt::format("{:016x}\n", hash);
    return unstable == 0 ? 0 : 1;
}
