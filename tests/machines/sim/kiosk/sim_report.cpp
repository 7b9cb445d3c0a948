#include "tests/machines/sim/kiosk/sim_report.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace touchline {
namespace {

struct Count {
    const char* name;
    std::uint64_t SimFigures::*member;
};

struct Value {
    const char* name;
    double SimFigures::*member;
};

constexpr std::array counts{
    Count{"seeds", &SimFigures::seeds},       Count{"failed_seeds", &SimFigures::failed_seeds},
    Count{"ticks", &SimFigures::ticks},       Count{"visits", &SimFigures::visits},
    Count{"pictures", &SimFigures::pictures}, Count{"keys", &SimFigures::keys},
    Count{"cues", &SimFigures::cues},         Count{"utterances", &SimFigures::utterances},
    Count{"strokes", &SimFigures::strokes},   Count{"grown", &SimFigures::grown},
    Count{"sheets", &SimFigures::sheets},     Count{"turned_pages", &SimFigures::turned_pages},
};

constexpr std::array values{
    Value{"servo_s", &SimFigures::servo_s},
    Value{"session_s", &SimFigures::session_s},
    Value{"most_N", &SimFigures::most_N},
    Value{"most_N_share", &SimFigures::most_N_share},
    Value{"most_torque_Nm", &SimFigures::most_torque_Nm},
    Value{"most_rise_N_per_s", &SimFigures::most_rise_N_per_s},
    Value{"most_change_N_per_s", &SimFigures::most_change_N_per_s},
    Value{"most_grown_N", &SimFigures::most_grown_N},
    Value{"most_given_J", &SimFigures::most_given_J},
    Value{"longest_answer_s", &SimFigures::longest_answer_s},
    Value{"longest_cue_s", &SimFigures::longest_cue_s},
    Value{"longest_ready_s", &SimFigures::longest_ready_s},
    Value{"longest_silence_s", &SimFigures::longest_silence_s},
};

std::string name_of(const char* what, std::size_t kind) {
    std::string name = fmt::format("{} {}", what, sim_fault_kinds()[kind].name);
    for (char& letter : name)
        if (letter == ' ') letter = '_';
    return name;
}

/// Visits every number of the figures, by name.
template <class Figures, class Count, class Value>
void visit_all(Figures& figures, Count count, Value value) {
    for (const auto& row : counts) count(row.name, figures.*row.member);
    for (const auto& row : values) value(row.name, figures.*row.member);
    for (std::size_t i = 0; i < sim_fault_count; ++i) {
        count(name_of("fired", i), figures.fired[i]);
        count(name_of("pressed", i), figures.pressed[i]);
        value(name_of("zero_s", i), figures.zero_s[i]);
    }
}

std::map<std::string, std::string, std::less<>> pairs_in(std::string_view text) {
    std::map<std::string, std::string, std::less<>> pairs;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        const std::size_t blank = line.find(' ');
        if (blank != std::string_view::npos)
            pairs.emplace(line.substr(0, blank), line.substr(blank + 1));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return pairs;
}

std::string quoted(const std::string& text) {
    std::string quoted = "\"";
    for (const char letter : text) {
        if (letter == '"') quoted += '"';
        quoted += letter;
    }
    return quoted + '"';
}

/// One line of the reliability table.
struct Row {
    int row;
    std::string figure, value, bar;
    const char* passed;
};

const char* verdict(bool has_passed) {
    return has_passed ? "yes" : "no";
}

void add_zero_rows(const SimFigures& figures, std::vector<Row>& rows) {
    for (std::size_t i = 0; i < sim_fault_count; ++i) {
        const SimFaultKind& kind = sim_fault_kinds()[i];
        if (!kind.zero_s) continue;
        const double bar_s = *kind.zero_s + wire_s;
        rows.push_back(
            {3, fmt::format("zero torque after: {}", kind.name),
             figures.pressed[i] == 0 ? std::string("never with torque on")
                                     : fmt::format("{:.2f} ms of {} times", 1e3 * figures.zero_s[i],
                                                   figures.pressed[i]),
             fmt::format("{:.1f} ms, {:.1f} of it on the wire", 1e3 * bar_s, 1e3 * wire_s),
             figures.pressed[i] == 0 ? "reported" : verdict(figures.zero_s[i] <= bar_s)});
    }
}

std::vector<Row> rows_of(const SimFigures& figures) {
    const double servo_h = figures.servo_s / 3600.0;
    const double session_h = figures.session_s / 3600.0;
    const std::uint64_t fewest = *std::ranges::min_element(figures.fired);
    std::vector<Row> rows{
        {1, "simulated hours, the house's", fmt::format("{:.1f} h", session_h), ">= 1000 h",
         verdict(session_h >= 1000.0)},
        {1, "simulated hours with the servo at 1 kHz",
         fmt::format("{:.1f} h, {} ticks", servo_h, figures.ticks), ">= 100 h",
         verdict(servo_h >= 100.0)},
        {1, "seeds; of these failed", fmt::format("{}; {}", figures.seeds, figures.failed_seeds),
         "0 failed", verdict(figures.failed_seeds == 0)},
        {2, "kinds of faults; the rarest came",
         fmt::format("{}; {} times", sim_fault_count, fewest), "> 100 each", verdict(fewest > 100)},
    };
    for (std::size_t i = 0; i < sim_fault_count; ++i)
        rows.push_back({2, fmt::format("came: {}", sim_fault_kinds()[i].name),
                        fmt::format("{}", figures.fired[i]), "> 100",
                        verdict(figures.fired[i] > 100)});
    add_zero_rows(figures, rows);
    rows.insert(
        rows.end(),
        {{4, "largest force", fmt::format("{:.3f} N", figures.most_N), "<= 3 N",
          verdict(figures.most_N_share <= 1.0 + 1e-9)},
         {4, "fastest growth of the force", fmt::format("{:.1f} N/s", figures.most_rise_N_per_s),
          "<= 300 N/s", verdict(figures.most_rise_N_per_s <= 300.0 * (1.0 + 1e-6))},
         {4, "fastest change of the force", fmt::format("{:.1f} N/s", figures.most_change_N_per_s),
          "<= 1500 N/s", verdict(figures.most_change_N_per_s <= 1500.0 * (1.0 + 1e-6))},
         {4, "largest torque of a motor", fmt::format("{:.4f} N m", figures.most_torque_Nm),
          "<= 0.1107 N m", verdict(figures.most_torque_Nm <= 0.9 * 0.123 * (1.0 + 1e-9))},
         {4, "change of the force by a line that came, beyond the hand's motion",
          fmt::format("{:.4f} N of {} times", figures.most_grown_N, figures.grown), "<= 0.021 N",
          figures.grown == 0 ? "reported" : verdict(figures.most_grown_N <= 0.021)},
         {5, "energy given to a hand in a second", fmt::format("{:.4f} J", figures.most_given_J),
          "<= 0.05 J", verdict(figures.most_given_J <= 0.05)},
         {26, "longest from a key or a change to speech or a cue",
          fmt::format("{:.0f} ms", 1e3 * figures.longest_answer_s), "<= 150 ms",
          verdict(figures.longest_answer_s <= 0.150)},
         {26, "longest from what the hand meets to its cue",
          fmt::format("{:.1f} ms", 1e3 * figures.longest_cue_s), "<= 150 ms",
          verdict(figures.longest_cue_s <= 0.150)},
         {1, "longest until force may come again once all is over",
          fmt::format("{:.2f} s", figures.longest_ready_s), "<= 5 s",
          verdict(figures.longest_ready_s <= 5.0)}});
    return rows;
}

}  // namespace

std::string lines_of(const SimFigures& figures) {
    std::string text = fmt::format(
        "{} seeds, {} failed: {:.2f} h of the house, {:.2f} h with the servo ({} ticks)\n"
        "{} visits, {} pictures, {} keys, {} cues of the hand\n"
        "{} strokes drawn, {} changes of a drawing under force, {} sheets, {} pages of braille\n",
        figures.seeds, figures.failed_seeds, figures.session_s / 3600.0, figures.servo_s / 3600.0,
        figures.ticks, figures.visits, figures.pictures, figures.keys, figures.cues,
        figures.strokes, figures.grown, figures.sheets, figures.turned_pages);
    for (const Row& row : rows_of(figures))
        text += fmt::format("  {:2} {}: {} (bar {})\n", row.row, row.figure, row.value, row.bar);
    return text;
}

std::string stored(const SimFigures& figures) {
    std::string text;
    visit_all(
        figures,
        [&](const std::string& name, std::uint64_t n) { text += fmt::format("{} {}\n", name, n); },
        [&](const std::string& name, double value) {
            text += fmt::format("{} {}\n", name, value);
        });
    return text;
}

Result<SimFigures> read_stored(std::string_view text) {
    const auto pairs = pairs_in(text);
    SimFigures figures;
    std::string missing;
    const auto read = [&](const std::string& name, auto& number) {
        const auto at = pairs.find(name);
        const bool is_there = at != pairs.end();
        if (is_there) {
            const std::string& digits = at->second;
            const auto end = digits.data() + digits.size();
            const auto [last, error] = std::from_chars(digits.data(), end, number);
            if (error == std::errc() && last == end) return;
        }
        missing = name;
    };
    visit_all(figures, read, read);
    if (!missing.empty()) return failure("figures of a simulation: no number for " + missing);
    return figures;
}

std::string reliability_csv(const SimFigures& figures, const std::string& command) {
    std::string text = "row,figure,value,bar,passed,how\n";
    for (const Row& row : rows_of(figures))
        text +=
            fmt::format("{},{},{},{},{},{}\n", quoted(std::to_string(row.row)), quoted(row.figure),
                        quoted(row.value), quoted(row.bar), quoted(row.passed), quoted(command));
    return text;
}

}  // namespace touchline
