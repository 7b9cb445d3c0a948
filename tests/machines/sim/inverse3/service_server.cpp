#include "tests/machines/sim/inverse3/service_server.h"

#include "config/types/steady_clock.h"
#include "haptics/device/inverse3/inverse3_frames.h"

#include <deque>
#include <future>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>

namespace touchline {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using asio::ip::tcp;
using boost::system::error_code;

/// One client. It lives as long as something of it is under way.
class Room : public std::enable_shared_from_this<Room> {
  public:
    using Answer = std::function<std::string(const std::string&)>;

    Room(tcp::socket socket, std::string greeting, Answer answer, std::function<void()> leave)
        : socket_(std::move(socket)),
          greeting_(std::move(greeting)),
          answer_(std::move(answer)),
          leave_(std::move(leave)) {}

    void open() {
        error_code ignored;
        socket_.next_layer().set_option(tcp::no_delay(true), ignored);
        socket_.async_accept([self = shared_from_this()](error_code error) {
            if (error) return;
            self->is_open_ = true;
            self->say(self->greeting_);
            self->hear();
        });
    }

    void hush(bool is_hushed) {
        is_hushed_ = is_hushed;
        go_on();
    }

    void say(const std::string& text) {
        if (!is_open_) return;
        to_say_.push_back(text);
        go_on();
    }

    void drop() {
        error_code ignored;
        socket_.next_layer().close(ignored);
    }

  private:
    void hear() {
        socket_.async_read(heard_, [self = shared_from_this()](error_code error, std::size_t) {
            if (error) {
                self->leave_();
                return;
            }
            const std::string text = beast::buffers_to_string(self->heard_.data());
            self->heard_.clear();
            self->say(self->answer_(text));
            self->hear();
        });
    }

    void go_on() {
        if (is_saying_ || is_hushed_ || to_say_.empty()) return;
        is_saying_ = true;
        socket_.text(true);
        socket_.async_write(asio::buffer(to_say_.front()),
                            [self = shared_from_this()](error_code error, std::size_t) {
                                self->is_saying_ = false;
                                self->to_say_.pop_front();
                                if (!error) self->go_on();
                            });
    }

    beast::websocket::stream<tcp::socket> socket_;
    std::string greeting_;
    Answer answer_;
    std::function<void()> leave_;
    beast::flat_buffer heard_;
    std::deque<std::string> to_say_;
    bool is_open_ = false;
    bool is_saying_ = false;
    bool is_hushed_ = false;
};

}  // namespace

class ServiceServer::Rooms {
  public:
    Rooms(const ServiceTruth& truth, std::shared_ptr<const IntendedPath> path)
        : begun_ns_(steady_now_ns()),
          service_(truth, std::move(path)),
          door_(io_, tcp::endpoint(asio::ip::address_v4::loopback(), 0)) {
        accept();
        thread_ = std::thread([this] { io_.run(); });
    }

    ~Rooms() {
        io_.stop();
        thread_.join();
    }

    Rooms(const Rooms&) = delete;
    Rooms& operator=(const Rooms&) = delete;

    [[nodiscard]] std::uint16_t port() const { return door_.local_endpoint().port(); }

    /// Runs it on the server's thread and waits for it.
    void run(const std::function<void()>& what) {
        std::promise<void> done;
        asio::post(io_, [&] {
            what();
            done.set_value();
        });
        done.get_future().wait();
    }

    void for_each(const std::function<void(Room&)>& what) {
        run([&] {
            for (const auto& weak : rooms_)
                if (const auto room = weak.lock()) what(*room);
        });
    }

    [[nodiscard]] ServiceEmulator& now() {
        service_.advance_to(static_cast<double>(steady_now_ns() - begun_ns_) * 1e-9);
        return service_;
    }

  private:
    void accept() {
        door_.async_accept([this](error_code error, tcp::socket socket) {
            if (error) return;
            const auto room = std::make_shared<Room>(
                std::move(socket), now().greet(),
                [this](const std::string& text) { return now().answer(text); },
                [this] { now().leave(); });
            rooms_.push_back(room);
            room->open();
            accept();
        });
    }

    std::int64_t begun_ns_;
    ServiceEmulator service_;
    asio::io_context io_{1};
    tcp::acceptor door_;
    std::vector<std::weak_ptr<Room>> rooms_;
    std::thread thread_;
};

ServiceServer::ServiceServer(const ServiceTruth& truth, std::shared_ptr<const IntendedPath> path)
    : rooms_(std::make_unique<Rooms>(truth, std::move(path))) {}

ServiceServer::~ServiceServer() = default;

std::uint16_t ServiceServer::port() const {
    return rooms_->port();
}

void ServiceServer::look_at(const std::function<void(ServiceEmulator&)>& look) {
    rooms_->run([&] { look(rooms_->now()); });
}

void ServiceServer::hush(bool is_hushed) {
    rooms_->for_each([&](Room& room) { room.hush(is_hushed); });
}

void ServiceServer::drop() {
    rooms_->for_each([](Room& room) { room.drop(); });
}

void ServiceServer::say(const std::string& text) {
    rooms_->for_each([&](Room& room) { room.say(text); });
}

}  // namespace touchline
