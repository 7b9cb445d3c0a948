#include "tests/app/force/servo/process_rig.h"

#include <fcntl.h>
#include <spawn.h>

namespace touchline {

void ProcessRig::start_kiosk() {
    std::string program = TOUCHLINE_SERVO_RIG;
    std::string mode = "kiosk";
    std::string socket = socket_path();
    char* const words[] = {program.data(), mode.data(), path_.data(),
                           listener_ != 0 ? socket.data() : nullptr, nullptr};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, words_path().c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0600);
    ASSERT_EQ(posix_spawn(&kiosk_, program.c_str(), &actions, nullptr, words, environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    words_read_ = 0;
}

void ProcessRig::start_listener() {
    std::string program = TOUCHLINE_SERVO_RIG;
    std::string mode = "listen";
    std::string socket = socket_path();
    char* const words[] = {program.data(), mode.data(), socket.data(), nullptr};
    ASSERT_EQ(posix_spawn(&listener_, program.c_str(), nullptr, nullptr, words, environ), 0);
    ASSERT_TRUE(wait_until([&socket] { return std::filesystem::exists(socket); }));
}

}  // namespace touchline
