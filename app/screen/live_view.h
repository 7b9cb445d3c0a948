// The staff's live view: the picture with outlines, boxes, hand and forces, the status panel, and a
// chart of how late the loop is. Paints still layers only when they change.
// Threads: the one that holds the OpenGL context.
#pragma once

#include "app/screen/image_layer.h"
#include "app/screen/shown_scene.h"
#include "app/screen/stroke_renderer.h"
#include "app/screen/timing_chart.h"
#include "app/session/status.h"
#include "config/types/hand_state.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace touchline {

/// The renderers of images and strokes, shared by everything in the window.
struct Renderers {
    ImageRenderer images;
    StrokeRenderer strokes;
};

struct FrameContent {
    Status status;
    bool shows_boxes = false;
    HandState hand;
    ShownScene shown;
    std::optional<LatenessBars> timing = {};  // shown below the panel, if any
    Language language = {};
};

class LiveView {
  public:
    /// `cap_px`: height of a capital letter.
    explicit LiveView(double cap_px) : cap_px_(cap_px) {}

    /// Draws one frame on a screen of this size (px). The panel's words change at most five times a
    /// second, so that they can be read and nothing flickers.
    void draw(const Renderers& renderers, const FrameContent& content, int width_px, int height_px,
              std::int64_t now_ns);

    /// The place on the screen of the picture drawn last.
    [[nodiscard]] const View& view() const { return view_; }

  private:
    void lay_out_again(int width_px, int height_px);
    void update_picture(const ShownScene& shown);
    void update_panel(const FrameContent& content, std::int64_t now_ns);
    /// Returns the height left above it.
    double paint_timing_below(cairo_t* cr, const Rect& rect, const FrameContent& content) const;
    void update_overlay(const FrameContent& content);
    void update_outlines(const Scene& scene, double level);
    void update_boxes(const FrameContent& content);
    void update_hand(const HandState& hand);
    void upload(ImageLayer& layer, const Canvas& canvas, const Rect& rect) const;

    [[nodiscard]] double unit_px() const { return cap_px_ / 14.0; }

    double cap_px_;
    ImageLayer picture_, panel_, overlay_;
    StrokeBuffer boxes_, outlines_, hand_;
    Strokes strokes_;

    int width_px_ = 0;
    int height_px_ = 0;
    ScreenLayout layout_;
    View view_;
    bool is_stale_ = true;  // the size has changed: every layer must be painted again

    // The contents of the layers.
    std::shared_ptr<const Canvas> painted_picture_;
    Status painted_status_;
    std::optional<LatenessBars> painted_timing_;
    std::int64_t panel_ns_ = 0;
    std::string painted_message_;
    std::uint64_t outlined_version_ = 0;  // the map's version
    double outlined_level_ = -1.0;
};

}  // namespace touchline
