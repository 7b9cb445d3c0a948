// The voice as the kiosk holds it: a process a text, which may die at any time, and nobody notices.
// Threads: one; the process dies with the thread that starts it.
#pragma once

#include "app/process/child.h"
#include "app/speak/messages.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

class VoiceProcess {
  public:
    /// `program`: path of touchline-speak. It is started when there is something to say, and then
    /// for the next text in advance.
    explicit VoiceProcess(std::string program) : program_(std::move(program)) {}

    ~VoiceProcess() { end_process(); }

    VoiceProcess(const VoiceProcess&) = delete;
    VoiceProcess(VoiceProcess&&) = delete;
    VoiceProcess& operator=(const VoiceProcess&) = delete;
    VoiceProcess& operator=(VoiceProcess&&) = delete;

    /// From here on only this is said, by the voice of that name. Never waits.
    void begin(const std::string& voice, const std::string& text, const EngineRate& rate);

    /// Nothing more of what was begun comes.
    void stop();

    /// Appends the samples that came (at frame_rate_Hz). Never waits. A process that died, or was
    /// silent for `patience_s` (twice that after every death: the machine may be busy), is started
    /// anew and goes on where it was: the same text gives the same samples. One that died while it
    /// waited for the next text is started anew as well. After three deaths the text is given up,
    /// and a process to wait for the next one is started every `patience_s` at most.
    void receive(double now_s, std::vector<float>& samples);

    /// Nothing more comes of what was begun, or nothing was.
    [[nodiscard]] bool is_done() const { return is_done_; }

    /// Processes started after one that died, so far.
    [[nodiscard]] int restarts() const { return restarts_; }

    /// Texts that were given up, so far.
    [[nodiscard]] int given_up() const { return given_up_; }

    /// -1: none runs.
    [[nodiscard]] pid_t pid() const { return child_ ? child_->pid() : -1; }

    static constexpr double patience_s = 2.0;

  private:
    bool start_process();
    void end_process();
    void send_order(double now_s);
    bool take_pieces(double now_s, std::vector<float>& samples);
    void count_death();

    std::string program_;
    std::string voice_;  // of the process that runs
    std::optional<Child> child_;
    Descriptor socket_;
    std::string wanted_voice_;
    SpeakOrder order_;
    bool is_done_ = true;
    bool is_sent_ = false;      // the process has its order
    std::size_t received_ = 0;  // samples of the order
    std::size_t again_ = 0;     // of them to come once more after a death
    double heard_s_ = 0.0;      // when the process was started or last gave a sign
    int deaths_ = 0;            // over this order
    int restarts_ = 0;
    int given_up_ = 0;
};

}  // namespace touchline
