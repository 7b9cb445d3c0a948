// A drawing that grows under a hand: somebody draws line by line, and each finished line is felt.
// Threads: values and pure functions.
#pragma once

#include "config/types/tactile_map.h"
#include "config/types/vec2.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace touchline {

/// One stroke of the pen.
struct DrawnLine {
    int number = 1;                 // 1, 2 ... as drawn; no other line has it, nor ever had it
    std::vector<Outline> outlines;  // several if the stroke crosses itself; never empty
};

using DrawnLinePtr = std::shared_ptr<const DrawnLine>;

/// Why a drawing stays as it was.
enum class DrawingRefusal : std::uint8_t {
    too_short,     // under 4 mm: no finger could follow it
    too_long,      // over most_stroke_m, most_way_m or most_stroke_points
    scribbled,     // crosses itself or lies over itself too often, as touch_lines() judges it
    full,          // most_lines, or most_drawn_m in all
    nothing_near,  // no line to be erased there
    nothing_to_undo,
    nothing_to_redo,
};

// More than a hand takes in, and little enough that each line is felt at once.
inline constexpr std::size_t most_lines = 60;
inline constexpr std::size_t most_stroke_points = 20'000;
inline constexpr double most_stroke_m = 1.5;
inline constexpr double most_way_m = 2.0;  // as the pen went: a line is shorter than its tremble
inline constexpr double most_drawn_m = 4.0;

/// The steps back that are kept.
inline constexpr std::size_t most_undos = 100;

/// A value: every change returns the next one, which shares the lines that stay.
class Drawing {
  public:
    template <class T>
    using Or = tl::expected<T, DrawingRefusal>;

    /// `id`: TactileMap::drawing of all its maps; not 0.
    explicit Drawing(std::uint64_t id, const Area& area = {}) : id_(id), area_(area) {}

    /// Adds a finished stroke, as touch_lines(). O(points x points drawn): of the 155 strokes of
    /// scribble_test, the worst that was taken took 3 ms, the worst that was refused 27 ms.
    [[nodiscard]] Or<Drawing> with_stroke(std::span<const Position> stroke_W) const;

    /// Erases the line that comes nearest to the place, if that is `reach_m` or less. O(points).
    [[nodiscard]] Or<Drawing> without_line_near(Position place_W, double reach_m) const;

    /// Takes the last change back; as often as there were changes, most_undos at most.
    [[nodiscard]] Or<Drawing> undone() const;

    /// Does again what was undone last; not after a change.
    [[nodiscard]] Or<Drawing> redone() const;

    /// They are in the order of their numbers.
    [[nodiscard]] const std::vector<DrawnLinePtr>& lines() const { return steps_[now_]; }

    [[nodiscard]] bool can_undo() const { return now_ > 0; }

    [[nodiscard]] bool can_redo() const { return now_ + 1 < steps_.size(); }

    [[nodiscard]] std::uint64_t id() const { return id_; }

    [[nodiscard]] const Area& area() const { return area_; }

  private:
    using Lines = std::vector<DrawnLinePtr>;

    [[nodiscard]] Drawing with(Lines lines) const;

    std::uint64_t id_;
    Area area_;
    std::vector<Lines> steps_{Lines{}};  // never empty; the oldest first
    std::size_t now_ = 0;                // the step that holds
    int last_number_ = 0;                // also of lines that are gone
};

/// A line that one of two drawings has and the other has not.
struct LineChange {
    int number = 1;
    bool is_there = true;  // in the second
};

/// The first such line; nothing if both have the same. O(lines).
[[nodiscard]] std::optional<LineChange> change_between(const Drawing& before, const Drawing& after);

/// The drawing as felt. Every outline of a line has its name, ids are "line-3", "line-3-2". The
/// version stays 0: whoever uses the map numbers it. O(points).
[[nodiscard]] TactileMap map_of(const Drawing& drawing, std::string title,
                                const std::function<std::string(int number)>& name_of);

}  // namespace touchline
