#include "tests/app/isolation/sandbox/acts.h"

#include <csignal>
#include <cstdint>

#include <fcntl.h>
#include <sched.h>
#include <sys/inotify.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchline {
namespace {

// Calls the kernel directly: the C library may make another call than the named one.
template <class... Arguments>
long call(long number, Arguments... arguments) {
    return syscall(number, arguments...);
}

constexpr const char* a_file = "/etc/passwd";
constexpr const char* a_new_file = "must-not-exist";
constexpr std::uintptr_t anywhere = 0;

#ifdef __x86_64__
constexpr std::string_view name_of_32_bit_call = "32-bit call";

long get_pid_in_32_bits() {
    long result = 0;
    asm volatile("int $0x80" : "=a"(result) : "a"(20L) : "memory");
    return result;
}

bool has_32_bit_calls() {
    const pid_t pid = fork();
    if (pid == 0) {
        signal(SIGSEGV, SIG_DFL);
        _exit(get_pid_in_32_bits() > 0 ? 0 : 1);
    }
    int status = 0;
    waitpid(pid, &status, 0);
    return !WIFSIGNALED(status);
}
#endif

long make_code() {
    void* const page =
        mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return page == MAP_FAILED ? -1 : 0;
}

long make_data_code() {
    void* const page =
        mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return mprotect(page, 4096, PROT_READ | PROT_EXEC);
}

long run_program() {
    const char* const words[] = {"/bin/true", nullptr};
    return call(SYS_execve, words[0], words, anywhere);
}

long start_process() {
    const long pid = call(SYS_clone, SIGCHLD, anywhere, anywhere, anywhere, anywhere);
    if (pid == 0) _exit(0);
    return pid;
}

}  // namespace

long read_system_file() {
    return call(SYS_openat, AT_FDCWD, "/usr/bin/env", O_RDONLY);
}

const std::vector<Act>& acts() {
    static const std::vector<Act> all{
        {"openat", [] { return call(SYS_openat, AT_FDCWD, a_file, O_RDONLY); }, true, true},
        {"create", [] { return call(SYS_openat, AT_FDCWD, a_new_file, O_CREAT | O_WRONLY, 0600); },
         true},
#ifdef __x86_64__
        {"open", [] { return call(SYS_open, a_file, O_RDONLY); }, true},
        {"mkdir", [] { return call(SYS_mkdir, a_new_file, 0700); }, true},
        {"symlink", [] { return call(SYS_symlink, a_file, a_new_file); }, true},
        {"link", [] { return call(SYS_link, a_file, a_new_file); }, true},
        {"unlink", [] { return call(SYS_unlink, "victim"); }, true},
        {"rename", [] { return call(SYS_rename, "victim", a_new_file); }, true},
        {"chmod", [] { return call(SYS_chmod, "victim", 0777); }},
        {"vfork", [] { return call(SYS_vfork); }},
        {name_of_32_bit_call, get_pid_in_32_bits},
#else  // the kernel of arm64 has only those that name a folder as well, and clone
        {"mkdir", [] { return call(SYS_mkdirat, AT_FDCWD, a_new_file, 0700); }, true},
        {"symlink", [] { return call(SYS_symlinkat, a_file, AT_FDCWD, a_new_file); }, true},
        {"link", [] { return call(SYS_linkat, AT_FDCWD, a_file, AT_FDCWD, a_new_file, 0); }, true},
        {"unlink", [] { return call(SYS_unlinkat, AT_FDCWD, "victim", 0); }, true},
        {"rename", [] { return call(SYS_renameat, AT_FDCWD, "victim", AT_FDCWD, a_new_file); },
         true},
        {"chmod", [] { return call(SYS_fchmodat, AT_FDCWD, "victim", 0777); }},
#endif
        {"truncate", [] { return call(SYS_truncate, "victim", 0); }},
        {"stat",
         [] {
             struct stat found {};
             return call(SYS_newfstatat, AT_FDCWD, a_file, &found, 0);
         }},
        {"socket", [] { return call(SYS_socket, AF_INET, SOCK_STREAM, 0); }},
        {"unix socket", [] { return call(SYS_socket, AF_UNIX, SOCK_STREAM, 0); }},
        {"netlink", [] { return call(SYS_socket, AF_NETLINK, SOCK_RAW, 0); }},
        {"fork", start_process},
        {"exec", run_program, true},
        {"memory with code", make_code},
        {"data made code", make_data_code},
        {"kill", [] { return call(SYS_kill, getppid(), 0); }},
        {"ptrace", [] { return call(SYS_ptrace, PTRACE_TRACEME, 0, anywhere, anywhere); }},
        {"read another's memory",
         [] { return call(SYS_process_vm_readv, getppid(), anywhere, 0, anywhere, 0, 0); }},
        {"ioctl", [] { return call(SYS_ioctl, 0, FIONREAD, anywhere); }},
        {"prctl", [] { return call(SYS_prctl, PR_SET_DUMPABLE, 1, 0, 0, 0); }},
        {"raise limits",
         [] {
             rlimit limit{};
             return call(SYS_prlimit64, 0, RLIMIT_CPU, anywhere, &limit);
         }},
        {"bpf", [] { return call(SYS_bpf, 0, anywhere, 0); }},
        {"perf", [] { return call(SYS_perf_event_open, anywhere, 0, -1, -1, 0); }},
        {"io_uring", [] { return call(SYS_io_uring_setup, 1, anywhere); }},
        {"userfaultfd", [] { return call(SYS_userfaultfd, 0); }},
        {"memfd", [] { return call(SYS_memfd_create, "x", 0); }},
        {"mount", [] { return call(SYS_mount, "none", ".", "tmpfs", 0, anywhere); }},
        {"unshare", [] { return call(SYS_unshare, CLONE_NEWUSER); }},
        {"personality", [] { return call(SYS_personality, 0); }},
        {"keyctl", [] { return call(SYS_keyctl, 0, 0, 0); }},
        {"inotify", [] { return call(SYS_inotify_init1, 0); }},
        {"priority", [] { return call(SYS_setpriority, PRIO_PROCESS, 0, 0); }},
        {"set time", [] { return call(SYS_settimeofday, anywhere, anywhere); }},
        {"duplicate", [] { return call(SYS_dup, 1); }},
    };
    return all;
}

int deadly_signal(const Act& act) {
#ifdef __x86_64__
    static const bool kernel_has_them = has_32_bit_calls();
    return act.name == name_of_32_bit_call && !kernel_has_them ? SIGSEGV : SIGSYS;
#else
    (void)act;
    return SIGSYS;
#endif
}

}  // namespace touchline
