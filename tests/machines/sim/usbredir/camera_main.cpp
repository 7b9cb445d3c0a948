// redirected_camera SOCKET [UNPLUG_AFTER_STARTS]: an emulated USB camera for QEMU's usb-redir
// device, which connects to the unix socket. After that many starts of the stream the plug is
// pulled, once, and put back when QEMU connects again. Ends when QEMU has gone; prints what it was
// asked for.
#include "tests/machines/sim/usbredir/uvc_camera.h"

#include <cstdio>
#include <cstdlib>

#include <sys/socket.h>

int main(int argc, char** argv) {
    if (argc < 2 || argc > 3) {
        std::fputs("usage: redirected_camera SOCKET [UNPLUG_AFTER_STARTS]\n", stderr);
        return 2;
    }
    const int listener = touchline::listen_at(argv[1]);
    if (listener < 0) {
        std::perror("redirected_camera");
        return 1;
    }
    int unplug_after = argc > 2 ? std::atoi(argv[2]) : 0;
    for (;;) {
        touchline::UvcCamera camera(unplug_after);
        touchline::RedirectedDevice(camera, accept(listener, nullptr, nullptr)).serve();
        std::printf("the stream was started %d times, exposure held %d times%s\n", camera.starts(),
                    camera.exposure_holds(), camera.is_plugged() ? "" : "; unplugged");
        if (camera.is_plugged()) return 0;
        unplug_after = 0;
    }
}
