// The keys that do something now, as they stand along the lower edge: a shape and a name for each.
// Threads: pure functions, and one at a time per Canvas.
#pragma once

#include "app/screen/layout.h"
#include "app/visit/screen_model.h"
#include "config/types/choices.h"

#include <optional>
#include <string>
#include <vector>

#include <cairo.h>

namespace touchline {

struct LegendKey {
    std::optional<KeyRole> role;  // nothing: any key
    std::string name;

    friend bool operator==(const LegendKey&, const LegendKey&) = default;
};

/// What acts on this screen, with keys or with one or two switches.
[[nodiscard]] std::vector<LegendKey> legend_of(const SpokenScreen& screen, SwitchUse switches,
                                               const Language& language);

/// All that legend_of() may give for keys: the widest legend.
[[nodiscard]] std::vector<LegendKey> whole_legend(const Language& language);

[[nodiscard]] double legend_width_px(cairo_t* cr, const std::vector<LegendKey>& keys,
                                     const TextSizes& sizes);

/// Paints them from the left edge of `row`. Without names only where the key has a shape.
void paint_legend(cairo_t* cr, const Rect& row, const std::vector<LegendKey>& keys, bool has_names,
                  const TextSizes& sizes, const Palette& palette);

}  // namespace touchline
