#include "tests/lab/bench/kiosk/real_kiosk.h"

#include "app/documents/sticks/stick_port.h"
#include "app/isolation/process/places.h"
#include "app/kiosk/loading/kiosk_stages.h"
#include "app/kiosk/loading/loader.h"
#include "app/kiosk/stick_source.h"
#include "haptics/device/simulated/simulated_pantograph.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr std::int64_t press_ns = 150'000'000;  // a key twice within 0.1 s is one

class PacedDevice final : public SoundDevice {
  public:
    explicit PacedDevice(std::shared_ptr<std::atomic<std::int64_t>> heard_ns)
        : heard_ns_(std::move(heard_ns)) {}

    ~PacedDevice() override { close(); }

    Result<void> open(FrameSource source, int /*block*/) override {
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

}  // namespace

RealKiosk::RealKiosk(const std::string& stick) {
    KioskParts parts;
    parts.languages = std::vector<Language>(1);
    parts.gallery =
        read_gallery(TOUCHLINE_SOURCE_DIR "/app/documents/gallery/pictures", "", parts.languages)
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
    auto heard = std::make_unique<Sound>(std::move(sound), [this] { return servo_->next_event(); });
    sound_ = heard.get();
    parts.sound = std::move(heard);
    parts.servo = std::move(servo);
    parts.profile = default_profile();
    parts.loader = std::make_unique<Loader>(std::make_shared<const KioskStages>(parts.profile),
                                            std::make_unique<ThreadExecutor>(2));
    if (!stick.empty())
        parts.sticks =
            std::make_unique<StickSource>(open_stick_port(stick), companion("touchline-import"));
    kiosk_ = std::make_unique<Kiosk>(std::move(parts));
    kiosk_->step(steady_now_ns());
}

void RealKiosk::run_for(std::int64_t time_ns) {
    const std::int64_t end_ns = steady_now_ns() + time_ns;
    (void)wait_until([end_ns] { return steady_now_ns() >= end_ns; });
}

void RealKiosk::press(KeyRole role) {
    kiosk_->press(role);
    run_for(press_ns);
}

void RealKiosk::focus_on(std::size_t item) {
    for (int i = 0; i < 100 && kiosk_->screen().focus != std::optional(item); ++i)
        press(KeyRole::down);
}

double RealKiosk::heard_after_ms(KeyRole role) {
    wait_for_silence();
    heard_ns_->store(0);
    const std::int64_t pressed_ns = steady_now_ns();
    kiosk_->press(role);
    (void)wait_until([this] { return heard_ns_->load() != 0; });
    return 1e-6 * static_cast<double>(heard_ns_->load() - pressed_ns);
}

double RealKiosk::felt_after_ms(KeyRole role) {
    const std::uint64_t before = servo_->latest().map_version;
    const std::int64_t pressed_ns = steady_now_ns();
    kiosk_->press(role);
    const bool is_felt = wait_until([&] {
        const bool is_new = servo_->latest().map_version != before;
        const ForceState state = servo_->force_status().state;
        return is_new && (state == ForceState::ramp || state == ForceState::live);
    });
    if (!is_felt) {
        const ForceStatus force = servo_->force_status();
        fmt::print(stderr, "no force: state {}, fault {}, {} picture; the screen: {}\n",
                   static_cast<int>(force.state), static_cast<int>(force.fault),
                   servo_->latest().map_version == before ? "the old" : "the new",
                   kiosk_->screen().title);
    }
    return 1e-6 * static_cast<double>(steady_now_ns() - pressed_ns);
}

void RealKiosk::choose_sounds(CueAmount amount) {
    SoundWanted wanted = kiosk_->visit().visitor.sound;
    wanted.amount = amount;
    sound_->choose(wanted);
}

void RealKiosk::wait_for_silence() {
    sound_->hush();
    run_for(300'000'000);
}

}  // namespace touchline
