#include "app/speak/speak_program.h"

#include "app/speak/fence.h"
#include "app/speak/messages.h"
#include "audio-cues/speech/espeak_engine.h"
#include "audio-cues/speech/resampler.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <span>
#include <vector>

#include <sys/uio.h>
#include <unistd.h>

namespace touchline {
namespace {

// Plain read() and writev(), a packet each: a fence that lists calls need allow no others.

/// Waits; nothing where the other side is gone, or what it sent is no order.
std::optional<SpeakOrder> one_order(int socket) {
    SpeakOrder order;
    const ssize_t got = read(socket, &order, sizeof order);
    if (got != sizeof order || order.bytes > order.text.size()) return std::nullopt;
    return order;
}

/// One order's samples on their way out.
class Sender {
  public:
    explicit Sender(int socket) : socket_(socket) {}

    bool send(std::span<const float> samples) {
        while (!samples.empty()) {
            const std::size_t count = std::min(samples.size(), SpokenPiece::most_samples);
            if (!send_piece(samples.first(count), false)) return false;
            samples = samples.subspan(count);
        }
        return true;
    }

    bool finish() { return send_piece({}, true); }

  private:
    bool send_piece(std::span<const float> samples, bool is_last) {
        piece_.count = static_cast<std::uint32_t>(samples.size());
        piece_.is_last = is_last ? 1 : 0;
        std::copy(samples.begin(), samples.end(), piece_.samples.begin());
        const iovec packet{&piece_, sizeof piece_};
        return writev(socket_, &packet, 1) == sizeof piece_;
    }

    int socket_;
    SpokenPiece piece_;
};

/// Whether all of it got out.
bool say(EspeakEngine& engine, const SpeakOrder& order, int socket) {
    Sender sender(socket);
    Resampler resampler;
    std::vector<float> samples;
    bool goes_on = true;
    engine.speak({order.text.data(), order.bytes}, order.rate,
                 [&](std::span<const std::int16_t> piece) {
                     samples.clear();
                     resampler.add(piece, samples);
                     goes_on = sender.send(samples);
                     return goes_on;
                 });
    samples.clear();
    resampler.finish(samples);
    return goes_on && sender.send(samples) && sender.finish();
}

}  // namespace

int run_speak_program(int socket, const std::string& voice) {
    auto engine = EspeakEngine::start(voice);
    if (!engine) {
        std::fprintf(stderr, "touchline-speak: %s\n", engine.error().line.c_str());
        return 1;
    }
    if (const auto fenced = shut_in(); !fenced) {
        std::fprintf(stderr, "touchline-speak: %s\n", fenced.error().line.c_str());
        return 1;
    }
    const auto order = one_order(socket);
    return order && say(*engine, *order, socket) ? 0 : 1;
}

}  // namespace touchline
