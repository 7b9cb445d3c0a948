// touchline-speak VOICE: the kiosk starts it with its socket. It gets the voice ready, closes its
// sandbox (app/isolation/sandbox), waits for one order, says it (messages.h) and ends. So one
// person's text never meets the next one's, and the same text always gives the same samples. Exit
// status: 0 everything was said, 1 no voice, no order or no listener, worker_refused_to_start. One
// thread.
#include "app/isolation/process/descriptor.h"
#include "app/isolation/sandbox/sandbox.h"
#include "app/isolation/sandbox/worker.h"
#include "app/sound/speak/messages.h"
#include "audio-cues/speech/espeak_engine.h"
#include "audio-cues/speech/resampler.h"
#include "audio-cues/synth/frames.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <span>
#include <vector>

#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

namespace touchline {
namespace {

// Plain read() and writev(), one packet each, because the sandbox forbids socket calls.

/// Waits for an order. Nothing if the other side is gone, or sent something else.
std::optional<SpeakOrder> one_order(int socket) {
    SpeakOrder order;
    const ssize_t got = read(socket, &order, sizeof order);
    if (got != sizeof order || order.bytes > order.text.size()) return std::nullopt;
    return order;
}

/// Sends one order's samples.
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

/// True if all of it was sent.
bool say(EspeakEngine& engine, const SpeakOrder& order, int socket) {
    Sender sender(socket);
    Resampler resampler(EspeakEngine::rate_Hz);
    std::vector<float> spoken;
    std::vector<float> samples;
    bool goes_on = true;
    engine.speak({order.text.data(), order.bytes}, order.rate,
                 [&](std::span<const std::int16_t> piece) {
                     spoken.resize(piece.size());
                     std::ranges::transform(piece, spoken.begin(), of_full_scale);
                     samples.clear();
                     resampler.add(spoken, samples);
                     goes_on = sender.send(samples);
                     return goes_on;
                 });
    samples.clear();
    resampler.finish(samples);
    return goes_on && sender.send(samples) && sender.finish();
}

int failed(const Error& error, int status) {
    std::fprintf(stderr, "touchline-speak: %s\n", plain_line(error.line).c_str());
    return status;
}

/// The engine prints what it cannot say, with the person's text, and no log may grow.
bool silence_streams(const Descriptor& nowhere) {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (dup2(nowhere.number(), stream) < 0) return false;
    return true;
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    using namespace touchline;
    if (argc != 2) {
        std::fprintf(stderr, "touchline-speak: the kiosk starts it by itself; use 'touchline'\n");
        return 2;
    }
    Descriptor nowhere(open("/dev/null", O_RDWR | O_CLOEXEC));
    if (const auto fenced = allow_only_reading_the_system(); !fenced)
        return failed(fenced.error(), worker_refused_to_start);
    auto engine = EspeakEngine::start(argv[1]);
    if (!engine) return failed(engine.error(), 1);
    if (!silence_streams(nowhere) || !nowhere.close()) return worker_refused_to_start;
    if (!enter_sandbox(WorkerKind::speech)) return worker_refused_to_start;
    const auto order = one_order(worker_input);
    return order && say(*engine, *order, worker_input) ? 0 : 1;
}
