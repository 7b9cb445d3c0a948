#include "app/documents/trace/trace_work.h"

#include "config/types/utf8.h"

#include <algorithm>
#include <array>
#include <charconv>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr int any_class = -1;
constexpr std::size_t number_count = 14;

/// The shortest text that reads back to the same bits.
std::string text_of(double number) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return {text.data(), end};
}

/// True for a whole number from `least` to `most`; NaN is none.
bool is_choice(double number, int least, int most) {
    return number >= least && number <= most && number == static_cast<int>(number);
}

}  // namespace

std::vector<std::string> words_of(const PlaceInPicture& place) {
    return {fmt::format("{:.6f}", place.x), fmt::format("{:.6f}", place.y)};
}

std::optional<PlaceInPicture> place_of(const std::vector<std::string>& words) {
    if (words.size() != 2) return std::nullopt;
    const auto x = number_in(words[0], 0.0, 1.0);
    const auto y = number_in(words[1], 0.0, 1.0);
    return x && y ? std::optional(PlaceInPicture{*x, *y}) : std::nullopt;
}

cv::Mat cut_off(const cv::Mat& picture, const PhotoCut& cut) {
    const auto share = [](double percent) {
        return percent >= 0.0 && percent <= 40.0 ? 0.01 * percent : 0.0;
    };
    const int left = cvRound(share(cut.left) * picture.cols);
    const int right = cvRound(share(cut.right) * picture.cols);
    const int top = cvRound(share(cut.top) * picture.rows);
    const int bottom = cvRound(share(cut.bottom) * picture.rows);
    return picture(cv::Rect(left, top, std::max(1, picture.cols - left - right),
                            std::max(1, picture.rows - top - bottom)));
}

Picture picture_of(const cv::Mat& bgr) {
    Picture picture;
    picture.width = bgr.cols;
    picture.height = bgr.rows;
    const cv::Mat whole = bgr.isContinuous() ? bgr : bgr.clone();
    picture.bgr.assign(whole.data, whole.data + whole.total() * whole.elemSize());
    return picture;
}

std::vector<std::string> arguments_of(const TraceWork& work) {
    const TraceOptions& options = work.options;
    const std::array<double, number_count> numbers{
        static_cast<double>(work.step),
        options.area.width_m,
        options.area.height_m,
        static_cast<double>(options.detail),
        options.zoom.centre.x,
        options.zoom.centre.y,
        options.zoom.factor,
        options.picture_class ? static_cast<double>(*options.picture_class) : any_class,
        work.wants_edges ? 1.0 : 0.0,
        work.has_main_things ? 1.0 : 0.0,
        work.cut.left,
        work.cut.right,
        work.cut.top,
        work.cut.bottom};
    std::vector<std::string> arguments;
    for (const double number : numbers) arguments.push_back(text_of(number));
    return arguments;
}

Result<TraceWork> trace_work_in(std::span<const std::string> arguments) {
    std::array<double, number_count> numbers{};
    bool is_read = arguments.size() == number_count;
    for (std::size_t i = 0; is_read && i < number_count; ++i) {
        const auto number = number_in<double>(arguments[i]);
        is_read = number.has_value();
        numbers[i] = number.value_or(0.0);
    }
    const auto [step, width_m, height_m, detail, x_m, y_m, factor, class_number, edges, things,
                left, right, top, bottom] = numbers;
    const bool are_choices = is_choice(step, 0, 2) && is_choice(detail, -1000, 1000) &&
                             is_choice(class_number, any_class, 3) && is_choice(edges, 0, 1) &&
                             is_choice(things, 0, 1);
    if (!is_read || !are_choices) return failure("not what the kiosk starts it with");
    TraceWork work;
    work.step = static_cast<TraceStep>(step);
    work.options.area = {width_m, height_m};
    work.options.detail = static_cast<int>(detail);
    work.options.zoom = {{x_m, y_m}, factor};
    if (class_number != any_class)
        work.options.picture_class = static_cast<PictureClass>(class_number);
    work.wants_edges = edges == 1.0;
    work.has_main_things = things == 1.0;
    work.cut = {left, right, top, bottom};
    return work;
}

}  // namespace touchline
