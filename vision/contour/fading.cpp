#include "vision/contour/region_map.h"

#include <algorithm>
#include <map>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr float flat_step = 0.3F;     // share of the two colours' difference: less is no step
constexpr float least_beside = 0.3F;  // share of the change at the border, on either side of it
constexpr float both_beside = 1.0F;   // on both together
constexpr double true_colour_levels = 60.0;  // grey levels off the region's colour
constexpr double plateau_spread = 4.0;       // grey levels off the region's colour, for a plateau
constexpr double mostly_plateau = 0.6;       // of its pixels; in a band of a gradient it is half
constexpr double mostly_soft = 0.75;         // of a border
constexpr double widest_blur_px = 8.0;  // a wider band between two plateaus is not a blurred step
constexpr std::ptrdiff_t most_regions = 1500;  // more are grain: nothing but specks
constexpr int fading_reach_px = 4;
constexpr int votes_within_px = 9;
constexpr int least_stretch_px = 30;

/// Two neighbouring pixels of two regions.
struct Pair {
    cv::Point at;
    cv::Point along;  // to the other one
    bool is_soft = false;
    bool is_step = false;  // at least a blurred one
};

/// Pairs along the border of two regions.
struct Contact {
    int pairs = 0;
    int soft = 0;
    int steps = 0;

    [[nodiscard]] bool is_soft() const { return soft >= mostly_soft * pairs; }

    [[nodiscard]] bool is_step() const { return 2 * steps > pairs; }
};

using Regions = std::pair<std::size_t, std::size_t>;  // the lesser first

Regions both(std::size_t a, std::size_t b) {
    return {std::min(a, b), std::max(a, b)};
}

/// Removes the parts that are not long in either direction.
cv::Mat1b without_short_parts(const cv::Mat1b& mask) {
    cv::Mat1i label;
    cv::Mat1i stats;
    cv::Mat1d centres;
    cv::connectedComponentsWithStats(mask, label, stats, centres, 8, CV_32S);
    cv::Mat1b kept(mask.size());
    std::ranges::transform(label, kept.begin(), [&](int part) {
        const int long_px =
            std::max(stats(part, cv::CC_STAT_WIDTH), stats(part, cv::CC_STAT_HEIGHT));
        return part > 0 && long_px >= least_stretch_px ? uchar{255} : uchar{0};
    });
    return kept;
}

class Fading {
  public:
    Fading(cv::Mat1b& map, std::vector<cv::Vec3f>& palette, const LabPicture& lab)
        : map_(map), palette_(palette), lab_(lab), runs_(runs_of(map)), region_(map.size()) {
        for (const Run& run : runs_) {
            region_(cv::Rect(run.from, run.row, run.to - run.from, 1))
                .setTo(static_cast<double>(run.region));
        }
    }

    /// Joins the regions and returns the remaining borders without a step.
    cv::Mat1b join() {
        const auto regions = std::ranges::count_if(
            runs_, [&](const Run& run) { return &run == &runs_[run.region]; });
        if (regions > most_regions) return cv::Mat1b(map_.size(), uchar{0});
        find_plateaus();
        find_pairs();
        for (const Pair& pair : pairs_) {
            Contact& contact = contacts_[both(region_at(pair.at), region_at(pair.at + pair.along))];
            ++contact.pairs;
            contact.soft += pair.is_soft ? 1 : 0;
            contact.steps += pair.is_step ? 1 : 0;
        }
        join_soft_ones();
        paint();
        ask_neighbours();
        return soft_borders();
    }

  private:
    /// Finds regions of a single colour, except at their rims.
    void find_plateaus() {
        is_plateau_.assign(runs_.size(), false);
        pixels_.assign(runs_.size(), 0);
        std::vector<int> even(runs_.size(), 0);
        for (const Run& run : runs_) {
            const cv::Vec3f& colour = palette_[map_(run.row, run.from)];
            pixels_[run.region] += run.to - run.from;
            for (int x = run.from; x < run.to; ++x) {
                even[run.region] += cv::norm(lab_(run.row, x) - colour) < plateau_spread ? 1 : 0;
            }
        }
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            is_plateau_[i] = pixels_[i] > 0 && even[i] >= mostly_plateau * pixels_[i];
        }
    }

    void find_pairs() {
        border_.assign(runs_.size(), 0);
        for (int y = 0; y < map_.rows; ++y) {
            for (int x = 0; x < map_.cols; ++x) {
                for (const cv::Point& along : {cv::Point(1, 0), cv::Point(0, 1)}) {
                    const cv::Point p(x, y);
                    const cv::Point next = p + along;
                    if (next.x < map_.cols && next.y < map_.rows && map_(p) != map_(next)) {
                        ++border_[region_at(p)];
                        ++border_[region_at(next)];
                        add(p, along);
                    }
                }
            }
        }
    }

    void add(const cv::Point& p, const cv::Point& along) {
        const cv::Rect frame({}, map_.size());
        if (!frame.contains(p - (fading_reach_px - 1) * along) ||
            !frame.contains(p + (fading_reach_px + 1) * along) || !is_true(p) ||
            !is_true(p + along)) {
            return;
        }
        pairs_.push_back({p, along, is_soft(p, along), is_step(p, along)});
    }

    /// A border is soft if most of it nearby is, because single pixels show little.
    void ask_neighbours() {
        cv::Mat1f votes(map_.size(), 0.0F);
        for (const Pair& pair : pairs_) votes(pair.at) += pair.is_soft ? 1.0F : -1.0F;
        cv::boxFilter(votes, votes, CV_32F, cv::Size(votes_within_px, votes_within_px),
                      cv::Point(-1, -1), false, cv::BORDER_CONSTANT);
        for (Pair& pair : pairs_) pair.is_soft = votes(pair.at) > 0.0F;
    }

    /// Returns stretches that are still a border, except those of a blurred one between two even
    /// areas.
    [[nodiscard]] cv::Mat1b soft_borders() const {
        cv::Mat1b soft(map_.size(), uchar{0});
        for (const Pair& pair : pairs_) {
            const std::size_t a = first_of(region_at(pair.at));
            const std::size_t b = first_of(region_at(pair.at + pair.along));
            if (pair.is_soft && a != b && !(pair.is_step && is_plateau_[a] && is_plateau_[b])) {
                soft(pair.at) = soft(pair.at + pair.along) = 255;
            }
        }
        cv::dilate(soft, soft, cv::Mat::ones(3, 3, CV_8U));
        return without_short_parts(soft);
    }

    /// False for a speck that something else has grown over.
    [[nodiscard]] bool is_true(const cv::Point& p) const {
        return cv::norm(lab_(p) - palette_[map_(p)]) < true_colour_levels;
    }

    [[nodiscard]] std::size_t region_at(const cv::Point& p) const {
        return static_cast<std::size_t>(region_(p));
    }

    /// Returns whether colours change beside the border as they do across it, or hardly change
    /// across it.
    [[nodiscard]] bool is_soft(const cv::Point& p, const cv::Point& along) const {
        const cv::Vec3f& before = lab_(p - along);
        const cv::Vec3f& after = lab_(p + 2 * along);
        const cv::Vec3f across = after - before;
        const float step = static_cast<float>(cv::norm(across));
        const cv::Vec3f colours = palette_[map_(p + along)] - palette_[map_(p)];
        const auto at_once = static_cast<float>(cv::norm(lab_(p + along) - lab_(p)));
        if (std::max(step, at_once) < flat_step * static_cast<float>(cv::norm(colours))) {
            return true;
        }
        if (step <= at_once) {  // a line of a pixel or two: beyond it the colour is as before it
            return false;
        }
        const float on = (lab_(p + (fading_reach_px + 1) * along) - after).dot(across) / step;
        const float back = (before - lab_(p - (fading_reach_px - 1) * along)).dot(across) / step;
        return std::min(on, back) >= least_beside * step && on + back >= both_beside * step;
    }

    /// Returns whether half the difference of the two colours lies near the border.
    [[nodiscard]] bool is_step(const cv::Point& p, const cv::Point& along) const {
        const cv::Vec3f colours = palette_[map_(p + along)] - palette_[map_(p)];
        const cv::Vec3f nearby =
            lab_(p + (fading_reach_px + 1) * along) - lab_(p - (fading_reach_px - 1) * along);
        return 2.0 * cv::norm(nearby) >= cv::norm(colours);
    }

    void join_soft_ones() {
        std::vector<std::pair<Contact, Regions>> soft;
        for (const auto& [regions, contact] : contacts_) {
            if (contact.is_soft()) soft.emplace_back(contact, regions);
        }
        std::ranges::stable_sort(soft, [](const auto& a, const auto& b) {
            return a.first.soft * b.first.pairs > b.first.soft * a.first.pairs;
        });
        for (const auto& [contact, regions] : soft) {
            const std::size_t a = first_of(regions.first);
            const std::size_t b = first_of(regions.second);
            if (a == b) continue;
            const Contact& whole = contacts_.at(both(a, b));
            const bool is_blurred_step = is_plateau_[a] && is_plateau_[b] && whole.is_step();
            if (whole.is_soft() && !is_blurred_step) take_in(a, b);
        }
    }

    [[nodiscard]] std::size_t first_of(std::size_t region) const {
        for (auto at = part_of_.find(region); at != part_of_.end(); at = part_of_.find(region)) {
            region = at->second;
        }
        return region;
    }

    /// True if wider than a blur: its two sides are its border.
    [[nodiscard]] bool is_broad(std::size_t region) const {
        return 2.0 * pixels_[region] > widest_blur_px * border_[region];
    }

    /// Makes the second region part of the first, with its borders. A plateau and the blur of its
    /// rim are a plateau; one that blends into a broad slope is a part of that.
    void take_in(std::size_t whole, std::size_t part) {
        part_of_[part] = whole;
        const auto stays = [this](std::size_t region) {
            return is_plateau_[region] || !is_broad(region);
        };
        is_plateau_[whole] =
            (is_plateau_[whole] || is_plateau_[part]) && stays(whole) && stays(part);
        pixels_[whole] += pixels_[part];
        border_[whole] += border_[part];
        std::vector<std::pair<std::size_t, Contact>> others;
        std::erase_if(contacts_, [&](const auto& entry) {
            const auto& [regions, contact] = entry;
            if (regions.first != part && regions.second != part) return false;
            others.emplace_back(regions.first == part ? regions.second : regions.first, contact);
            return true;
        });
        for (const auto& [other, contact] : others) {
            if (other != whole) {
                Contact& sum = contacts_[both(whole, other)];
                sum.pairs += contact.pairs;
                sum.soft += contact.soft;
                sum.steps += contact.steps;
            }
        }
    }

    /// Paints each joined region in its own colour; the largest one, the ground, keeps its colour.
    void paint() {
        std::map<std::size_t, std::pair<cv::Vec3f, int>> sums;  // of each region's pixels
        for (const Run& run : runs_) {
            const int pixels = run.to - run.from;
            auto& [sum, count] = sums[first_of(run.region)];
            sum += palette_[map_(run.row, run.from)] * static_cast<float>(pixels);
            count += pixels;
        }
        const std::size_t ground = std::ranges::max_element(sums, {}, [](const auto& s) {
                                       return s.second.second;
                                   })->first;
        std::map<std::size_t, uchar> colour_of;
        for (const auto& [part, whole] : part_of_) {
            const std::size_t region = first_of(whole);
            if (colour_of.contains(region) || palette_.size() >= most_colours) continue;
            if (region == ground) {
                colour_of[region] = commonest_colour(region);
                continue;
            }
            const auto& [sum, count] = sums[region];
            colour_of[region] = static_cast<uchar>(palette_.size());
            palette_.push_back(sum * (1.0F / static_cast<float>(count)));
        }
        for (const Run& run : runs_) {
            if (const auto at = colour_of.find(first_of(run.region)); at != colour_of.end()) {
                map_(cv::Rect(run.from, run.row, run.to - run.from, 1)).setTo(at->second);
            }
        }
    }

    [[nodiscard]] uchar commonest_colour(std::size_t region) const {
        std::vector<int> counts(most_colours, 0);
        for (const Run& run : runs_) {
            if (first_of(run.region) == region) {
                counts[map_(run.row, run.from)] += run.to - run.from;
            }
        }
        return static_cast<uchar>(std::ranges::max_element(counts) - counts.begin());
    }

    cv::Mat1b& map_;
    std::vector<cv::Vec3f>& palette_;
    const LabPicture& lab_;
    std::vector<Run> runs_;
    cv::Mat1i region_;
    std::vector<Pair> pairs_;
    // For each region, and for the one that has taken it in.
    std::vector<bool> is_plateau_;
    std::vector<int> pixels_;
    std::vector<int> border_;  // pixels beside others, all counted once for each
    std::map<Regions, Contact> contacts_;
    std::map<std::size_t, std::size_t> part_of_;
};

}  // namespace

cv::Mat1b join_fading(cv::Mat1b& map, std::vector<cv::Vec3f>& palette, const LabPicture& lab) {
    return palette.size() > 1 ? Fading(map, palette, lab).join() : cv::Mat1b(map.size(), uchar{0});
}

}  // namespace touchline
