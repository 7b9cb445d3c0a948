// touchline-speak VOICE: started by the kiosk with its socket. Gets the voice ready, shuts itself
// in (app/sandbox), waits for one order, says it (messages.h) and ends: what one person wrote
// never meets what the next one does, and the same text always gives the same samples. Exit status:
// 0 all said, 1 no voice, no order or nobody who listens, worker_refused_to_start. One thread.
#include "app/process/descriptor.h"
#include "app/sandbox/sandbox.h"
#include "app/sandbox/worker.h"
#include "app/speak/messages.h"
#include "audio-cues/speech/espeak_engine.h"
#include "audio-cues/speech/resampler.h"
#include "audio-cues/synth/frames.h"
#include "config/types/plain_line.h"

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

// Plain read() and writev(), a packet each: the sandbox allows no calls of sockets.

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

/// The engine prints what it misses, and with it what somebody wrote; nor is a log to grow.
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
