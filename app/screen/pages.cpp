#include "app/screen/pages.h"

#include <algorithm>
#include <cmath>

namespace touchline {

namespace {

/// Fills one page after the other.
class PageFiller {
  public:
    explicit PageFiller(const PageMetrics& metrics) : metrics_(metrics) {}

    void add(const RowBlock& block) {
        if (block.rows.empty()) return;
        const double gap_px = is_empty() ? 0.0 : metrics_.gap_px;
        const std::size_t together = block.is_running ? 1 : block.rows.size();
        if (!fits(gap_px, together) && !is_empty()) turn();
        if (!is_empty()) top_px_ += gap_px;
        for (std::size_t first = 0; first < block.rows.size();) {
            if (first > 0) turn();
            const std::size_t count = std::min(block.rows.size() - first, rows_left());
            place(block, first, count);
            first += count;
        }
    }

    void turn() {
        pages_.emplace_back();
        top_px_ = 0.0;
    }

    [[nodiscard]] std::vector<SheetPage> pages() && { return std::move(pages_); }

  private:
    [[nodiscard]] bool is_empty() const { return pages_.back().phrases.empty(); }

    [[nodiscard]] double height_px(std::size_t rows) const {
        return 2.0 * metrics_.inset_px + metrics_.row_px * static_cast<double>(rows);
    }

    [[nodiscard]] bool fits(double gap_px, std::size_t rows) const {
        return top_px_ + gap_px + height_px(rows) <= metrics_.height_px;
    }

    /// At least one, or the pages would never end.
    [[nodiscard]] std::size_t rows_left() const {
        const double room_px = metrics_.height_px - top_px_ - 2.0 * metrics_.inset_px;
        constexpr double rounding = 1e-6;  // a page made for n rows holds n
        return static_cast<std::size_t>(
            std::max(std::floor(room_px / metrics_.row_px + rounding), 1.0));
    }

    void place(const RowBlock& block, std::size_t first, std::size_t count) {
        const double height = height_px(count);
        if (block.item) pages_.back().items.push_back({*block.item, top_px_, height});
        double y_px = top_px_ + metrics_.inset_px;
        for (std::size_t i = first; i < first + count; ++i) {
            for (const Phrase& phrase : block.rows[i])
                pages_.back().phrases.push_back({{metrics_.inset_px + phrase.x_px, y_px}, phrase});
            y_px += metrics_.row_px;
        }
        top_px_ += height;
    }

    PageMetrics metrics_;
    std::vector<SheetPage> pages_ = std::vector<SheetPage>(1);
    double top_px_ = 0.0;  // where the next block begins
};

bool holds(const SheetPage& page, std::size_t item) {
    return std::any_of(page.items.begin(), page.items.end(),
                       [item](const PlacedItem& placed) { return placed.item == item; });
}

/// Begins a page with the block `turn_before`, whatever room there is.
std::vector<SheetPage> filled_pages(std::span<const RowBlock> blocks, const PageMetrics& metrics,
                                    std::size_t turn_before) {
    PageFiller filler(metrics);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (i == turn_before) filler.turn();
        filler.add(blocks[i]);
    }
    return std::move(filler).pages();
}

/// One item alone, most often Back, looks like another list. A page that has few anyway keeps them.
bool has_lonely_end(const std::vector<SheetPage>& pages) {
    constexpr std::size_t few = 2;
    return pages.size() > 1 && pages.back().items.size() == 1 &&
           pages[pages.size() - 2].items.size() > few;
}

}  // namespace

double mark_room_px(PhraseMark mark, double cap_px) {
    return mark == PhraseMark::none ? 0.0 : 0.6 * cap_px;
}

std::vector<SheetPage> pages_of(std::span<const RowBlock> blocks, const PageMetrics& metrics) {
    std::vector<SheetPage> pages = filled_pages(blocks, metrics, blocks.size());
    if (!has_lonely_end(pages)) return pages;
    std::vector<SheetPage> evener = filled_pages(blocks, metrics, blocks.size() - 2);
    return evener.size() > pages.size() ? pages : evener;
}

std::int64_t reading_time_ns(const SheetPage& page) {
    constexpr std::int64_t least_ns = 2'000'000'000;
    constexpr std::int64_t per_byte_ns = 90'000'000;  // some 110 words a minute
    std::size_t bytes = 0;
    for (const PlacedPhrase& placed : page.phrases) bytes += placed.phrase.text.size();
    return least_ns + per_byte_ns * static_cast<std::int64_t>(bytes);
}

PageRange pages_with(std::span<const SheetPage> pages, std::size_t item) {
    const auto holds_it = [item](const SheetPage& page) { return holds(page, item); };
    const auto first = std::find_if(pages.begin(), pages.end(), holds_it);
    if (first == pages.end()) return {};
    const auto last = std::find_if_not(first, pages.end(), holds_it);
    return {static_cast<std::size_t>(first - pages.begin()),
            static_cast<std::size_t>(last - first)};
}

std::size_t page_at(std::span<const SheetPage> pages, PageRange range, std::int64_t elapsed_ns) {
    const auto some = pages.subspan(range.first, range.count);
    std::int64_t round_ns = 0;
    for (const SheetPage& page : some) round_ns += reading_time_ns(page);
    std::int64_t left_ns = elapsed_ns % round_ns;
    for (std::size_t i = 0; i + 1 < some.size(); ++i) {
        left_ns -= reading_time_ns(some[i]);
        if (left_ns < 0) return range.first + i;
    }
    return range.first + some.size() - 1;
}

}  // namespace touchline
