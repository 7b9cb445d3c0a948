# A virtual machine with this machine's own files, read-only under a layer of memory, and one
# emulated USB device on its controller by usbredir. Sourced by tests/machines/system/*/run, after
# app/setup.sh; needs no KVM.

work=$root/build/system

# make_guest SCRIPT MODULE...: kernel and memory disk; SCRIPT runs in the guest as root.
make_guest() {
    local script=$1 package disk=$work/disk count=10 module file
    shift
    mkdir -p "$work"
    # The kernel is only unpacked, not installed.
    package=$(apt-cache depends linux-image-amd64 | awk '/Depends:/ { print $2; exit }')
    version=${package#linux-image-}
    if [[ ! -e $work/kernel/boot/vmlinuz-$version ]]; then
        (cd "$work" && apt-get download "$package" >/dev/null) || stop 'the kernel package cannot be fetched'
        rm -rf "$work/kernel"
        dpkg-deb -x "$work/$package"_*.deb "$work/kernel"
        rm "$work/$package"_*.deb
        depmod -b "$work/kernel" "$version"
    fi
    # Busybox, the modules on the way to the host's files and to the device, our scripts.
    rm -rf "$disk"
    mkdir -p "$disk"/{bin,modules,proc,sys,dev,host,layer,whole}
    cp /bin/busybox "$disk/bin/busybox"
    ln -s busybox "$disk/bin/sh"
    install -m 755 "$root/tests/machines/system/init" "$disk/init"
    cp "$script" "$disk/guest"
    for module in virtio_pci 9p 9pnet_virtio overlay xhci_pci "$@"; do
        modprobe -d "$work/kernel" -S "$version" --show-depends "$module" | awk '/^insmod/ { print $2 }'
    done | awk '!seen[$0]++' | while read -r file; do
        cp "$file" "$disk/modules/$count-$(basename "$file")"
        count=$((count + 1))
    done
    (cd "$disk" && find . | cpio -o -H newc --quiet) >"$work/disk.cpio"
}

# run_guest LONGEST_S DEVICE [ARGUMENT...]: gives the program DEVICE a socket and the arguments, and
# runs the guest to its end. Sets `status` to the exit status of the device's program. Prints what
# both said.
run_guest() {
    local longest_s=$1 device
    rm -f "$work/socket"
    "$2" "$work/socket" "${@:3}" >"$work/device.txt" &
    device=$!
    for _ in $(seq 600); do [[ -S $work/socket ]] && break; sleep 0.1; done
    timeout "$longest_s" qemu-system-x86_64 -M q35,usb=off -accel tcg,thread=multi \
        -cpu Haswell-noTSX,-pcid,-invpcid,-tsc-deadline,-x2apic -smp 2 -m 1G \
        -nodefaults -no-reboot -display none -kernel "$work/kernel/boot/vmlinuz-$version" -initrd "$work/disk.cpio" \
        -append 'console=ttyS0 loglevel=6 panic=-1 mitigations=off nokaslr no_timer_check tsc=reliable random.trust_cpu=on' \
        -serial "file:$work/console.txt" -serial "file:$work/guest.txt" -device virtio-rng-pci \
        -fsdev local,id=host,path=/,security_model=none,readonly=on,multidevs=remap \
        -device virtio-9p-pci,fsdev=host,mount_tag=host -device qemu-xhci,id=xhci,p2=4,p3=4 \
        -chardev "socket,id=device,path=$work/socket,reconnect=1" -device usb-redir,chardev=device,bus=xhci.0 \
        >"$work/qemu.txt" 2>&1 || say "the guest did not end by itself within $longest_s s"
    status=0
    wait "$device" || status=$?
    tr -d '\r' <"$work/guest.txt"
    sed 's/^/the device: /' "$work/device.txt"
}

# guest_is_well: whether its script ended with 0.
guest_is_well() { grep -q '^status 0' "$work/guest.txt"; }
