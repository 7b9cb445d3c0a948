// How soon the kiosk answers, in real time, with all its parts except window and sound card. The
// device here asks for a block of 128 frames when a card would, two blocks ahead, and notes when
// the first audible one was rendered. What the card adds is not measured.
#include "app/force/servo/servo_thread.h"
#include "app/isolation/process/places.h"
#include "app/kiosk/kiosk.h"
#include "app/kiosk/loading/kiosk_stages.h"
#include "app/kiosk/loading/loader.h"
#include "app/sound/sound.h"
#include "config/types/steady_clock.h"
#include "haptics/device/simulated_pantograph.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr int runs = 21;
constexpr std::int64_t frame_ns = 16'666'667;  // of the screen
constexpr std::int64_t longest_wait_ns = 5'000'000'000;

class PacedDevice final : public SoundDevice {
  public:
    explicit PacedDevice(std::shared_ptr<std::atomic<std::int64_t>> heard_ns)
        : heard_ns_(std::move(heard_ns)) {}

    ~PacedDevice() override { close(); }

    Result<void> open(FrameSource source) override {
        thread_ = std::jthread([this, source = std::move(source)](const std::stop_token& stop) {
            auto due = std::chrono::steady_clock::now();
            while (!stop.stop_requested()) {
                std::array<StereoFrame, block_frames> block;
                source(block);
                const bool is_heard = std::ranges::any_of(block, [](const StereoFrame& frame) {
                    return frame.left != 0.0F || frame.right != 0.0F;
                });
                if (is_heard) note();
                due += std::chrono::microseconds(1'000'000 * block_frames / frame_rate_Hz);
                std::this_thread::sleep_until(due);
            }
        });
        return {};
    }

    void close() override {
        thread_.request_stop();
        if (thread_.joinable()) thread_.join();
    }

    [[nodiscard]] bool is_gone() const override { return false; }

  private:
    /// Notes only the first since somebody set it to zero.
    void note() {
        std::int64_t none = 0;
        heard_ns_->compare_exchange_strong(none, steady_now_ns());
    }

    std::shared_ptr<std::atomic<std::int64_t>> heard_ns_;
    std::jthread thread_;
};

/// A kiosk in real time.
class RealKiosk {
  public:
    RealKiosk() {
        KioskParts parts;
        parts.languages = std::vector<Language>(1);
        parts.gallery = read_gallery(TOUCHLINE_SOURCE_DIR "/app/documents/gallery/pictures", "",
                                     parts.languages)
                            .value();
        auto servo = std::make_unique<ServoThread>();
        (void)servo->start(
            std::make_unique<SimulatedPantograph>(default_profile(), SimulationOptions{},
                                                  std::make_shared<MouseHand>(Position{})),
            default_profile());
        servo_ = servo.get();
        SoundParts sound;
        sound.world.device = std::make_unique<PacedDevice>(heard_ns_);
        sound.speak_program = companion("touchline-speak");
        auto heard =
            std::make_unique<Sound>(std::move(sound), [this] { return servo_->next_event(); });
        sound_ = heard.get();
        parts.sound = std::move(heard);
        parts.servo = std::move(servo);
        parts.profile = default_profile();
        parts.loader = std::make_unique<Loader>(std::make_shared<const KioskStages>(parts.profile),
                                                std::make_unique<ThreadExecutor>(2));
        kiosk_ = std::make_unique<Kiosk>(std::move(parts));
        kiosk_->step(steady_now_ns());
    }

    void run_for(std::int64_t time_ns) {
        const std::int64_t end_ns = steady_now_ns() + time_ns;
        wait_until([end_ns] { return steady_now_ns() >= end_ns; });
    }

    /// Frames go on meanwhile. Returns false if it took too long.
    template <class Condition>
    bool wait_until(const Condition& is_so) {
        const std::int64_t begin_ns = steady_now_ns();
        std::int64_t next_ns = begin_ns;
        while (!is_so()) {
            if (steady_now_ns() - begin_ns > longest_wait_ns) return false;
            if (steady_now_ns() >= next_ns) {
                kiosk_->step(steady_now_ns());
                next_ns += frame_ns;
            }
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
        return true;
    }

    void press(KeyRole role) {
        kiosk_->press(role);
        run_for(150'000'000);
    }

    /// Returns the time from a key to the first audible frame.
    double heard_after_ms(KeyRole role) {
        (void)wait_for_silence();
        heard_ns_->store(0);
        const std::int64_t pressed_ns = steady_now_ns();
        kiosk_->press(role);
        (void)wait_until([this] { return heard_ns_->load() != 0; });
        return 1e-6 * static_cast<double>(heard_ns_->load() - pressed_ns);
    }

    /// Returns the time from a key to the first tick that feels another picture than before.
    double felt_after_ms(KeyRole role) {
        const std::uint64_t before = servo_->latest().map_version;
        const std::int64_t pressed_ns = steady_now_ns();
        kiosk_->press(role);
        (void)wait_until([&] { return servo_->latest().map_version != before; });
        return 1e-6 * static_cast<double>(steady_now_ns() - pressed_ns);
    }

    void choose_sounds(CueAmount amount) {
        SoundWanted wanted = kiosk_->visit().visitor.sound;
        wanted.amount = amount;
        sound().choose(wanted);
    }

    VisitorSound& sound() { return *sound_; }

    Kiosk& kiosk() { return *kiosk_; }

    void stop() { kiosk_->stop(); }

  private:
    bool wait_for_silence() {
        sound().hush();
        run_for(300'000'000);
        return true;
    }

    std::shared_ptr<std::atomic<std::int64_t>> heard_ns_ =
        std::make_shared<std::atomic<std::int64_t>>(0);
    ServoThread* servo_ = nullptr;  // owned by the kiosk
    Sound* sound_ = nullptr;        // owned by the kiosk
    std::unique_ptr<Kiosk> kiosk_;
};

void print(const char* what, std::vector<double> times_ms, double goal_ms) {
    std::ranges::sort(times_ms);
    const auto at = [&times_ms](double share) {
        return times_ms[static_cast<std::size_t>(share * static_cast<double>(times_ms.size() - 1))];
    };
    fmt::print("| {} | {:.1f} | {:.1f} | {:.1f} | {:.0f} |\n", what, at(0.5), at(0.9), at(1.0),
               goal_ms);
}

void measure() {
    RealKiosk kiosk;
    kiosk.run_for(1'000'000'000);
    kiosk.press(KeyRole::select);  // begins
    kiosk.press(KeyRole::select);  // English
    std::vector<double> sound_ms;
    for (int i = 0; i < runs; ++i) sound_ms.push_back(kiosk.heard_after_ms(KeyRole::down));
    kiosk.choose_sounds(CueAmount::none);
    std::vector<double> speech_ms;
    for (int i = 0; i < runs; ++i) speech_ms.push_back(kiosk.heard_after_ms(KeyRole::down));
    while (kiosk.kiosk().screen().focus != std::optional<std::size_t>(1))
        kiosk.press(KeyRole::down);
    kiosk.press(KeyRole::select);  // the gallery
    std::vector<double> felt_ms;
    for (int i = 0; i < runs; ++i) {
        kiosk.press(KeyRole::down);
        felt_ms.push_back(kiosk.felt_after_ms(KeyRole::select));
        kiosk.run_for(200'000'000);
        kiosk.press(KeyRole::back);  // back to the choices
        while (kiosk.kiosk().screen().focus != std::optional<std::size_t>(2))
            kiosk.press(KeyRole::down);
        kiosk.press(KeyRole::select);
        for (int down = 0; down <= i % 8; ++down) kiosk.press(KeyRole::down);
    }
    double load = 0.0;
    (void)getloadavg(&load, 1);
    fmt::print(
        "load {:.2f}, {} runs\n\n| from a key to | median, ms | 90 of 100, ms | most, ms | "
        "goal, ms |\n|---|---|---|---|---|\n",
        load, runs);
    print("its sound", sound_ms, 30.0);
    print("speech", speech_ms, 150.0);
    print("the first tick with the picture chosen", felt_ms, 1000.0);
    kiosk.stop();
}

}  // namespace
}  // namespace touchline

int main() {
    touchline::measure();
    return 0;
}
