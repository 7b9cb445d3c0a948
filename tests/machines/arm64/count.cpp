// A plugin of qemu's emulator of programs: the instructions of each call of one function, a line
// each in the emulator's log (-d plugin). Arguments: first=ADDRESS, where the function begins, and
// return=ADDRESS for each place where a caller goes on, hexadecimal, as the emulator has them.
// Counts blocks of instructions, which no branch leads into, so one thread must run alone.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <string>
#include <string_view>

// What of the emulator's interface is used here, version 1 of it (qemu 4.2 to 8.2): no package has
// its header. https://www.qemu.org/docs/master/devel/tcg-plugins.html
extern "C" {
struct qemu_plugin_tb;
using Translated = void (*)(std::uint64_t id, qemu_plugin_tb* block);
using Executed = void (*)(unsigned processor, void* data);
void qemu_plugin_register_vcpu_tb_trans_cb(std::uint64_t id, Translated);
void qemu_plugin_register_vcpu_tb_exec_cb(qemu_plugin_tb*, Executed, int registers, void* data);
void qemu_plugin_register_vcpu_tb_exec_inline(qemu_plugin_tb*, int operation, void* number,
                                              std::uint64_t summand);
std::size_t qemu_plugin_tb_n_insns(const qemu_plugin_tb*);
std::uint64_t qemu_plugin_tb_vaddr(const qemu_plugin_tb*);
void qemu_plugin_outs(const char* text);

[[gnu::visibility("default")]] int qemu_plugin_version = 1;
[[gnu::visibility("default")]] int qemu_plugin_install(std::uint64_t id, const void* emulator,
                                                       int count, char** arguments);
}

namespace {

constexpr int no_registers = 0;
constexpr int add = 0;

std::uint64_t first = 0;
std::set<std::uint64_t> returns;
std::uint64_t executed = 0;  // of all blocks
std::uint64_t at_first = 0;  // `executed` where the function began
bool is_within = false;

void begin(unsigned /*processor*/, void* /*data*/) {
    at_first = executed;
    is_within = true;
}

void end(unsigned /*processor*/, void* /*data*/) {
    if (!is_within) return;
    is_within = false;
    qemu_plugin_outs((std::to_string(executed - at_first) + "\n").c_str());
}

/// What a block does before its instructions are added.
void translated(std::uint64_t /*id*/, qemu_plugin_tb* block) {
    const std::uint64_t address = qemu_plugin_tb_vaddr(block);
    if (address == first) {
        qemu_plugin_register_vcpu_tb_exec_cb(block, begin, no_registers, nullptr);
    } else if (returns.contains(address)) {
        qemu_plugin_register_vcpu_tb_exec_cb(block, end, no_registers, nullptr);
    }
    qemu_plugin_register_vcpu_tb_exec_inline(block, add, &executed, qemu_plugin_tb_n_insns(block));
}

}  // namespace

int qemu_plugin_install(std::uint64_t id, const void* /*emulator*/, int count, char** arguments) {
    for (int i = 0; i < count; ++i) {
        const std::string word = arguments[i];
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos) return -1;
        const std::uint64_t address = std::strtoull(word.c_str() + equals + 1, nullptr, 16);
        if (word.starts_with("first=")) first = address;
        if (word.starts_with("return=")) returns.insert(address);
    }
    if (first == 0 || returns.empty()) return -1;
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    return 0;
}
