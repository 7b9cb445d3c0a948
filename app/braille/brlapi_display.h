// One connection to brltty by BrlAPI: cells to the display, keys from it.
// Threads: one.
#pragma once

#include "config/types/pinned.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace touchline {

class BrlapiDisplay : private Pinned {
  public:
    /// Connects to the brltty of BRLAPI_HOST, else to this machine's, and takes the display,
    /// without a terminal of the kernel's: of the focus among them brltty knows, and a kiosk has
    /// none. Returns null if there is no brltty. `problem` says why one that is there cannot be
    /// used, in one line without its end; else it is empty.
    [[nodiscard]] static std::unique_ptr<BrlapiDisplay> open(std::string& problem);

    ~BrlapiDisplay();

    /// Can be polled for keys.
    [[nodiscard]] int descriptor() const { return descriptor_; }

    /// The cells of the display's first row. 0 while brltty has no display.
    [[nodiscard]] std::size_t width() const { return is_online_ ? columns_ : 0; }

    /// brltty is gone, or wants us no more: the connection is of no more use.
    [[nodiscard]] bool is_lost() const { return is_lost_; }

    /// Puts the cells on the first row; what is left over stays blank. No cursor.
    void show(std::span<const std::uint8_t> cells);

    /// The next key code that has come, and whatever brltty tells of the display; waits for
    /// nothing.
    [[nodiscard]] std::optional<std::uint64_t> next_key();

  private:
    struct Calls;  // what the library calls

    BrlapiDisplay();
    void look();
    void set_size(unsigned int columns, unsigned int rows);

    std::vector<std::max_align_t> handle_;  // of the library's own size
    int descriptor_ = -1;
    std::size_t columns_ = 0;
    std::size_t rows_ = 0;
    bool is_online_ = true;
    bool is_lost_ = false;
    std::vector<std::uint8_t> blank_;
    std::vector<std::uint8_t> dots_;
};

}  // namespace touchline
