// The first frame of a GIF.
#include "app/decode/formats.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>

#include <gif_lib.h>

namespace touchline::decode {
namespace {

struct Source {
    Bytes left;
};

int read_some(GifFileType* file, GifByteType* to, int wanted) {
    auto& source = *static_cast<Source*>(file->UserData);
    const std::size_t count = std::min(static_cast<std::size_t>(wanted), source.left.size());
    if (count > 0) std::memcpy(to, source.left.data(), count);
    source.left = source.left.subspan(count);
    return static_cast<int>(count);
}

struct Close {
    void operator()(GifFileType* file) const { (void)DGifCloseFile(file, nullptr); }
};

tl::unexpected<Error> broken(int error) {
    const char* const words = GifErrorString(error);
    return damaged("GIF", words != nullptr ? words : "");
}

/// What is told before a frame: the index that is not drawn.
std::optional<int> transparent_index(const GifByteType* block) {
    GraphicsControlBlock control{};
    if (block == nullptr || block[0] < 4 ||
        DGifExtensionToGCB(block[0], block + 1, &control) == GIF_ERROR ||
        control.TransparentColor == NO_TRANSPARENT_COLOR)
        return std::nullopt;
    return control.TransparentColor;
}

/// Rows in the order that the file has them.
std::vector<int> row_order(int height, bool is_interlaced) {
    struct Pass {
        int first;
        int step;
    };

    constexpr std::array<Pass, 4> interlaced{{{0, 8}, {4, 8}, {2, 4}, {1, 2}}};
    constexpr std::array<Pass, 1> plain{{{0, 1}}};
    std::vector<int> rows;
    const auto add = [&](const Pass& pass) {
        for (int y = pass.first; y < height; y += pass.step) rows.push_back(y);
    };
    if (is_interlaced) {
        for (const Pass& pass : interlaced) add(pass);
    } else {
        for (const Pass& pass : plain) add(pass);
    }
    return rows;
}

/// Draws the part of a row that lies in the picture.
void draw_row(const std::vector<GifPixelType>& row, int y, const GifImageDesc& frame,
              const ColorMapObject& colours, std::optional<int> transparent, Picture& picture) {
    const int top = frame.Top + y;
    if (top >= picture.height) return;
    for (int x = 0; x < frame.Width && frame.Left + x < picture.width; ++x) {
        const int index = row[static_cast<std::size_t>(x)];
        if (index == transparent || index >= colours.ColorCount) continue;
        const GifColorType& colour = colours.Colors[index];
        const std::size_t at =
            4 * (static_cast<std::size_t>(top) * static_cast<std::size_t>(picture.width) +
                 static_cast<std::size_t>(frame.Left + x));
        picture.bgr[at] = colour.Blue;
        picture.bgr[at + 1] = colour.Green;
        picture.bgr[at + 2] = colour.Red;
        picture.bgr[at + 3] = 255;
    }
}

Result<Picture> read_frame(GifFileType& file, std::optional<int> transparent) {
    if (DGifGetImageDesc(&file) == GIF_ERROR) return broken(file.Error);
    const GifImageDesc& frame = file.Image;
    if (frame.Left < 0 || frame.Top < 0 || frame.Width < 1 || frame.Height < 1)
        return damaged("GIF", "its first frame has no pixels");
    const int width = file.SWidth > 0 ? file.SWidth : frame.Left + frame.Width;
    const int height = file.SHeight > 0 ? file.SHeight : frame.Top + frame.Height;
    for (const auto& [w, h] : {std::pair{width, height}, std::pair{frame.Width, frame.Height}}) {
        const auto fits =
            check_size("GIF", static_cast<std::uint64_t>(w), static_cast<std::uint64_t>(h));
        if (!fits) return tl::unexpected(fits.error());
    }
    const ColorMapObject* colours = frame.ColorMap != nullptr ? frame.ColorMap : file.SColorMap;
    if (colours == nullptr) return damaged("GIF", "it has no colours");
    Picture picture{width, height, {}};
    picture.bgr.assign(
        std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    std::vector<GifPixelType> row(static_cast<std::size_t>(frame.Width));
    for (const int y : row_order(frame.Height, frame.Interlace)) {
        if (DGifGetLine(&file, row.data(), frame.Width) == GIF_ERROR) return broken(file.Error);
        draw_row(row, y, frame, *colours, transparent, picture);
    }
    compose(picture.bgr);
    return picture;
}

}  // namespace

Result<Picture> read_gif(Bytes bytes) {
    Source source{bytes};
    int error = 0;
    const std::unique_ptr<GifFileType, Close> file(DGifOpen(&source, read_some, &error));
    if (file == nullptr) return broken(error);
    std::optional<int> transparent;
    for (;;) {
        GifRecordType record = UNDEFINED_RECORD_TYPE;
        if (DGifGetRecordType(file.get(), &record) == GIF_ERROR) return broken(file->Error);
        if (record == IMAGE_DESC_RECORD_TYPE) return read_frame(*file, transparent);
        if (record == TERMINATE_RECORD_TYPE) return damaged("GIF", "it has no frame");
        int code = 0;
        GifByteType* block = nullptr;
        if (DGifGetExtension(file.get(), &code, &block) == GIF_ERROR) return broken(file->Error);
        if (code == GRAPHICS_EXT_FUNC_CODE) transparent = transparent_index(block);
        while (block != nullptr)
            if (DGifGetExtensionNext(file.get(), &block) == GIF_ERROR) return broken(file->Error);
    }
}

}  // namespace touchline::decode
