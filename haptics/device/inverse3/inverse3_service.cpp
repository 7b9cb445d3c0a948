#include "haptics/device/inverse3/inverse3_service.h"

#include "config/types/steady_clock.h"
#include "config/types/triple_buffer.h"

#include <array>
#include <atomic>
#include <chrono>
#include <ctime>
#include <exception>
#include <functional>
#include <limits>
#include <string>
#include <thread>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <fmt/format.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using asio::ip::tcp;
using boost::system::error_code;
using namespace std::chrono_literals;

constexpr auto longest_connect = 2s;
constexpr auto look_period = 5ms;  // for what time alone makes due
constexpr auto longest_end = 80ms;
constexpr std::int64_t longest_cut_ns = 5'000'000;
constexpr std::uint64_t cut_number = std::numeric_limits<std::uint64_t>::max();

double now_in_s() {
    return static_cast<double>(steady_now_ns()) * 1e-9;
}

/// What goes on, for whoever waits for it.
enum class TalkStage : std::uint8_t { connecting, greeting, talking, over };

}  // namespace

class Inverse3Service::Talk {
  public:
    Talk(std::string_view name, std::uint16_t port)
        : port_(port), session_(name), bell_(io_, ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

    ~Talk() { end(); }

    Talk(const Talk&) = delete;
    Talk& operator=(const Talk&) = delete;

    Result<void> begin(const std::function<bool()>& goes_on);
    void end();

    ArmNews news() {
        (void)news_.update();
        return news_.value();
    }

    void tell(const WantedArmForce& wanted) {
        wanted_.write(wanted);
        ring();
    }

    bool cut() noexcept;

    /// The thread leaves it as it is from the first news on.
    [[nodiscard]] std::string name() const { return std::string(session_.name()); }

  private:
    void connected(error_code error);
    void greeted(error_code error);
    void hear();
    void heard(error_code error);
    void listen_for_bell();
    void look_again();
    void advance();
    void sent(error_code error);
    void be_over();
    void close();

    void ring() noexcept {
        const std::uint64_t one = 1;
        (void)!::write(bell_.native_handle(), &one, sizeof one);
    }

    [[nodiscard]] WantedArmForce wanted_now();

    std::uint16_t port_;
    Inverse3Session session_;
    asio::io_context io_{1};
    asio::posix::stream_descriptor bell_;
    asio::steady_timer period_{io_};
    beast::websocket::stream<tcp::socket> socket_{io_};
    beast::flat_buffer heard_{longest_frame_bytes};
    std::array<std::uint64_t, 1> rung_{};
    CommandText saying_;
    bool is_saying_ = false;
    bool is_saying_cut_ = false;
    TalkStage stage_ = TalkStage::connecting;
    error_code failure_;
    TripleBuffer<ArmNews> news_;
    TripleBuffer<WantedArmForce> wanted_;
    std::atomic<bool> is_cut_{false};
    std::atomic<bool> is_cut_sent_{false};
    std::atomic<bool> is_end_wanted_{false};
    std::thread thread_;
};

Result<void> Inverse3Service::Talk::begin(const std::function<bool()>& goes_on) {
    const auto deadline = std::chrono::steady_clock::now() + longest_connect;
    const tcp::endpoint door(asio::ip::address_v4::loopback(), port_);
    socket_.next_layer().async_connect(door, [this](error_code error) { connected(error); });
    while (stage_ != TalkStage::over && !session_.has_arm() &&
           std::chrono::steady_clock::now() < deadline) {
        if (goes_on && !goes_on()) return failure("nobody wants the Inverse3 any more");
        (void)io_.run_one_for(look_period);
    }
    if (session_.has_arm() && stage_ == TalkStage::talking) {
        thread_ = std::thread([this] { io_.run(); });
        return {};
    }
    if (stage_ == TalkStage::talking) return tl::unexpected(session_.readiness().error());
    if (failure_ == asio::error::connection_refused)
        return failure(
            fmt::format("nobody answers at port {} of this computer: start the Inverse3's service "
                        "(systemctl start haply-inverse-service)",
                        port_));
    if (failure_ == asio::error::address_family_not_supported ||
        failure_ == boost::system::errc::operation_not_permitted)
        return failure(
            fmt::format("this service may not reach port {} of this computer: copy "
                        "device-loopback.conf, as the manual says",
                        port_));
    return failure(
        fmt::format("what answers at port {} of this computer is not the Inverse3's "
                    "service: look at what else uses that port",
                    port_));
}

void Inverse3Service::Talk::connected(error_code error) {
    if (error) {
        failure_ = error;
        be_over();
        return;
    }
    stage_ = TalkStage::greeting;
    socket_.next_layer().set_option(tcp::no_delay(true), error);
    socket_.read_message_max(longest_frame_bytes);
    socket_.text(true);
    socket_.async_handshake(fmt::format("127.0.0.1:{}", port_), "/",
                            [this](error_code e) { greeted(e); });
}

void Inverse3Service::Talk::greeted(error_code error) {
    if (error) {
        failure_ = error;
        be_over();
        return;
    }
    stage_ = TalkStage::talking;
    hear();
    listen_for_bell();
    look_again();
}

void Inverse3Service::Talk::hear() {
    heard_.clear();
    socket_.async_read(heard_, [this](error_code error, std::size_t /*size*/) { heard(error); });
}

void Inverse3Service::Talk::heard(error_code error) {
    if (error) {
        be_over();
        return;
    }
    const auto bytes = heard_.cdata();
    session_.hear({static_cast<const char*>(bytes.data()), bytes.size()}, now_in_s());
    news_.write(session_.news());
    advance();
    hear();
}

void Inverse3Service::Talk::listen_for_bell() {
    bell_.async_read_some(asio::buffer(rung_), [this](error_code error, std::size_t /*size*/) {
        if (error || stage_ == TalkStage::over) return;
        advance();
        listen_for_bell();
    });
}

void Inverse3Service::Talk::look_again() {
    period_.expires_after(look_period);
    period_.async_wait([this](error_code error) {
        if (error || stage_ == TalkStage::over) return;
        advance();
        look_again();
    });
}

WantedArmForce Inverse3Service::Talk::wanted_now() {
    if (is_cut_) return {{}, cut_number};
    (void)wanted_.update();
    return wanted_.value();
}

void Inverse3Service::Talk::advance() {
    if (stage_ != TalkStage::talking || is_saying_) return;
    const WantedArmForce wanted = wanted_now();
    if (is_end_wanted_ && session_.news().answered == cut_number) {
        close();
        return;
    }
    const auto command = session_.due(wanted, now_in_s());
    if (!command) return;
    saying_ = *command;
    is_saying_ = true;
    is_saying_cut_ = wanted.number == cut_number;
    const std::string_view text = saying_.text();
    socket_.async_write(asio::buffer(text.data(), text.size()),
                        [this](error_code error, std::size_t /*size*/) { sent(error); });
}

void Inverse3Service::Talk::sent(error_code error) {
    is_saying_ = false;
    if (error) {
        be_over();
        return;
    }
    if (is_saying_cut_) is_cut_sent_ = true;
    advance();
}

void Inverse3Service::Talk::close() {
    stage_ = TalkStage::over;
    socket_.async_close(beast::websocket::close_code::normal, [this](error_code) { io_.stop(); });
}

void Inverse3Service::Talk::be_over() {
    stage_ = TalkStage::over;
    session_.lose();
    news_.write(session_.news());
    error_code ignored;
    socket_.next_layer().close(ignored);
    io_.stop();
}

bool Inverse3Service::Talk::cut() noexcept {
    is_cut_ = true;
    ring();
    const timespec pause{0, 100'000};
    for (std::int64_t waited_ns = 0; waited_ns < longest_cut_ns && !is_cut_sent_;
         waited_ns += pause.tv_nsec)
        (void)::nanosleep(&pause, nullptr);
    return is_cut_sent_;
}

void Inverse3Service::Talk::end() {
    if (!thread_.joinable()) return;
    is_cut_ = true;
    is_end_wanted_ = true;
    ring();
    const auto deadline = std::chrono::steady_clock::now() + longest_end;
    while (!io_.stopped() && std::chrono::steady_clock::now() < deadline)
        std::this_thread::sleep_for(1ms);
    io_.stop();
    thread_.join();
}

Result<std::unique_ptr<Inverse3Service>> Inverse3Service::connect(
    std::string_view name, std::uint16_t port, const std::function<bool()>& goes_on) {
    try {
        auto talk = std::make_unique<Talk>(name, port);
        if (const auto begun = talk->begin(goes_on); !begun) return tl::unexpected(begun.error());
        return std::unique_ptr<Inverse3Service>(new Inverse3Service(std::move(talk)));
    } catch (const std::exception& lack) {
        return failure(fmt::format("the Inverse3's service cannot be talked to: {}", lack.what()));
    }
}

bool Inverse3Service::answers(std::uint16_t port) {
    asio::io_context io;
    tcp::socket socket(io);
    error_code error;
    socket.connect({asio::ip::address_v4::loopback(), port}, error);
    return !error;
}

std::string Inverse3Service::name() const {
    return talk_->name();
}

Inverse3Service::Inverse3Service(std::unique_ptr<Talk> talk) : talk_(std::move(talk)) {}

Inverse3Service::~Inverse3Service() = default;

ArmNews Inverse3Service::news() {
    return talk_->news();
}

void Inverse3Service::tell(const WantedArmForce& wanted) {
    talk_->tell(wanted);
}

void Inverse3Service::rest(double span_s) {
    std::this_thread::sleep_for(std::chrono::duration<double>(span_s));
}

bool Inverse3Service::cut() noexcept {
    return talk_->cut();
}

}  // namespace touchline
