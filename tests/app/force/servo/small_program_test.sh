#!/usr/bin/env bash
# The servo is a small program: it links no OpenCV, no OpenGL and no reader of files.
set -euo pipefail
program=${1:?usage: small_program_test.sh PROGRAM}

strangers=$(readelf --dynamic "$program" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' |
    grep -vE '^(libusb-1\.0|libfmt|libstdc\+\+|libm|libgcc_s|libc|ld-linux.*|lib[at]san|libubsan|libgcov)\.so')|| true
[[ -z $strangers ]] || { printf 'the servo links %s\n' $strangers && exit 1; }
