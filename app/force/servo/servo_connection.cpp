#include "app/force/servo/servo_connection.h"

#include "app/force/servo/black_box.h"
#include "config/types/map_bytes.h"

#include <utility>

namespace touchline {
namespace {

constexpr std::int64_t longest_absence_ns = 500'000'000;

}  // namespace

void ServoConnection::connect(std::shared_ptr<const Connection> connection) {
    const std::lock_guard lock(mutex_);
    connection_ = std::move(connection);
    connection_->region.channel().commands.write(commands_);
    send_scene();
}

void ServoConnection::disconnect() {
    const std::lock_guard lock(mutex_);
    connection_.reset();
    has_told_ = false;
    has_ended_ = true;
}

void ServoConnection::note(const std::string& line) {
    const std::lock_guard lock(mutex_);
    add_notice(line);
}

void ServoConnection::add_notice(const std::string& line) {
    notice_ += (notice_.empty() ? "" : "; ") + line;
}

void ServoConnection::say(const std::string& words) {
    const std::lock_guard lock(mutex_);
    words_ = words;
}

std::string ServoConnection::device_words() const {
    const std::lock_guard lock(mutex_);
    return words_;
}

bool ServoConnection::is_kiosk_alive(std::int64_t now_ns) const {
    return now_ns - asked_ns_.load(std::memory_order_relaxed) < longest_absence_ns;
}

void ServoConnection::set(const ServoCommands& commands) {
    const std::lock_guard lock(mutex_);
    commands_ = commands;
    if (connection_) connection_->region.channel().commands.write(commands);
}

void ServoConnection::feel(const FeltPicture& picture) {
    const auto bytes = bytes_of(*picture.map);
    auto sealed = bytes ? sealed_copy(*bytes) : Result<Descriptor>(tl::unexpected(bytes.error()));
    if (!sealed) return note(sealed.error().line);
    const std::lock_guard lock(mutex_);
    map_ = std::move(*sealed);
    order_ = picture.order;
    gallery_file_ = picture.recorded.gallery_file;
    send_scene();
}

void ServoConnection::ask_recorder(MessageKind wish) {
    const std::lock_guard lock(mutex_);
    const bool is_heard = connection_ && send(connection_->socket, message_of(wish));
    if (!is_heard && wish == MessageKind::keep)
        add_notice(std::string(recording_not_kept) + "no servo runs that has one");
}

/// The socket holds many such messages. A servo that reads none of them is killed for its silence.
void ServoConnection::send_scene() {
    if (!connection_ || !map_.is_open()) return;
    Message message = message_of(MessageKind::scene, gallery_file_);
    message.scene = order_;
    (void)send(connection_->socket, message, &map_);
}

void ServoConnection::update(ServoReport& report, std::int64_t now_ns) {
    asked_ns_.store(now_ns, std::memory_order_relaxed);
    const std::lock_guard lock(mutex_);
    if (connection_ && connection_->region.channel().reports.update()) {
        const ServoReport told = connection_->region.channel().reports.value();
        std::atomic_signal_fence(std::memory_order_acq_rel);  // copied first, then judged
        if (is_sound(told)) report = told;
        has_told_ = true;
    }
    if (has_told_) return;
    report.hand.force = {};
    report.force = {};
    if (has_ended_ && words_.empty()) report.force.fault = Fault::device_lost;
}

std::optional<ContactEvent> ServoConnection::next_event() {
    const std::lock_guard lock(mutex_);
    if (!connection_) return std::nullopt;
    return connection_->region.channel().events.pop();
}

std::optional<RealTimeTier> ServoConnection::tier() const {
    const std::lock_guard lock(mutex_);
    return connection_ ? tier_of(connection_->region.channel()) : std::nullopt;
}

LatenessBars ServoConnection::lateness() const {
    const std::lock_guard lock(mutex_);
    return connection_ ? bars_of(connection_->region.channel().lateness) : LatenessBars{};
}

std::string ServoConnection::take_notice() {
    const std::lock_guard lock(mutex_);
    return std::exchange(notice_, {});
}

}  // namespace touchline
