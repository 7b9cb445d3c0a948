// The port of the system: a pseudo-terminal is one in all that matters here.
#include "haptics/device/serial/serial_port.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace touchline {
namespace {

class Terminal {
  public:
    Terminal() : master_(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK)) {
        EXPECT_EQ(grantpt(master_), 0);
        EXPECT_EQ(unlockpt(master_), 0);
        path = ptsname(master_);
    }

    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    ~Terminal() { unplug(); }

    void unplug() {
        if (master_ >= 0) close(std::exchange(master_, -1));
    }

    void say(const std::string& text) {
        ASSERT_EQ(write(master_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    }

    std::string heard() {
        std::array<char, 4096> got{};
        const ssize_t size = read(master_, got.data(), got.size());
        return size > 0 ? std::string(got.data(), static_cast<std::size_t>(size)) : std::string();
    }

    std::string path;

  private:
    int master_;
};

std::vector<std::uint8_t> bytes_of(const std::string& text) {
    return {text.begin(), text.end()};
}

/// True if all but root are refused; root gets in and asks.
bool is_exclusive(const std::string& path) {
    const int descriptor = open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return errno == EBUSY;
    int is_so = 0;
    const bool is_told = ioctl(descriptor, TIOCGEXCL, &is_so) == 0;
    close(descriptor);
    return is_told && is_so != 0;
}

TEST(SerialPort, CarriesEveryByteAsItIs) {
    Terminal terminal;
    auto port = open_serial_port(terminal.path);
    ASSERT_TRUE(port.has_value());
    std::string all;
    for (int byte = 0; byte < 256; ++byte) all += static_cast<char>(byte);
    ASSERT_TRUE((*port)->write(bytes_of(all)));
    EXPECT_EQ(terminal.heard(), all);
    terminal.say(all);
    std::array<std::uint8_t, 512> room{};
    const std::size_t size = (*port)->read(room);
    EXPECT_EQ(std::string(room.begin(), room.begin() + static_cast<std::ptrdiff_t>(size)), all);
    EXPECT_EQ((*port)->read(room), 0U);
    EXPECT_FALSE((*port)->is_gone());
}

TEST(SerialPort, AFullLineTakesNothingAndNothingIsLostOrTorn) {
    Terminal terminal;
    auto port = open_serial_port(terminal.path);
    ASSERT_TRUE(port.has_value());
    const std::string piece(1000, 'x');
    std::size_t taken = 0;
    const auto start = std::chrono::steady_clock::now();
    while ((*port)->write(bytes_of(piece))) taken += piece.size();
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
    std::size_t heard = 0;
    for (int i = 0; i < 1000 && heard < taken; ++i) {
        heard += terminal.heard().size();
        (*port)->rest(1e-3);
    }
    EXPECT_EQ(heard, taken);
    EXPECT_TRUE((*port)->write(bytes_of(piece)));
}

TEST(SerialPort, UnpluggedIsGoneForEver) {
    Terminal terminal;
    auto port = open_serial_port(terminal.path);
    ASSERT_TRUE(port.has_value());
    terminal.unplug();
    std::array<std::uint8_t, 16> room{};
    EXPECT_EQ((*port)->read(room), 0U);
    EXPECT_TRUE((*port)->is_gone());
    EXPECT_FALSE((*port)->write(bytes_of("x")));
}

TEST(SerialPort, AnotherProgramDoesNotGetItMeanwhile) {
    Terminal terminal;
    auto port = open_serial_port(terminal.path);
    ASSERT_TRUE(port.has_value());
    const auto second = open_serial_port(terminal.path);
    ASSERT_FALSE(second.has_value());
    EXPECT_NE(second.error().line.find("another program has it"), std::string::npos)
        << second.error().line;
    EXPECT_TRUE(is_exclusive(terminal.path));
    port->reset();
    EXPECT_TRUE(open_serial_port(terminal.path).has_value());
}

TEST(SerialPort, WhatCannotBeOpenedIsSaidInOneLine) {
    const auto none = open_serial_port("/dev/no-such-port");
    ASSERT_FALSE(none.has_value());
    EXPECT_NE(none.error().line.find("plug the device in"), std::string::npos);
    const auto file = std::filesystem::temp_directory_path() / "touchline-no-port";
    close(creat(file.c_str(), 0600));
    const auto no_port = open_serial_port(file);
    ASSERT_FALSE(no_port.has_value());
    EXPECT_NE(no_port.error().line.find("is no serial port"), std::string::npos);
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace touchline
