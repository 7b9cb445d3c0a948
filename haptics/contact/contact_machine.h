// The paper's three-state contact machine (section 4) for a disc-shaped proxy.
// Threads: one, the servo's. No allocation, lock, clock or log in step().
#pragma once

#include "config/types/hand_state.h"
#include "config/types/vec2.h"
#include "haptics/collision/scene.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace touchline {

struct ContactSettings {
    Mode mode = Mode::wall;
    double stiffness_N_per_m = 500.0;  // K, 0 < K <= 20000
    double friction = 0.0;             // mu of the Coulomb cone, 0 ... 1
    double radius_m = 0.0;             // of the proxy, 0 ... 0.02
    double capture_m = 0.003;          // w, half width of groove and ridge, > 0
};

enum class Side : std::int8_t { right = -1, left = 1 };

/// Where the proxy touches the curve as rendered: centre = point(segment, parameter) + offset * normal.
struct Contact {
    SegmentRef segment;
    double parameter = 0.0;  // on the segment, 0 ... 1
    Side side = Side::left;  // of the outline, looking along it
    Direction normal;        // from the curve to the proxy
    double offset_m = 0.0;   // distance kept: the proxy radius, at least the contact skin
};

/// State 0: no contact counts. State 1: contacts[0]. State 2: contacts[0] and, at a concave vertex or
/// between two outlines, contacts[1]; at a round convex vertex or line end contacts[0] alone, its normal
/// between those of the two edges.
struct ProxyState {
    ContactState state = ContactState::free;
    Position centre;
    std::array<Contact, 2> contacts{};
    int contact_count = 0;
};

/// What one step did. The path is the proxy's way in this step, for tests and drawings.
struct ContactReport {
    Force force;             // K (proxy - handle) in wall mode: the contact force itself, no limits
    Position p_WP;           // proxy
    ContactState state = ContactState::free;
    double level = 0.0;      // rendered level of the contact's piece, else the wanted one
    int outline = -1;        // touched, -1 when free
    double parameter = 0.0;  // on the outline, in level-0 segments
    Side side = Side::left;
    std::array<ContactState, 16> transitions{};  // states passed through in order, first the one before
    int transition_count = 0;                    // 1: no change; stays 16 when there were more
    double carried_m = 0.0;  // motion left over for the next step
    int boxes = 0;           // opened
    double clear = 1.0;      // smallest fraction of a motion proven free
};

class ContactMachine {
  public:
    /// Starts free at the handle; exactly on a line it starts on the line's left. `scene` must outlive
    /// the machine's use of it.
    void reset(const Scene& scene, Position handle, double level);

    /// Moves the proxy towards the handle. At most 256 walks and 8 tree queries; the rest is carried.
    /// |handle - proxy| never grows. A handle that is not finite gives zero force and moves nothing.
    /// While the proxy is free and outside all boxes of the coarser of both levels, `level` becomes the
    /// rendered one; else the rendered level stays until it is.
    [[nodiscard]] ContactReport step(Position handle, double level, const ContactSettings& settings,
                                     const Budget& budget);

    [[nodiscard]] const ProxyState& proxy() const { return proxy_; }

    /// Way points of the last step, the first where it started. At most 258; for tests and drawings.
    [[nodiscard]] std::span<const Position> path() const;

  private:
    const Scene* scene_ = nullptr;
    ProxyState proxy_;
};

}  // namespace touchline
