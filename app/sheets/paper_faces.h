// The parts of a page that lines close off, whether one line does or several together.
// Threads: one.
#pragma once

#include "app/sheets/tactile_sheet.h"

#include <cstddef>
#include <map>
#include <vector>

namespace touchline {

/// On squares of a millimetre: a gap narrower than that counts as closed.
class PaperFaces {
  public:
    /// O(page + points).
    PaperFaces(const std::vector<SheetStroke>& lines, PaperSize page);

    static constexpr std::size_t open = 0;  // joined to the page's rim
    static constexpr std::size_t line = 1;  // on a line

    /// `open`, `line`, or the number of a closed part. A place beyond the page is open. O(1).
    [[nodiscard]] std::size_t face_at(PaperPoint place) const;

    /// Whether the closed part `face` is all around a place. O(page) when first asked of a face.
    [[nodiscard]] bool is_around(std::size_t face, PaperPoint place);

  private:
    /// The square of a place; one at the rim for a place beyond it.
    [[nodiscard]] std::size_t square(PaperPoint place) const;

    /// Calls `visit` with each square that shares a side with this one.
    template <class Visit>
    void each_beside(std::size_t square, const Visit& visit) const;

    /// Marks what can be reached from these squares, themselves too, over squares that `is_free`.
    template <class IsFree, class Mark>
    void spread(std::vector<std::size_t> from, const IsFree& is_free, const Mark& mark) const;

    [[nodiscard]] std::vector<std::size_t> rim() const;

    std::size_t columns_;
    std::size_t rows_;
    std::vector<std::size_t> faces_;
    std::map<std::size_t, std::vector<bool>> outside_;  // of a face: what the rim reaches around it
};

}  // namespace touchline
