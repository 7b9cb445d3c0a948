// The first picture of a GIF: what is shown before the first pause. Some files put it together from
// several frames without a pause, because each frame may have its own 256 colours.
#include "app/documents/decode/readers.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include <gif_lib.h>

namespace touchline::decode {
namespace {

int read_some(GifFileType* file, GifByteType* to, int wanted) {
    auto& left = *static_cast<Bytes*>(file->UserData);
    const std::size_t count = std::min(static_cast<std::size_t>(wanted), left.size());
    if (count > 0) std::memcpy(to, left.data(), count);
    left = left.subspan(count);
    return static_cast<int>(count);
}

struct CloseGif {
    void operator()(GifFileType* file) const { (void)DGifCloseFile(file, nullptr); }
};

using File = std::unique_ptr<GifFileType, CloseGif>;

tl::unexpected<Error> broken(int error) {
    const char* const words = GifErrorString(error);
    return damaged("GIF", words != nullptr ? words : "");
}

struct Control {
    std::optional<int> transparent;  // the index that is not drawn
    bool has_pause = false;          // a pause follows it
    int disposal = DISPOSAL_UNSPECIFIED;
};

Control control_of(const GifByteType* block) {
    GraphicsControlBlock told{};
    if (block == nullptr || block[0] < 4 ||
        DGifExtensionToGCB(block[0], block + 1, &told) == GIF_ERROR)
        return {};
    Control control;
    if (told.TransparentColor != NO_TRANSPARENT_COLOR) control.transparent = told.TransparentColor;
    control.has_pause = told.DelayTime > 0 || told.UserInputFlag;
    control.disposal = told.DisposalMode;
    return control;
}

bool repeats(int code, const GifByteType* block) {
    constexpr std::array<std::string_view, 2> programs{"NETSCAPE2.0", "ANIMEXTS1.0"};
    if (code != APPLICATION_EXT_FUNC_CODE || block == nullptr || block[0] < 11) return false;
    const std::string_view name(reinterpret_cast<const char*>(block + 1), 11);
    return std::ranges::find(programs, name) != programs.end();
}

class Frames {
  public:
    explicit Frames(GifFileType& file) : file_(file) {}

    /// Goes to the next frame's pixels. False at the end of the file, marked or not, or after an
    /// error().
    bool next() {
        control_ = {};
        for (;;) {
            GifRecordType record = UNDEFINED_RECORD_TYPE;
            if (DGifGetRecordType(&file_, &record) == GIF_ERROR) return false;
            if (record == TERMINATE_RECORD_TYPE) return false;
            if (record == IMAGE_DESC_RECORD_TYPE) {
                if (DGifGetImageDesc(&file_) != GIF_ERROR) return true;
                error_ = file_.Error;
                return false;
            }
            if (!read_extension()) return false;
        }
    }

    /// Skips the pixels of this frame without unpacking them.
    bool skip() {
        int code_size = 0;
        GifByteType* block = nullptr;
        if (DGifGetCode(&file_, &code_size, &block) == GIF_ERROR) return fail();
        while (block != nullptr)
            if (DGifGetCodeNext(&file_, &block) == GIF_ERROR) return fail();
        return true;
    }

    bool fail() {
        error_ = file_.Error;
        return false;
    }

    [[nodiscard]] const Control& control() const { return control_; }

    [[nodiscard]] bool is_repeated() const { return is_repeated_; }

    [[nodiscard]] std::optional<int> error() const { return error_; }

  private:
    bool read_extension() {
        int code = 0;
        GifByteType* block = nullptr;
        if (DGifGetExtension(&file_, &code, &block) == GIF_ERROR) return fail();
        if (code == GRAPHICS_EXT_FUNC_CODE) control_ = control_of(block);
        is_repeated_ = is_repeated_ || repeats(code, block);
        while (block != nullptr)
            if (DGifGetExtensionNext(&file_, &block) == GIF_ERROR) return fail();
        return true;
    }

    GifFileType& file_;
    Control control_;
    bool is_repeated_ = false;
    std::optional<int> error_;
};

struct Plan {
    int frames = 0;  // that make the first picture
    int width = 0;
    int height = 0;
};

/// True if the frame hides everything before it.
bool hides_all(const GifImageDesc& frame, const Control& control, const Plan& plan) {
    return frame.Left == 0 && frame.Top == 0 && frame.Width >= plan.width &&
           frame.Height >= plan.height && !control.transparent;
}

/// Plans the frames up to the first pause, or up to a frame that is a picture by itself. Without a
/// pause it takes all frames, unless they repeat: then each is a picture.
Result<Plan> plan_of(GifFileType& file) {
    Frames frames(file);
    Plan plan{0, file.SWidth, file.SHeight};
    bool has_pause = false;
    while (!has_pause && frames.next()) {
        const GifImageDesc& frame = file.Image;
        if (plan.frames > 0 && hides_all(frame, frames.control(), plan)) return plan;
        if (frame.Left < 0 || frame.Top < 0 || frame.Width < 1 || frame.Height < 1)
            return damaged("GIF", "its first frame has no pixels");
        // Some programs leave the screen empty, or smaller than its contents.
        if (plan.frames == 0 || file.SWidth == 0 || file.SHeight == 0) {
            plan.width = std::max(plan.width, frame.Left + frame.Width);
            plan.height = std::max(plan.height, frame.Top + frame.Height);
        }
        ++plan.frames;
        has_pause = frames.control().has_pause;
        if (!has_pause && !frames.skip()) break;
    }
    if (plan.frames == 0) {
        if (frames.error()) return broken(*frames.error());
        return damaged("GIF", "it has no frame");
    }
    if (!has_pause && frames.is_repeated()) plan.frames = 1;
    return plan;
}

/// The rows in the file's order.
std::vector<int> row_order(int height, bool is_interlaced) {
    struct RowPass {
        int first;
        int step;
    };

    constexpr std::array<RowPass, 4> interlaced_rows{{{0, 8}, {4, 8}, {2, 4}, {1, 2}}};
    constexpr std::array<RowPass, 1> plain_rows{{{0, 1}}};
    const std::span<const RowPass> passes =
        is_interlaced ? std::span<const RowPass>(interlaced_rows) : plain_rows;
    std::vector<int> rows;
    for (const RowPass& pass : passes)
        for (int y = pass.first; y < height; y += pass.step) rows.push_back(y);
    return rows;
}

/// Blue, green, red, alpha; it is clear at first.
class Canvas {
  public:
    explicit Canvas(const Plan& plan)
        : width_(plan.width),
          height_(plan.height),
          bgra_(std::size_t{4} * static_cast<std::size_t>(width_) *
                static_cast<std::size_t>(height_)) {}

    /// Draws the part of a row that lies in the picture.
    void draw_row(const std::vector<GifPixelType>& row, int y, const GifImageDesc& frame,
                  const ColorMapObject& colours, std::optional<int> transparent) {
        const int top = frame.Top + y;
        if (top >= height_) return;
        for (int x = 0; x < frame.Width && frame.Left + x < width_; ++x) {
            const int index = row[static_cast<std::size_t>(x)];
            if (index == transparent || index >= colours.ColorCount) continue;
            const GifColorType& colour = colours.Colors[index];
            const std::array<std::uint8_t, 4> pixel{colour.Blue, colour.Green, colour.Red, 255};
            std::ranges::copy(pixel, at(frame.Left + x, top));
        }
    }

    void clear(const GifImageDesc& frame) {
        const int right = std::min(frame.Left + frame.Width, width_);
        for (int y = frame.Top; y < std::min(frame.Top + frame.Height, height_); ++y)
            if (frame.Left < right) std::fill(at(frame.Left, y), at(right, y), std::uint8_t{0});
    }

    [[nodiscard]] Picture picture() const {
        Shrinking shrinking(static_cast<std::size_t>(width_), static_cast<std::size_t>(height_), 4);
        const std::size_t row_bytes = std::size_t{4} * static_cast<std::size_t>(width_);
        for (std::size_t y = 0; y < static_cast<std::size_t>(height_); ++y)
            shrinking.add_row(y, std::span(bgra_).subspan(y * row_bytes, row_bytes));
        return std::move(shrinking).picture();
    }

  private:
    std::vector<std::uint8_t>::iterator at(int x, int y) {
        return bgra_.begin() + 4 * (std::ptrdiff_t{y} * width_ + x);
    }

    int width_;
    int height_;
    std::vector<std::uint8_t> bgra_;
};

/// Draws a frame that the next one removes only if it is the last.
Result<void> draw_frame(GifFileType& file, const Control& control, bool is_last, Canvas& canvas) {
    const GifImageDesc& frame = file.Image;
    const ColorMapObject* colours = frame.ColorMap != nullptr ? frame.ColorMap : file.SColorMap;
    if (colours == nullptr) return damaged("GIF", "it has no colours");
    const bool is_drawn = is_last || control.disposal != DISPOSE_PREVIOUS;
    std::vector<GifPixelType> row(static_cast<std::size_t>(frame.Width));
    for (const int y : row_order(frame.Height, frame.Interlace)) {
        if (DGifGetLine(&file, row.data(), frame.Width) == GIF_ERROR) return broken(file.Error);
        if (is_drawn) canvas.draw_row(row, y, frame, *colours, control.transparent);
    }
    if (!is_last && control.disposal == DISPOSE_BACKGROUND) canvas.clear(frame);
    return {};
}

/// Moves the beginning of `left` on while the file is read.
Result<File> open(Bytes& left) {
    int error = 0;
    File file(DGifOpen(&left, read_some, &error));
    if (file == nullptr) return broken(error);
    return file;
}

/// The shape of its pixels, by the specification of 1989; 0: unknown.
Resolution resolution_of(const GifFileType& file) {
    if (file.AspectByte == 0) return {};
    return {64.0, 15.0 + file.AspectByte};
}

}  // namespace

Result<Stored> read_gif(Bytes bytes) {
    Bytes looked_at = bytes;
    const auto first = open(looked_at);
    if (!first) return tl::unexpected(first.error());
    const auto plan = plan_of(**first);
    if (!plan) return tl::unexpected(plan.error());
    if (auto fits = check_file_size("GIF", plan->width, plan->height); !fits)
        return tl::unexpected(fits.error());
    Bytes left = bytes;
    const auto file = open(left);
    if (!file) return tl::unexpected(file.error());
    Frames frames(**file);
    Canvas canvas(*plan);
    for (int i = 0; i < plan->frames; ++i) {
        if (!frames.next()) return cut_short("GIF");
        const bool is_last = i + 1 == plan->frames;
        const auto drawn = draw_frame(**file, frames.control(), is_last, canvas);
        if (!drawn) return tl::unexpected(drawn.error());
    }
    return Stored{canvas.picture(), resolution_of(**file)};
}

}  // namespace touchline::decode
