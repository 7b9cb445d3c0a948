// board_faults RUNS FILE.csv FILE.md: every kind of fault RUNS times, one line a run and one row of
// the table a kind.
#include "tests/sim/board/fault_run.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {
namespace {

std::string_view name_of(BoardState state) {
    switch (state) {
        case BoardState::ready:
            return "ready";
        case BoardState::resyncing:
            return "resyncing";
        case BoardState::jumped:
            return "jumped";
        case BoardState::lost:
            return "lost";
        default:
            return "closed";
    }
}

std::string milliseconds(double span_s) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", 1e3 * span_s);
    return text;
}

std::string range(std::vector<double> spans_s) {
    if (spans_s.empty()) return "-";
    std::sort(spans_s.begin(), spans_s.end());
    return milliseconds(spans_s[spans_s.size() / 2]) + " / " + milliseconds(spans_s.back());
}

struct Row {
    int noticed = 0, recovered = 0, reopened = 0, doubtful = 0;
    std::vector<double> zero_s, recovery_s;
    BoardState worst = BoardState::ready;

    void add(const FaultRun& run) {
        noticed += run.was_noticed;
        recovered += run.has_recovered;
        reopened += run.has_reopened;
        doubtful += run.is_position_doubtful;
        if (run.was_noticed || run.zero_s < 1.0) zero_s.push_back(run.zero_s);
        if (run.has_recovered) recovery_s.push_back(run.recovery_s);
        worst = std::max(worst, run.worst);
    }
};

void tabulate(std::uint64_t runs, std::ofstream& csv, std::ofstream& table) {
    csv << "fault,seed,noticed,zero_ms,recovery_ms,recovered,reopened,worst,doubtful,error_"
           "counts\n";
    table << "| fault | runs | noticed | zero torque, ms (median / worst) | worst state | back by "
             "itself "
             "| within, ms (median / worst) | opened anew | position doubtful |\n"
             "|---|---|---|---|---|---|---|---|---|\n";
    for (const FaultKind& kind : fault_kinds()) {
        Row row;
        for (std::uint64_t seed = 0; seed < runs; ++seed) {
            const FaultRun run = run_fault(kind, seed);
            row.add(run);
            csv << '"' << kind.name << "\"," << seed << ',' << run.was_noticed << ','
                << milliseconds(run.zero_s) << ',' << milliseconds(run.recovery_s) << ','
                << run.has_recovered << ',' << run.has_reopened << ',' << name_of(run.worst) << ','
                << run.is_position_doubtful << ',' << run.largest_error_counts << '\n';
        }
        table << "| " << kind.name << " | " << runs << " | " << row.noticed << " | "
              << range(row.zero_s) << " | " << name_of(row.worst) << " | " << row.recovered << " | "
              << range(row.recovery_s) << " | " << row.reopened << " | " << row.doubtful << " |\n";
    }
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fputs("usage: board_faults RUNS FILE.csv FILE.md\n", stderr);
        return 2;
    }
    std::ofstream csv(argv[2]), table(argv[3]);
    touchline::tabulate(std::strtoull(argv[1], nullptr, 10), csv, table);
    return csv && table ? 0 : 1;
}
