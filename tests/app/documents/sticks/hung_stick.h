// A stick that never answers: a FUSE file system whose server takes requests and says nothing. A
// process that asks cannot be ended before the server is. Only root can mount it.
// Threads: one of its own serves; one for the rest.
#pragma once

#include "app/isolation/process/descriptor.h"
#include "config/types/pinned.h"

#include <array>
#include <cstring>
#include <filesystem>
#include <string>
#include <thread>

#include <fcntl.h>
#include <linux/fuse.h>
#include <poll.h>
#include <sys/mount.h>

namespace touchline {

class HungStick : private Pinned {
  public:
    explicit HungStick(const std::filesystem::path& where) : where_(where) {
        const std::string options = "fd=" + std::to_string(device_.number()) +
                                    ",rootmode=40000,user_id=0,group_id=0,allow_other";
        is_mounted_ = ::mount("hung", where.c_str(), "fuse", MS_RDONLY | MS_NOSUID | MS_NODEV,
                              options.c_str()) == 0;
        if (is_mounted_)
            server_ = std::jthread([this](const std::stop_token& stop) { serve(stop); });
    }

    ~HungStick() { pull_out(); }

    [[nodiscard]] bool is_mounted() const { return is_mounted_; }

    /// Ends the server: from now on every request fails.
    void pull_out() {
        if (!is_mounted_) return;
        server_ = std::jthread();
        (void)device_.close();
        (void)::umount2(where_.c_str(), MNT_DETACH);
        is_mounted_ = false;
    }

  private:
    void serve(const std::stop_token& stop) const {
        std::array<char, 65536> request{};
        while (!stop.stop_requested()) {
            pollfd asked{device_.number(), POLLIN, 0};
            if (::poll(&asked, 1, 20) <= 0) continue;
            if (::read(device_.number(), request.data(), request.size()) <= 0) continue;
            fuse_in_header header{};
            std::memcpy(&header, request.data(), sizeof(header));
            if (header.opcode == FUSE_INIT) greet(header);
        }
    }

    void greet(const fuse_in_header& asked) const {
        struct {
            fuse_out_header header;
            fuse_init_out answer;
        } reply{};

        reply.header = {sizeof(reply), 0, asked.unique};
        reply.answer.major = FUSE_KERNEL_VERSION;
        reply.answer.minor = FUSE_KERNEL_MINOR_VERSION;
        reply.answer.max_write = 4096;
        (void)!::write(device_.number(), &reply, sizeof(reply));
    }

    std::filesystem::path where_;
    Descriptor device_{::open("/dev/fuse", O_RDWR | O_CLOEXEC)};
    bool is_mounted_ = false;
    std::jthread server_;
};

}  // namespace touchline
