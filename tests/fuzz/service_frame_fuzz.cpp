// For any texts of a service that may be no Inverse3's, places are within a hand's reach, what is
// said of them is one harmless line, and what is sent is a frame of ours.
#include "haptics/device/inverse3/inverse3_session.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace touchline {
namespace {

constexpr std::string_view good_list =
    R"({"session_id":1,"inverse3":[{"device_id":"04EA","config":{"type":"inverse3"},)"
    R"("state":{"cursor_position":{"x":0,"y":-0.1,"z":0.1}}}]})";

void demand(bool holds) {
    if (!holds) std::abort();
}

bool is_harmless(std::string_view line) {
    return line.size() < 1000 && std::ranges::none_of(line, [](char c) {
               return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
           });
}

/// Each line is an answer, 5 ms after the one before; the first byte tells whether the list came.
void feed_frames(std::string_view text) {
    Inverse3Session session("");
    double now_s = 0.0;
    if (!text.empty() && text.front() == '!') {
        session.hear(good_list, now_s);
        demand(session.has_arm());
        text.remove_prefix(1);
    }
    WantedArmForce wanted;
    while (!text.empty()) {
        now_s += 0.005;
        wanted = {{0.5, -0.5, std::nan("")}, wanted.number + 1};
        if (const auto command = session.due(wanted, now_s))
            demand(command->text().starts_with('{') && command->text().ends_with('}'));
        const std::size_t end = std::min(text.find('\n'), text.size());
        session.hear(text.substr(0, end), now_s);
        text.remove_prefix(std::min(end + 1, text.size()));
        const ArmNews& news = session.news();
        demand(std::abs(news.place_m.x) <= 1.0 && std::abs(news.place_m.y) <= 1.0 &&
               std::abs(news.place_m.z) <= 1.0);
        demand(is_finite(news.velocity_m_per_s.value_or(Space{})));
        demand(news.answered <= wanted.number);
        const auto ready = session.readiness();
        demand(ready ? session.has_arm() : is_harmless(ready.error().line));
    }
}

}  // namespace
}  // namespace touchline

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    touchline::feed_frames({reinterpret_cast<const char*>(data), size});
    return 0;
}
