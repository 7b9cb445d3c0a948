#include "haptics/device/serial/serial_port.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace touchline {
namespace {

std::string why_not_opened(int error) {
    switch (error) {
        case ENOENT:
        case ENXIO:
        case ENODEV:
            return "nothing is plugged in there: plug the device in, or name another port";
        case EACCES:
            return "this user may not: add the user to the group dialout, or copy "
                   "device-serial.conf for a kiosk that is a service, as the manual says";
        case EPERM:  // the service's DeviceAllow
            return "this service may not: copy device-serial.conf, as the manual says";
        case EBUSY:
            return "another program has it: end that program";
        default:
            return "the system refuses it (error " + std::to_string(error) +
                   "): unplug the device and plug it in again";
    }
}

// Raw, and a read without news says so, so that it differs from the end of an unplugged port.
bool make_raw(int descriptor) {
    termios settings{};
    if (tcgetattr(descriptor, &settings) != 0) return false;
    cfmakeraw(&settings);
    settings.c_cflag |= static_cast<tcflag_t>(CLOCAL | CREAD);
    settings.c_cflag &= ~static_cast<tcflag_t>(CRTSCTS);
    settings.c_cc[VMIN] = 1;
    settings.c_cc[VTIME] = 0;
    return cfsetspeed(&settings, B921600) == 0 && tcsetattr(descriptor, TCSANOW, &settings) == 0 &&
           tcflush(descriptor, TCIOFLUSH) == 0;
}

}  // namespace

SerialPort::~SerialPort() {
    (void)ioctl(descriptor_, TIOCNXCL);
    close(descriptor_);
}

// Nothing is left over only if the system has taken all of what came before.
bool SerialPort::write(std::span<const std::uint8_t> bytes) {
    send_on();
    if (is_gone_ || unsent_size_ > 0 || bytes.size() > unsent_.size()) return false;
    const auto rest = bytes.subspan(sent_now(bytes));
    if (is_gone_) return false;
    std::ranges::copy(rest, unsent_.begin());
    unsent_size_ = rest.size();
    return true;
}

void SerialPort::send_on() {
    if (unsent_size_ == 0 || is_gone_) return;
    const std::size_t sent = sent_now({unsent_.data(), unsent_size_});
    std::copy(unsent_.begin() + static_cast<std::ptrdiff_t>(sent),
              unsent_.begin() + static_cast<std::ptrdiff_t>(unsent_size_), unsent_.begin());
    unsent_size_ -= sent;
}

std::size_t SerialPort::sent_now(std::span<const std::uint8_t> bytes) {
    const ssize_t sent = ::write(descriptor_, bytes.data(), bytes.size());
    if (sent >= 0) return static_cast<std::size_t>(sent);
    is_gone_ = is_gone_ || (errno != EAGAIN && errno != EINTR);
    return 0;
}

std::size_t SerialPort::read(std::span<std::uint8_t> room) {
    send_on();
    if (is_gone_ || room.empty()) return 0;
    const ssize_t got = ::read(descriptor_, room.data(), room.size());
    if (got > 0) return static_cast<std::size_t>(got);
    is_gone_ = got == 0 || (errno != EAGAIN && errno != EINTR);
    return 0;
}

void SerialPort::rest(double span_s) {
    std::this_thread::sleep_for(std::chrono::duration<double>(span_s));
    send_on();
}

Result<std::unique_ptr<ByteLink>> open_serial_port(const std::string& path) {
    const auto refused = [&](int error) {
        return failure("the port '" + path + "' could not be opened: " + why_not_opened(error));
    };
    const int descriptor = open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return refused(errno);
    // The lock keeps out other programs that ask for it, the other call all but root's. Only a port
    // that is ours may end in SerialPort's destructor, which would open another's to all.
    if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        close(descriptor);
        return refused(EBUSY);
    }
    auto port = std::make_unique<SerialPort>(descriptor);
    if (!make_raw(descriptor)) {
        return failure("'" + path +
                       "' is no serial port: name the one of the device, for example "
                       "/dev/ttyACM0");
    }
    (void)ioctl(descriptor, TIOCEXCL);
    return port;
}

}  // namespace touchline
