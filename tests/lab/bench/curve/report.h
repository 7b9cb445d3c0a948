// The sections of the bench, and where their results go: tables as CSV for charts, and words for
// readers. Threads: one.
#pragma once

#include "config/types/result.h"

#include <string>
#include <vector>

namespace touchline::bench {

struct Folders {
    std::string results;  // pictures, kept
    std::string work;  // NAME.md: the text between the marks of the README; NAME.csv, .dat: to plot
};

/// Rows of cells under a header, all with the same number of cells.
struct Table {
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;

    [[nodiscard]] std::string csv() const;
    [[nodiscard]] std::string markdown() const;
};

[[nodiscard]] Result<void> write_csv(const Folders& folders, const std::string& name,
                                     const Table& table);

/// Writes the section `name` of the README, wrapped at 110 columns unless it is a table.
[[nodiscard]] Result<void> write_words(const Folders& folders, const std::string& name,
                                       const std::string& text);

/// Returns "a", "a and b", "a, b and c".
[[nodiscard]] std::string list_in_words(const std::vector<std::string>& items);

// The sections: each measures, then writes its CSV or data to plot, and its words.

/// Measures how far coarse curves lie from real outlines, by method and level, and how wide their
/// boxes are.
[[nodiscard]] Result<void> measure_errors(const Folders& folders);

/// Measures the same on curves that are known without their noise.
[[nodiscard]] Result<void> measure_noise(const Folders& folders);

/// Measures how long the methods take.
[[nodiscard]] Result<void> measure_times(const Folders& folders);

/// Measures how many points resampling keeps of the gallery's pictures.
[[nodiscard]] Result<void> measure_points(const Folders& folders);

/// Writes the data of the paper's Figs. 1 to 3: coefficients and approximations.
[[nodiscard]] Result<void> plot_levels(const Folders& folders);

/// Writes the data of the paper's Fig. 4: boundary sections as a handle approaches.
[[nodiscard]] Result<void> plot_sections(const Folders& folders);

/// Paints the paper's Fig. 7: curve and error boxes over the picture.
[[nodiscard]] Result<void> paint_boxes(const Folders& folders);

}  // namespace touchline::bench
