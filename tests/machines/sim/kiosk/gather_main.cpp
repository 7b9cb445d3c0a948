// kiosk_sim_gather COMMAND FIGURES...: combines the figures of several runs. Prints them for people
// on standard output, and writes rows of the reliability table to the file that SIM_CSV names.
#include "tests/machines/sim/kiosk/sim_report.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include <fmt/format.h>

int main(int argc, char** argv) {
    using namespace touchline;
    SimFigures all;
    for (int i = 2; i < argc; ++i) {
        std::ifstream file(argv[i], std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        const auto figures = read_stored(text);
        if (!figures) {
            fmt::print(stderr, "{}: {}\n", argv[i], figures.error().line);
            return 2;
        }
        all.add(*figures);
    }
    fmt::print("{}", lines_of(all));
    const char* const csv = std::getenv("SIM_CSV");
    if (csv != nullptr && argc > 1) std::ofstream(csv) << reliability_csv(all, argv[1]);
    return all.failed_seeds == 0 ? 0 : 1;
}
