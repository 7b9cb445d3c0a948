// The still layers of a screen, painted into memory when what they show changes, and never so often
// that anything flashes. No window and no OpenGL, so that tests measure the pixels themselves.
// Threads: one at a time.
#pragma once

#include "app/screen/captions.h"
#include "app/screen/change_pace.h"
#include "app/screen/screen_content.h"
#include "app/screen/sheet.h"

#include <cstdint>
#include <string>

namespace touchline {

/// Opaque pixels of a part of the screen.
struct StillLayer {
    Rect rect;
    Canvas canvas{1, 1};
    std::uint64_t version = 0;  // goes up with each painting
};

class ScreenLayers {
  public:
    /// `normal_cap_px`: cap height of TextSize::normal on this screen.
    explicit ScreenLayers(double normal_cap_px) : normal_cap_px_(normal_cap_px) {}

    /// Paints what changed. Screen and captions change twice a second at most, what comes in
    /// between is left out; the preview ten times; a curtain falls at once. `now_ns` never goes
    /// back; sizes in px, >= 1.
    void update(const ScreenContent& content, int width_px, int height_px, std::int64_t now_ns);

    [[nodiscard]] const StillLayer& sheet() const { return sheet_; }

    [[nodiscard]] const StillLayer& captions() const { return captions_; }

    /// Of a screen without: an empty rectangle.
    [[nodiscard]] const StillLayer& picture() const { return picture_; }

    /// How the picture lies on the screen, for the hand; of the whole screen where there is none.
    [[nodiscard]] const View& view() const { return view_; }

    /// What the layers show now: the scene, the colours.
    [[nodiscard]] const ScreenContent& shown() const { return shown_; }

    /// Outlines and hand are to be drawn over the picture.
    [[nodiscard]] bool has_marks() const;

  private:
    void take_sign(const std::string& sign, std::int64_t now_ns);
    [[nodiscard]] bool is_screen_due(const ScreenContent& content, std::int64_t now_ns) const;
    void show_screen(const ScreenContent& content, std::int64_t now_ns);
    void show_captions(const ScreenContent& content, std::int64_t now_ns);
    void update_screen(const ScreenContent& content, std::int64_t now_ns);
    void update_captions(const ScreenContent& content, std::int64_t now_ns);
    void update_preview(const ScreenContent& content, std::int64_t now_ns);
    void paint_sheet_layer();
    void paint_caption_layer();
    void paint_picture_layer();
    void paint_black();
    [[nodiscard]] SheetPages pages_now(const SpokenScreen& screen, std::int64_t now_ns) const;
    [[nodiscard]] std::size_t caption_page_now(std::int64_t now_ns) const;

    double normal_cap_px_;
    int width_px_ = 0;
    int height_px_ = 0;
    TextSizes sizes_;
    Arrangement arrangement_;
    View view_;
    StillLayer sheet_, captions_, picture_;

    ScreenContent shown_;
    SheetLayout sheet_layout_;
    SheetPages pages_;
    std::int64_t screen_ns_ = 0;  // when it came
    std::int64_t focus_ns_ = 0;   // when it moved
    ChangePace screen_pace_;

    CaptionLayout caption_layout_;
    std::size_t caption_page_ = 0;
    std::int64_t caption_ns_ = 0;
    std::string sign_;  // wanted
    std::int64_t sign_ns_ = 0;
    ChangePace caption_pace_;
    std::int64_t preview_ns_ = 0;
};

}  // namespace touchline
