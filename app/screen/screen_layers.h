// The still layers of a screen, painted into memory when their content changes, and never so often
// that anything flashes. Uses no window and no OpenGL, so that tests measure the pixels themselves.
// Threads: one at a time.
#pragma once

#include "app/screen/captions.h"
#include "app/screen/header.h"
#include "app/screen/pace.h"
#include "app/screen/screen_content.h"
#include "app/screen/sheet.h"

#include <array>
#include <cstdint>
#include <string>

namespace touchline {

/// Opaque pixels of a part of the screen.
struct StillLayer {
    Rect rect;
    Canvas canvas{1, 1};
    std::uint64_t version = 0;  // grows with each painting
};

class ScreenLayers {
  public:
    /// `normal_cap_px`: cap height of TextSize::normal on this screen.
    explicit ScreenLayers(double normal_cap_px) : normal_cap_px_(normal_cap_px) {}

    /// Paints what changed. Screen and captions change at most twice a second, and changes in
    /// between are left out; the preview changes at most ten times a second, the live view five
    /// times; a curtain falls at once. `now_ns` never goes back; sizes in px, >= 1.
    void update(const ScreenContent& content, int width_px, int height_px, std::int64_t now_ns);

    [[nodiscard]] const StillLayer& header() const { return header_; }

    [[nodiscard]] const StillLayer& sheet() const { return sheet_; }

    [[nodiscard]] const StillLayer& captions() const { return captions_; }

    /// An empty rectangle on a screen without a picture.
    [[nodiscard]] const StillLayer& picture() const { return picture_; }

    /// An empty rectangle without the live view.
    [[nodiscard]] const StillLayer& panel() const { return panel_; }

    /// The layers that cover the screen, without the picture.
    [[nodiscard]] std::array<const StillLayer*, 4> words() const {
        return {&header_, &sheet_, &captions_, &panel_};
    }

    /// The picture's place on the screen, for drawing the hand; that of the whole screen if there
    /// is no picture.
    [[nodiscard]] const View& view() const { return view_; }

    /// What the layers show now: scene, colours and all else.
    [[nodiscard]] const ScreenContent& shown() const { return shown_; }

    /// True if outlines and hand are to be drawn over the picture.
    [[nodiscard]] bool has_marks() const;

  private:
    void take_sign(const std::string& sign, std::int64_t now_ns);
    [[nodiscard]] bool is_screen_due(const ScreenContent& content, std::int64_t now_ns) const;
    void show_screen(const ScreenContent& content, std::int64_t now_ns);
    void show_captions(const ScreenContent& content, std::int64_t now_ns);
    void update_screen(const ScreenContent& content, std::int64_t now_ns);
    void update_captions(const ScreenContent& content, std::int64_t now_ns);
    void update_preview(const ScreenContent& content, std::int64_t now_ns);
    void update_panel(const ScreenContent& content, std::int64_t now_ns);
    void paint_pages();
    void paint_caption_layer();
    void paint_picture_layer();
    void paint_panel_layer();
    void paint_curtain();
    void turn_pages(std::int64_t now_ns);
    [[nodiscard]] SheetPages pages_now(const SpokenScreen& screen, std::int64_t now_ns) const;
    [[nodiscard]] std::size_t title_page_now(std::int64_t now_ns) const;
    [[nodiscard]] std::size_t caption_page_now(std::int64_t now_ns) const;

    double normal_cap_px_;
    int width_px_ = 0;
    int height_px_ = 0;
    TextSizes sizes_;
    Arrangement arrangement_;
    View view_;
    StillLayer header_, sheet_, captions_, picture_, panel_;

    ScreenContent shown_;
    HeaderLayout header_layout_;
    std::size_t title_page_ = 0;
    SheetLayout sheet_layout_;
    SheetPages pages_;
    std::int64_t screen_ns_ = 0;  // when the screen came
    std::int64_t focus_ns_ = 0;   // when the focus moved
    ChangePace screen_pace_;

    CaptionLayout caption_layout_;
    std::size_t caption_page_ = 0;
    std::int64_t caption_ns_ = 0;
    std::string sign_;  // the wanted sign
    std::int64_t sign_ns_ = 0;
    ChangePace caption_pace_;
    std::int64_t preview_ns_ = 0;
    std::int64_t panel_ns_ = 0;
};

}  // namespace touchline
