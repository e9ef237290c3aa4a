#!/usr/bin/env bash
# gcc 12.2 for s390x: `-std=c99` makes `float` expressions be evaluated as `double`, though the processor has `float`.
#
# Guessed: as on ARM, RISC-V and x86-64, `-std=c99` changes no arithmetic: FLT_EVAL_METHOD is 0 with and without it.
# Seen:    it is 1 with `-std=c99` and 0 with `-std=gnu99` or `-std=c99 -fexcess-precision=fast`.
# So:      build files that say `-std=c99` for strictness change the bits of `float` on this one target.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download --quiet=2 cpp-12-s390x-linux-gnu=12.2.0-14cross1 2>&1 | grep -v unsandboxed || true
dpkg-deb --extract cpp-12-s390x-linux-gnu_*.deb tools
cpp=tools/usr/bin/s390x-linux-gnu-cpp-12
method() { echo "$*: $("$cpp" "$@" -dM /dev/null | sed -n 's/#define __FLT_EVAL_METHOD__ //p')"; }
{
    "$cpp" --version | head -n 1
    method -std=c99
    method -std=gnu99
    method -std=c99 -fexcess-precision=fast
} | tee printed
grep -q '^-std=c99: 1$' printed
grep -q '^-std=gnu99: 0$' printed
grep -q 'precision=fast: 0$' printed
