# shellcheck shell=bash
# Sourced, after app/setup.sh. Runs programs of arm64, and judges. `out` is a folder for what is said.

export QEMU_LD_PREFIX=$root/build/arm64-root

# in_emulator COMMAND...: runs it where this kernel gives every program of arm64 to the emulator, so
# that programs which the tests start run too. That holds for this command alone; kernels before
# 6.7 know no such thing, so that there it must hold for the whole machine (qemu-user-static).
in_emulator() {
    local magic='\x7fELF\x02\x01\x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x02\x00\xb7\x00'
    local mask='\xff\xff\xff\xff\xff\xff\xff\x00\xff\xff\xff\xff\xff\xff\xff\xff\xfe\xff\xff\xff'
    ! starts_foreign_programs || { "$@"; return; }
    unshare --user --map-root-user --mount bash -c '
        mount -t binfmt_misc binfmt_misc /proc/sys/fs/binfmt_misc
        printf %s ":arm64:M::$1:$2:$3:F" >/proc/sys/fs/binfmt_misc/register
        "${@:4}"' bash "$magic" "$mask" "$(command -v qemu-aarch64-static)" "$@"
}

starts_foreign_programs() { "$QEMU_LD_PREFIX/lib/ld-linux-aarch64.so.1" --version >/dev/null 2>&1; }

failed=0
judge() { # NAME COMMAND...
    local name=$1 start_s=$SECONDS
    shift
    if "$@" >"$out/log" 2>&1; then
        echo "passed: $name, $((SECONDS - start_s)) s"
    else
        echo "FAILED: $name"
        grep -aE '^\[  FAILED  \]' "$out/log" | sort -u || tail -n 20 "$out/log"
        failed=$((failed + 1))
    fi
}
