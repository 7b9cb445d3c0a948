#include "tests/app/printing/own_cups.h"

#include "tests/app/signal_one.h"

#include <chrono>
#include <cstring>
#include <fstream>
#include <iterator>
#include <thread>

#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// CUPS runs it for each job: job user title copies options file.
constexpr const char* backend = R"(#!/bin/sh
[ $# -eq 0 ] && exit 0
echo "$2|$3|$5" >> FOLDER/out/told
touch FOLDER/out/printing
case $DEVICE_URI in
    *good) cat "${6:-/dev/stdin}" > FOLDER/out/printed ;;
    *empty) echo 'STATE: +media-empty-error' >&2; exec sleep 60 ;;
    *jammed) echo 'STATE: +media-jam-error' >&2; exec sleep 60 ;;
    *unplugged) echo 'STATE: +offline-report' >&2; exec sleep 60 ;;
    *slow) exec sleep 60 ;;
    *) exit 1 ;;
esac
)";

/// What Debian's own file allows whom.
constexpr const char* settings = R"(LogLevel debug
MaxLogSize 0
DirtyCleanInterval 0
Listen FOLDER/socket
Browsing No
WebInterface No
PreserveJobFiles KEEPS
PreserveJobHistory KEEPS
<Location />
  Order allow,deny
</Location>
<Policy default>
  JobPrivateAccess default
  JobPrivateValues default
  <Limit Create-Job Print-Job Print-URI Validate-Job>
    Order deny,allow
  </Limit>
  <Limit Send-Document Send-URI Purge-Jobs Cancel-My-Jobs Close-Job>
    Require user @OWNER @SYSTEM
    Order deny,allow
  </Limit>
  <Limit Cancel-Job>
    Require user REMOVERS
    Order deny,allow
  </Limit>
  <Limit All>
    Order deny,allow
  </Limit>
</Policy>
)";

constexpr const char* files = R"(ServerRoot FOLDER/etc
ServerBin FOLDER/bin
RequestRoot FOLDER/spool
TempDir FOLDER/spool/tmp
CacheDir FOLDER/cache
StateDir FOLDER/state
AccessLog FOLDER/log/access
ErrorLog FOLDER/log/error
PageLog FOLDER/log/page
)";

constexpr const char* queue = R"(<Printer NAME>
DeviceURI test:/NAME
State STATE
Accepting TAKES
Shared No
OpPolicy default
ErrorPolicy abort-job
</Printer>
)";

std::string with(std::string text, const std::string& word, const std::string& value) {
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at))
        text.replace(at, word.size(), value);
    return text;
}

void write(const fs::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

std::string content(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string queues() {
    std::string all;
    for (const std::string name :
         {"good", "empty", "jammed", "unplugged", "slow", "broken", "paused", "closed"})
        all += with(with(with(queue, "NAME", name), "STATE", name == "paused" ? "Stopped" : "Idle"),
                    "TAKES", name == "closed" ? "No" : "Yes");
    return all;
}

bool answers(const std::string& path) {
    const int made = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    const bool is_there =
        connect(made, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    close(made);
    return is_there;
}

}  // namespace

std::string OwnCups::program() {
    for (const char* path : {"/usr/sbin/cupsd", "/sbin/cupsd"})
        if (fs::exists(path)) return path;
    return {};
}

OwnCups::OwnCups(CupsKeeps keeps)
    : folder_(fs::temp_directory_path() / ("cups-" + std::to_string(getpid()))) {
    fs::remove_all(folder_);
    for (const char* each :
         {"etc", "bin/backend", "bin/filter", "spool/tmp", "cache", "state", "log", "out"})
        fs::create_directories(folder_ / each);
    const std::string place = folder_.string();
    write(folder_ / "bin/backend/test", with(backend, "FOLDER", place));
    fs::permissions(folder_ / "bin/backend/test", fs::perms(0755));
    fs::permissions(folder_ / "out", fs::perms(0777));  // a backend is another user, under root
    // The program of CUPS that starts backends.
    fs::create_directory_symlink("/usr/lib/cups/daemon", folder_ / "bin/daemon");
    const std::string rules = with(settings, "KEEPS", keeps == CupsKeeps::nothing ? "No" : "Yes");
    write(folder_ / "etc/cupsd.conf",
          with(with(rules, "FOLDER", place), "REMOVERS",
               keeps == CupsKeeps::for_good ? "nobody" : "@OWNER @SYSTEM"));
    write(folder_ / "etc/cups-files.conf", with(files, "FOLDER", place));
    write(folder_ / "etc/printers.conf", queues());
    start();
}

OwnCups::~OwnCups() {
    kill();
    fs::remove_all(folder_);
}

void OwnCups::start() {
    std::vector<std::string> words{program(), "-f",
                                   "-c",      (folder_ / "etc/cupsd.conf").string(),
                                   "-s",      (folder_ / "etc/cups-files.conf").string()};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    fs::remove(socket());
    ASSERT_EQ(posix_spawn(&pid_, words[0].c_str(), nullptr, nullptr, arguments.data(), environ), 0);
    for (int i = 0; i < 1000 && !answers(socket()); ++i) std::this_thread::sleep_for(10ms);
    ASSERT_TRUE(answers(socket())) << content(folder_ / "log/error");
}

void OwnCups::kill() {
    if (pid_ < 0) return;
    signal_one(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    pid_ = -1;
}

std::string OwnCups::printed() const {
    return content(folder_ / "out/printed");
}

std::string OwnCups::told() const {
    return content(folder_ / "out/told");
}

bool OwnCups::is_printing() const {
    for (int i = 0; i < 1000; ++i) {
        if (fs::exists(folder_ / "out/printing")) return true;
        std::this_thread::sleep_for(10ms);
    }
    return false;
}

std::vector<std::string> OwnCups::spooled() const {
    std::vector<std::string> found;
    for (const auto& each : fs::recursive_directory_iterator(folder_ / "spool"))
        if (!each.is_directory()) found.push_back(each.path().filename().string());
    return found;
}

std::vector<std::string> OwnCups::files_with(const std::string& bytes) const {
    std::vector<std::string> found;
    for (const char* kept : {"spool", "cache", "state", "log", "etc"})
        for (const auto& each : fs::recursive_directory_iterator(folder_ / kept))
            if (each.is_regular_file() && content(each.path()).find(bytes) != std::string::npos)
                found.push_back(each.path().string());
    return found;
}

}  // namespace touchline
