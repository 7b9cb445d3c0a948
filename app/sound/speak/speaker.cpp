#include "app/sound/speak/speaker.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <span>
#include <utility>

#include <sys/socket.h>

namespace touchline {
namespace {

constexpr int most_deaths = 3;
constexpr int most_pieces = 256;  // in one call: 5 s of speech

}  // namespace

void VoiceProcess::begin(const std::string& voice, const std::string& text,
                         const EngineRate& rate) {
    const std::string plain = plain_text(text);
    order_.rate = rate;
    order_.bytes = static_cast<std::uint32_t>(plain.size());
    std::copy(plain.begin(), plain.end(), order_.text.begin());
    wanted_voice_ = voice;
    is_done_ = false;
    received_ = 0;
    again_ = 0;
    deaths_ = 0;
    if (is_sent_ || voice_ != wanted_voice_) end_process();
}

void VoiceProcess::stop() {
    if (is_done_) return;
    is_done_ = true;
    end_process();
}

bool VoiceProcess::start_process() {
    int ends[2] = {-1, -1};
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) return false;
    Descriptor ours(ends[0]);
    const Descriptor theirs(ends[1]);
    const std::array<const Descriptor*, 1> handed{&theirs};
    auto child = Child::start(program_, {wanted_voice_}, handed);
    if (!child) return false;
    child_.emplace(std::move(*child));
    socket_ = std::move(ours);
    voice_ = wanted_voice_;
    again_ = received_;
    return true;
}

void VoiceProcess::end_process() {
    is_sent_ = false;
    if (!child_) return;
    child_->kill();
    (void)child_->reap();
    child_.reset();
    socket_ = Descriptor();
}

void VoiceProcess::send_order(double now_s) {
    const ssize_t sent =
        send(socket_.number(), &order_, sizeof order_, MSG_DONTWAIT | MSG_NOSIGNAL);
    is_sent_ = sent == sizeof order_;
    heard_s_ = now_s;
}

/// False if the process ended before it was done.
bool VoiceProcess::take_pieces(double now_s, std::vector<float>& samples) {
    for (int i = 0; i < most_pieces; ++i) {
        SpokenPiece piece;
        const ssize_t got = recv(socket_.number(), &piece, sizeof piece, MSG_DONTWAIT | MSG_TRUNC);
        if (got < 0) return errno == EAGAIN || errno == EINTR;
        if (got != sizeof piece || piece.count > SpokenPiece::most_samples) return false;
        heard_s_ = now_s;
        const std::size_t old = std::min<std::size_t>(again_, piece.count);
        again_ -= old;
        const auto first = piece.samples.begin();
        samples.insert(samples.end(), first + static_cast<std::ptrdiff_t>(old),
                       first + static_cast<std::ptrdiff_t>(piece.count));
        received_ += piece.count - old;
        if (piece.is_last == 0) continue;
        is_done_ = true;
        end_process();
        return true;
    }
    return true;
}

void VoiceProcess::count_death() {
    end_process();
    ++deaths_;
    if (is_done_) return;
    ++restarts_;
    if (deaths_ < most_deaths) return;
    ++given_up_;
    is_done_ = true;
}

void VoiceProcess::receive(double now_s, std::vector<float>& samples) {
    const bool may_start = deaths_ < most_deaths || now_s - heard_s_ > patience_s;
    const bool may_wait = !wanted_voice_.empty() && may_start;
    if (!child_ && is_done_ && !may_wait) return;
    if (!child_) {
        heard_s_ = now_s;
        if (!start_process()) return count_death();
    }
    if (!is_done_ && !is_sent_) send_order(now_s);
    const bool lives = take_pieces(now_s, samples);
    const bool is_silent = !is_done_ && now_s - heard_s_ > patience_s * std::exp2(deaths_);
    if (!lives || is_silent) count_death();
}

Speaker::Speaker(std::string program, std::map<std::string, SpokenLanguage> languages,
                 RecordedPrompts prompts, Mixer& mixer)
    : voice_(std::move(program)),
      languages_(std::move(languages)),
      prompts_(std::move(prompts)),
      mixer_(mixer) {}

void Speaker::carry_out(const SpeechOrder& order) {
    if (order.stop) {
        mixer_.speech().cut();
        voice_.stop();
        pieces_.clear();
        samples_.clear();
        written_ = 0;
    }
    if (!order.begin) return;
    mixer_.send({0, PauseSpeech{false}});
    if (const auto* recorded = prompts_.of(*order.begin)) {
        samples_ = *recorded;
        return;
    }
    const auto found = languages_.find(order.begin->language);
    language_ = found == languages_.end() ? SpokenLanguage{} : found->second;
    SpokenText text(order.begin->text);
    text.recorded = order.begin->recorded;
    for (SpeechPiece& piece : pieces_of(text)) pieces_.push_back(std::move(piece));
    begin_pieces();
}

/// The voice makes the samples of a piece much faster than they are heard, so each piece begins as
/// soon as the one before is made: nobody waits between two of them.
void Speaker::begin_pieces() {
    while (!pieces_.empty() && voice_.is_done()) {
        const SpeechPiece piece = std::move(pieces_.front());
        pieces_.pop_front();
        if (!samples_.empty())
            samples_.resize(samples_.size() + static_cast<std::size_t>(pause_s * frame_rate_Hz));
        if (piece.recording)
            play(*piece.recording);
        else
            voice_.begin(language_.voice, respelled(piece.words, language_.respellings),
                         engine_rate(rate_, language_.pace));
    }
}

void Speaker::play(const VoiceRecording& recording) {
    samples_.reserve(samples_.size() + recording.samples.size());
    for (const std::int16_t sample : recording.samples)
        samples_.push_back(recording.gain * of_full_scale(sample));
}

void Speaker::say(const Utterance& utterance, double now_s) {
    carry_out(queue_.say(utterance, now_s));
}

void Speaker::stop(double now_s) {
    carry_out(queue_.stop(now_s));
}

void Speaker::toggle_pause() {
    mixer_.send({0, PauseSpeech{queue_.toggle_pause()}});
}

void Speaker::set_rate(std::size_t step) {
    rate_ = std::min(step, speech_rates_per_minute.size() - 1);
}

void Speaker::step(double now_s) {
    voice_.receive(now_s, samples_);
    begin_pieces();
    written_ += mixer_.speech().write(std::span<const float>(samples_).subspan(written_));
    if (written_ < samples_.size() || !voice_.is_done() || !pieces_.empty()) return;
    samples_.clear();
    written_ = 0;
    if (queue_.current() && mixer_.speech().waiting() == 0) carry_out(queue_.finished(now_s));
}

void Speaker::forget() {
    carry_out({.stop = true, .begin = std::nullopt});
    queue_.forget();
}

}  // namespace touchline
