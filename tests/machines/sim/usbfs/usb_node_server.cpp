#include "tests/machines/sim/usbfs/usb_node_server.h"

#include "config/types/steady_clock.h"
#include "tests/machines/sim/board/board_rig.h"
#include "tests/machines/sim/board/usb_function.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#define FUSE_USE_VERSION 35
#include <fuse_lowlevel.h>
#include <linux/usbdevice_fs.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr std::size_t set_up_bytes = 8;
constexpr int between_deliveries_us = 250;

double steady_now_s() {
    return 1e-9 * static_cast<double>(steady_now_ns());
}

bool read_from(pid_t process, const void* address, void* bytes, std::size_t size) {
    const iovec here{bytes, size}, there{const_cast<void*>(address), size};
    return process_vm_readv(process, &here, 1, &there, 1, 0) == static_cast<ssize_t>(size);
}

bool write_to(pid_t process, void* address, const void* bytes, std::size_t size) {
    const iovec here{const_cast<void*>(bytes), size}, there{address, size};
    return process_vm_writev(process, &here, 1, &there, 1, 0) == static_cast<ssize_t>(size);
}

UsbNodeServer& server_of(fuse_req_t request) {
    return *static_cast<UsbNodeServer*>(fuse_req_userdata(request));
}

}  // namespace

/// FUSE's calls. The file system is a single file.
struct NodeOperations {
    static void getattr(fuse_req_t request, fuse_ino_t, fuse_file_info*) {
        struct stat status {};

        status.st_ino = FUSE_ROOT_ID;
        status.st_mode = S_IFREG | 0600;
        status.st_nlink = 1;
        status.st_size = static_cast<off_t>(server_of(request).descriptors_.size());
        fuse_reply_attr(request, &status, 0.0);
    }

    static void open(fuse_req_t request, fuse_ino_t, fuse_file_info* file) {
        UsbNodeServer& server = server_of(request);
        const std::lock_guard lock(server.mutex_);
        file->fh = ++server.files_;
        file->direct_io = 1;
        fuse_reply_open(request, file);
    }

    static void read(fuse_req_t request, fuse_ino_t, std::size_t size, off_t from,
                     fuse_file_info*) {
        const PacketBytes& all = server_of(request).descriptors_;
        const std::size_t start = std::min(static_cast<std::size_t>(from), all.size());
        fuse_reply_buf(request, reinterpret_cast<const char*>(all.data()) + start,
                       std::min(size, all.size() - start));
    }

    static void ioctl(fuse_req_t request, fuse_ino_t, unsigned command, void* arg,
                      fuse_file_info* file, unsigned, const void* given, std::size_t given_size,
                      std::size_t) {
        UsbNodeServer& server = server_of(request);
        const pid_t caller = fuse_req_ctx(request)->pid;
        const std::string_view words(static_cast<const char*>(given), given_size);
        std::string answer;
        const std::lock_guard lock(server.mutex_);
        const int result = server.request(caller, file->fh, command, arg, words, answer);
        if (result < 0)
            fuse_reply_err(request, -result);
        else
            fuse_reply_ioctl(request, result, answer.data(), answer.size());
        server.wake();
    }

    static void poll(fuse_req_t request, fuse_ino_t, fuse_file_info*, fuse_pollhandle* handle) {
        UsbNodeServer& server = server_of(request);
        const std::lock_guard lock(server.mutex_);
        server.advance();
        if (handle != nullptr) {
            if (server.waiting_ != nullptr) fuse_pollhandle_destroy(server.waiting_);
            server.waiting_ = handle;
        }
        fuse_reply_poll(request, server.transfers_.has_ended() ? POLLOUT | POLLWRNORM : 0U);
    }

    static void release(fuse_req_t request, fuse_ino_t, fuse_file_info* file) {
        UsbNodeServer& server = server_of(request);
        const std::lock_guard lock(server.mutex_);
        server.release(file->fh);
        fuse_reply_err(request, 0);
    }
};

std::unique_ptr<UsbNodeServer> UsbNodeServer::create(const std::string& path,
                                                     const BoardTruth& truth) {
    std::unique_ptr<UsbNodeServer> server(new UsbNodeServer(truth));
    fuse_lowlevel_ops operations{};
    operations.getattr = NodeOperations::getattr;
    operations.open = NodeOperations::open;
    operations.read = NodeOperations::read;
    operations.ioctl = NodeOperations::ioctl;
    operations.poll = NodeOperations::poll;
    operations.release = NodeOperations::release;
    std::string name = "touchline-board";
    std::array<char*, 2> words{name.data(), nullptr};
    fuse_args arguments = FUSE_ARGS_INIT(1, words.data());
    server->session_ = fuse_session_new(&arguments, &operations, sizeof operations, server.get());
    if (server->session_ == nullptr || fuse_session_mount(server->session_, path.c_str()) != 0)
        return nullptr;
    server->answering_ = std::thread([session = server->session_] {
        become_hardware();
        (void)fuse_session_loop(session);
    });
    server->delivering_ = std::thread([me = server.get()] { me->deliver_all_the_time(); });
    return server;
}

UsbNodeServer::UsbNodeServer(const BoardTruth& truth)
    : board_(truth, resting_hand(truth.profile)),
      transfers_(board_),
      start_s_(steady_now_s()),
      descriptors_(device_descriptor(board_)) {
    const PacketBytes configuration = configuration_descriptor(board_);
    descriptors_.insert(descriptors_.end(), configuration.begin(), configuration.end());
}

UsbNodeServer::~UsbNodeServer() {
    is_ending_ = true;
    if (delivering_.joinable()) delivering_.join();
    if (session_ == nullptr) return;
    fuse_session_exit(session_);
    fuse_session_unmount(session_);
    if (answering_.joinable()) answering_.join();
    if (waiting_ != nullptr) fuse_pollhandle_destroy(waiting_);
    fuse_session_destroy(session_);
}

void UsbNodeServer::with(const std::function<void(BoardEmulator&, UsbFaults&)>& look) {
    const std::lock_guard lock(mutex_);
    advance();
    look(board_, transfers_.faults);
}

void UsbNodeServer::advance() {
    board_.advance_to(steady_now_s() - start_s_);
    transfers_.deliver();
}

void UsbNodeServer::deliver_all_the_time() {
    become_hardware();
    while (!is_ending_) {
        (void)usleep(between_deliveries_us);
        const std::lock_guard lock(mutex_);
        advance();
        wake();
    }
}

void UsbNodeServer::wake() {
    if (waiting_ == nullptr || !transfers_.has_ended()) return;
    (void)fuse_lowlevel_notify_poll(waiting_);
    fuse_pollhandle_destroy(std::exchange(waiting_, nullptr));
}

int UsbNodeServer::request(pid_t caller, std::uint64_t file, unsigned command, void* arg,
                           std::string_view given, std::string& answer) {
    advance();
    unsigned interface = 0;
    int sent = 0;
    switch (command) {
        case USBDEVFS_SUBMITURB:
            return submit(caller, arg);
        case USBDEVFS_REAPURB:
        case USBDEVFS_REAPURBNDELAY:
            return reap(caller, arg);
        case USBDEVFS_DISCARDURB:
            return transfers_.discard(reinterpret_cast<std::uint64_t>(arg)) ? 0 : -EINVAL;
        case USBDEVFS_BULK:
            if (const int error = bulk(caller, file, given, sent)) return error;
            answer = given;
            return sent;
        case USBDEVFS_CLAIMINTERFACE:
        case USBDEVFS_DISCONNECT_CLAIM:
            return read_from(caller, arg, &interface, sizeof interface) ? claim(file, interface)
                                                                        : -EFAULT;
        case USBDEVFS_RELEASEINTERFACE:
            if (!read_from(caller, arg, &interface, sizeof interface)) return -EFAULT;
            if (!claims_.contains(interface) || claims_[interface] != file) return -EINVAL;
            claims_.erase(interface);
            if (interface != 0) transfers_.end_all(-ENOENT);
            return 0;
        case USBDEVFS_CONNECTINFO: {
            const usbdevfs_connectinfo info{};
            return write_to(caller, arg, &info, sizeof info) ? 0 : -EFAULT;
        }
        case USBDEVFS_CLEAR_HALT:
            transfers_.clear_halts();
            return 0;
        case USBDEVFS_GETDRIVER:
        case USBDEVFS_IOCTL:
            return -ENODATA;
        case USBDEVFS_GET_CAPABILITIES:
            answer.assign(sizeof(std::uint32_t), '\0');
            return 0;
        default:
            return -ENOTTY;
    }
}

int UsbNodeServer::claim(std::uint64_t file, unsigned interface) {
    const auto [claimed, is_new] = claims_.try_emplace(interface, file);
    return is_new || claimed->second == file ? 0 : -EBUSY;
}

int UsbNodeServer::submit(pid_t caller, void* arg) {
    std::array<std::byte, sizeof(usbdevfs_urb)> words{};
    if (!read_from(caller, arg, words.data(), words.size())) return -EFAULT;
    const auto& urb = *reinterpret_cast<const usbdevfs_urb*>(words.data());
    const auto id = reinterpret_cast<std::uint64_t>(arg);
    const bool is_control = urb.type == USBDEVFS_URB_TYPE_CONTROL;
    const bool is_in = !is_control && (urb.endpoint & 0x80) != 0;
    std::vector<std::uint8_t> bytes(is_in ? 0U : static_cast<std::size_t>(urb.buffer_length));
    if (!read_from(caller, urb.buffer, bytes.data(), bytes.size())) return -EFAULT;
    buffers_[id] = static_cast<char*>(urb.buffer) + (is_control ? set_up_bytes : 0);
    if (is_control)
        transfers_.control(id, bytes);
    else if (is_in)
        transfers_.listen(id, urb.endpoint);
    else
        transfers_.send(id, bytes);
    return 0;
}

// Writes into the caller's memory, as the kernel does: if another process reaps than the one that
// submitted, the addresses are still those of the submitter.
int UsbNodeServer::reap(pid_t caller, void* arg) {
    const auto ended = transfers_.reap();
    if (!ended) return -EAGAIN;
    auto* const words = reinterpret_cast<char*>(ended->id);
    const int actual = static_cast<int>(ended->received.size() + ended->sent);
    const bool is_written =
        write_to(caller, buffers_[ended->id], ended->received.data(), ended->received.size()) &&
        write_to(caller, words + offsetof(usbdevfs_urb, status), &ended->status,
                 sizeof ended->status) &&
        write_to(caller, words + offsetof(usbdevfs_urb, actual_length), &actual, sizeof actual) &&
        write_to(caller, arg, &ended->id, sizeof ended->id);
    buffers_.erase(ended->id);
    return is_written ? 0 : -EFAULT;
}

int UsbNodeServer::bulk(pid_t caller, std::uint64_t file, std::string_view given, int& sent) {
    usbdevfs_bulktransfer transfer{};
    if (given.size() != sizeof transfer) return -EINVAL;
    std::memcpy(&transfer, given.data(), sizeof transfer);
    if (const int error = claim(file, 1)) return error;
    std::vector<std::uint8_t> bytes(transfer.len);
    if ((transfer.ep & 0x80) != 0 || !read_from(caller, transfer.data, bytes.data(), bytes.size()))
        return -EFAULT;
    const auto ended = transfers_.sent(0, bytes);
    if (!ended) return -ETIMEDOUT;
    sent = static_cast<int>(ended->sent);
    return ended->status;
}

/// Called when the last process that had the file has closed it or died.
void UsbNodeServer::release(std::uint64_t file) {
    bool was_claimed = false;
    for (auto claim = claims_.begin(); claim != claims_.end();) {
        const bool is_its = claim->second == file;
        was_claimed = was_claimed || is_its;
        claim = is_its ? claims_.erase(claim) : std::next(claim);
    }
    if (!was_claimed) return;
    transfers_.forget_all();
    buffers_.clear();
}

}  // namespace touchline
