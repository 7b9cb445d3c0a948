#include "tests/vision/prepare/page_photos.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

const cv::Size photo_size(800, 600);

class Dice {
  public:
    explicit Dice(std::mt19937& random) : random_(random) {}

    double between(double least, double most) {
        return least + (most - least) * static_cast<double>(random_()) / 4294967295.0;
    }

    int whole(int least, int most) {
        return least + static_cast<int>(random_() % static_cast<unsigned>(most - least + 1));
    }

    bool one_in(int n) { return whole(1, n) == 1; }

    cv::Point place(cv::Size size) { return {whole(0, size.width - 1), whole(0, size.height - 1)}; }

  private:
    std::mt19937& random_;
};

/// Brownian clouds: random fields of falling size and strength.
cv::Mat clouds(std::mt19937& random, cv::Size size, double strength) {
    cv::RNG rng(random());
    cv::Mat sum(size / 4, CV_32FC3, cv::Scalar::all(0));
    for (int cells = 3; cells < size.width / 6; cells *= 2) {
        cv::Mat small(cells * size.height / size.width + 1, cells, CV_32FC3);
        rng.fill(small, cv::RNG::NORMAL, 0.0, strength * 3.0 / cells);
        cv::Mat large;
        cv::resize(small, large, sum.size(), 0, 0, cv::INTER_LINEAR);
        sum += large;
    }
    cv::Mat out;
    cv::resize(sum, out, size, 0, 0, cv::INTER_LINEAR);
    return out;
}

/// Wood: streaks along x, and a colour.
cv::Mat desk(std::mt19937& random, cv::Size size, double level) {
    Dice dice(random);
    cv::Mat desk(size, CV_32FC3,
                 cv::Scalar(level * dice.between(0.5, 1.0), level * dice.between(0.7, 1.0), level));
    cv::RNG rng(random());
    cv::Mat streaks(size.height, 6, CV_32FC1);
    rng.fill(streaks, cv::RNG::NORMAL, 0.0, dice.between(0.0, 6.0));
    cv::resize(streaks, streaks, size, 0, 0, cv::INTER_CUBIC);
    cv::Mat three;
    cv::merge(std::vector<cv::Mat>{streaks, streaks, streaks}, three);
    return desk + three + clouds(random, size, 8.0);
}

void add_things(cv::Mat& bgr, std::mt19937& random, int count, double brightest) {
    Dice dice(random);
    for (int i = 0; i < count; ++i) {
        const cv::Scalar colour(dice.between(10, brightest), dice.between(10, brightest),
                                dice.between(10, brightest));
        const cv::Point at = dice.place(bgr.size());
        const int size = dice.whole(10, 90);
        switch (dice.whole(0, 2)) {
            case 0:
                cv::ellipse(bgr,
                            {cv::Point2f(at), cv::Size2f(cv::Point(2 * size, size)),
                             static_cast<float>(dice.between(0, 180))},
                            colour, cv::FILLED, cv::LINE_AA);
                break;
            case 1: {
                const cv::RotatedRect box(cv::Point2f(at),
                                          cv::Size2f(cv::Point(3 * size, size / 3)),
                                          static_cast<float>(dice.between(0, 180)));
                cv::Point2f f[4];
                box.points(f);
                cv::fillConvexPoly(bgr, std::vector<cv::Point>{f[0], f[1], f[2], f[3]}, colour,
                                   cv::LINE_AA);
                break;
            }
            default:
                cv::line(bgr, at, dice.place(bgr.size()), colour, dice.whole(1, 8), cv::LINE_AA);
        }
    }
}

/// Places a rectangle of this aspect, turned, and tilted by moving its corners in perspective.
Quad placed_corners(std::mt19937& random, const Hardship& hardship, double aspect) {
    Dice dice(random);
    const double height_px = hardship.page_share * photo_size.height;
    const cv::Point2d half(0.5 * height_px * std::min(aspect, 1.3),
                           0.5 * height_px * std::min(aspect, 1.3) / aspect);
    const double turn = dice.between(-hardship.turn_deg, hardship.turn_deg) * CV_PI / 180;
    const double lean_x = dice.between(-hardship.tilt, hardship.tilt);
    const double lean_y = dice.between(-hardship.tilt, hardship.tilt);
    const cv::Point2d centre(
        photo_size.width / 2.0 + (2.0 * hardship.shift.x) * half.x + dice.between(-20, 20),
        photo_size.height / 2.0 + (2.0 * hardship.shift.y) * half.y + dice.between(-15, 15));
    Quad corners;
    for (std::size_t i = 0; i < 4; ++i) {
        const double u = i == 1 || i == 2 ? 1.0 : -1.0;
        const double v = i >= 2 ? 1.0 : -1.0;
        const cv::Point2d flat(u * half.x * std::cos(turn) - v * half.y * std::sin(turn),
                               u * half.x * std::sin(turn) + v * half.y * std::cos(turn));
        const double depth = 1.0 + 0.5 * (lean_x * u + lean_y * v);
        corners[i] = centre + flat / depth;
    }
    return ordered(corners);
}

/// Draws the page over the table and shares its edges among the pixels that they cross. ordered()
/// may have begun with another corner, so the content may lie turned, which does not matter.
void lay(const cv::Mat& page, const Quad& corners, cv::Mat& table) {
    const auto side = [&](std::size_t i) { return cv::norm(corners[i] - corners[(i + 1) % 4]); };
    const cv::Size size(static_cast<int>(std::max(side(0), side(2))),
                        static_cast<int>(std::max(side(1), side(3))));
    cv::Mat small;
    cv::resize(page, small, size, 0, 0, cv::INTER_AREA);
    const float right = static_cast<float>(size.width) - 0.5F;
    const float bottom = static_cast<float>(size.height) - 0.5F;
    const std::vector<cv::Point2f> from{
        {-0.5F, -0.5F}, {right, -0.5F}, {right, bottom}, {-0.5F, bottom}};
    const std::vector<cv::Point2f> to(corners.begin(), corners.end());
    const cv::Mat transform = cv::getPerspectiveTransform(from, to);
    cv::Mat flat;
    cv::warpPerspective(small, flat, transform, table.size(), cv::INTER_LINEAR,
                        cv::BORDER_REPLICATE);
    constexpr int bits = 4;
    std::vector<cv::Point> outline;
    for (const cv::Point2d corner : corners)
        outline.emplace_back(cvRound(corner.x * (1 << bits)), cvRound(corner.y * (1 << bits)));
    cv::Mat cover(table.size(), CV_8UC3, cv::Scalar::all(0));
    cv::fillConvexPoly(cover, outline, cv::Scalar::all(255), cv::LINE_AA, bits);
    cv::Mat share;
    cover.convertTo(share, CV_32FC3, 1.0 / 255);
    cv::Mat difference;
    cv::subtract(flat, table, difference, cv::noArray(), CV_32F);
    cv::Mat change;
    cv::multiply(difference, share, change);
    cv::add(table, change, table, cv::noArray(), CV_8U);
}

/// Adds the same noise to all channels.
void add_noise(cv::Mat& bgr, std::mt19937& random, double levels) {
    cv::RNG rng(random());
    cv::Mat noise(bgr.size(), CV_32FC1);
    rng.fill(noise, cv::RNG::NORMAL, 0.0, levels);
    cv::Mat three;
    cv::merge(std::vector<cv::Mat>{noise, noise, noise}, three);
    cv::add(bgr, three, bgr, cv::noArray(), bgr.type());
}

cv::Mat to_8_bit(const cv::Mat& picture) {
    cv::Mat out;
    picture.convertTo(out, CV_8UC3);
    return out;
}

}  // namespace

cv::Mat page_content(std::mt19937& random, cv::Size size) {
    Dice dice(random);
    cv::Mat page(size, CV_8UC3, cv::Scalar(232, 236, 238));
    const double unit = size.width / 600.0;
    const int kind = dice.whole(0, 3);
    const auto dark = [&] {
        return cv::Scalar(dice.between(0, 110), dice.between(0, 110), dice.between(0, 110));
    };
    if (kind != 1) {
        const int lines = dice.whole(6, 22);
        for (int i = 1; i < lines; ++i)
            cv::putText(page, "Where the river meets the sea",
                        {static_cast<int>(45 * unit), i * size.height / lines},
                        cv::FONT_HERSHEY_SIMPLEX, dice.between(0.5, 0.9) * unit, dark(),
                        std::max(1, static_cast<int>(1.5 * unit)), cv::LINE_AA);
    }
    const int shapes = kind == 0 ? 0 : dice.whole(1, 4);
    for (int i = 0; i < shapes; ++i) {
        const cv::Point centre(dice.whole(size.width / 4, size.width * 3 / 4),
                               dice.whole(size.height / 4, size.height * 3 / 4));
        const int radius = dice.whole(30, 140) * size.width / 600;
        const int thickness = dice.one_in(2) ? cv::FILLED : static_cast<int>(4 * unit);
        if (dice.one_in(2)) {
            cv::circle(page, centre, radius, dark(), thickness, cv::LINE_AA);
        } else {
            cv::rectangle(page, {centre.x - radius, centre.y - radius / 2, 2 * radius, radius},
                          dark(), thickness, cv::LINE_AA);
        }
    }
    if (kind == 3)  // a frame drawn round everything
        cv::rectangle(page,
                      {size.width / 16, size.height / 16, size.width * 7 / 8, size.height * 7 / 8},
                      dark(), static_cast<int>(4 * unit), cv::LINE_AA);
    return page;
}

PagePhoto page_photo(unsigned seed, const Hardship& hardship) {
    std::mt19937 random(seed);
    Dice dice(random);
    PagePhoto photo;
    const double upright = dice.one_in(2) ? 1.0 / 1.41421356 : 8.5 / 11.0;
    photo.aspect = dice.one_in(2) ? upright : 1.0 / upright;
    photo.corners = placed_corners(random, hardship, photo.aspect);
    const cv::Size page_size = photo.aspect < 1.0
                                   ? cv::Size(600, static_cast<int>(600 / photo.aspect))
                                   : cv::Size(static_cast<int>(600 * photo.aspect), 600);
    const cv::Mat page = hardship.has_content ? page_content(random, page_size)
                                              : cv::Mat(page_size, CV_8UC3, cv::Scalar::all(235));
    photo.bgr = to_8_bit(desk(random, photo_size, hardship.desk_level));
    add_things(photo.bgr, random, static_cast<int>(12 * hardship.clutter), 170);
    lay(page, photo.corners, photo.bgr);
    add_shade(photo.bgr, hardship.shade, dice.between(0, 2 * CV_PI));
    cv::GaussianBlur(photo.bgr, photo.bgr, {}, hardship.blur_px);
    add_noise(photo.bgr, random, hardship.noise_levels);
    return photo;
}

cv::Mat pageless_photo(unsigned seed) {
    std::mt19937 random(seed);
    Dice dice(random);
    cv::Mat picture = desk(random, photo_size, dice.between(50, 220));
    const int scale = dice.whole(8, 50);
    switch (seed % 10) {
        case 0:
            break;
        case 1:
            add_noise(picture, random, dice.between(10, 80));
            break;
        case 2:
            picture += clouds(random, photo_size, dice.between(60, 250));
            break;
        case 3:
            for (int x = 0; x < photo_size.width; x += 2 * scale)
                picture.colRange(x, std::min(x + scale, photo_size.width)) += cv::Scalar::all(60);
            break;
        case 4:
            for (int row = 0; row * scale < photo_size.height; ++row)
                for (int x = -(row % 2) * scale; x < photo_size.width; x += 2 * scale)
                    cv::rectangle(picture, {x, row * scale, 2 * scale - 3, scale - 3},
                                  cv::Scalar(60, 70, dice.between(120, 180)), cv::FILLED);
            break;
        case 5:
            for (int y = 0; y < photo_size.height; y += scale)
                for (int x = (y / scale % 2) * scale; x < photo_size.width; x += 2 * scale)
                    cv::rectangle(picture, {x, y, scale, scale}, cv::Scalar::all(230), cv::FILLED);
            break;
        case 6:
            add_things(picture, random, 25, 255);
            break;
        case 7: {
            const int corners =
                std::vector<int>{3, 5, 6, 7}[static_cast<std::size_t>(dice.whole(0, 3))];
            std::vector<cv::Point> polygon;
            for (int i = 0; i < corners; ++i) {
                const double angle = 2 * CV_PI * i / corners + dice.between(-0.2, 0.2);
                polygon.emplace_back(static_cast<int>(400 + 220 * std::cos(angle)),
                                     static_cast<int>(300 + 220 * std::sin(angle)));
            }
            cv::fillConvexPoly(picture, polygon, cv::Scalar::all(235), cv::LINE_AA);
            break;
        }
        case 8:
            cv::circle(picture, dice.place(photo_size), dice.whole(80, 260), cv::Scalar::all(240),
                       cv::FILLED, cv::LINE_AA);
            break;
        default:
            cv::rectangle(picture, {150, 120, 480, 340}, cv::Scalar::all(20), cv::FILLED);
            add_things(picture, random, 6, 200);
    }
    add_shade(picture, dice.between(0.0, 0.6), dice.between(0, 2 * CV_PI));
    cv::GaussianBlur(picture, picture, {}, dice.between(0.5, 2.0));
    add_noise(picture, random, 3.0);
    return to_8_bit(picture);
}

void add_glare(cv::Mat& bgr, cv::Point2d centre, double radius_px) {
    cv::Mat spot(bgr.size(), CV_32FC3, cv::Scalar::all(0));
    cv::circle(spot, centre, static_cast<int>(radius_px), cv::Scalar::all(200), cv::FILLED);
    cv::GaussianBlur(spot, spot, {}, radius_px / 6);
    cv::Mat sum;
    bgr.convertTo(sum, CV_32FC3);
    sum += spot;
    sum.convertTo(bgr, CV_8UC3);
}

void add_shade(cv::Mat& bgr, double shade, double angle_rad) {
    const cv::Point2d along(std::cos(angle_rad), std::sin(angle_rad));
    const double reach = std::abs(along.x) * bgr.cols / 2.0 + std::abs(along.y) * bgr.rows / 2.0;
    cv::Mat light(bgr.size(), CV_32FC3);
    for (int y = 0; y < bgr.rows; ++y) {
        auto* row = light.ptr<cv::Vec3f>(y);
        const double t_left = ((y - bgr.rows / 2.0) * along.y - bgr.cols / 2.0 * along.x) / reach;
        for (int x = 0; x < bgr.cols; ++x)
            row[x] = cv::Vec3f::all(
                static_cast<float>(1.0 - shade * 0.5 * (t_left + x * along.x / reach + 1.0)));
    }
    cv::multiply(bgr, light, bgr, 1.0, bgr.type());
}

}  // namespace touchline::testing
