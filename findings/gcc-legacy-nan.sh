#!/usr/bin/env bash
# gcc 12.2 for MIPS and PA-RISC: the quiet NaN is 0x7ff7ffffffffffff; 0x7ff8000000000000 signals.
#
# Guessed: since IEEE 754-2008 the first bit of the fraction is set in a quiet NaN, so NAN has the bits 0x7ff8000000000000.
# Seen:    on these two processors it is clear, by the convention of before 2008; PowerPC has the usual bits.
# So:      bits of a NaN in a file or message mean another NaN there: compare by `x != x`, never by bits.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
echo 'const double QUIET = __builtin_nan("");' > nan.c
bits() {
    apt-get download --quiet=2 "cpp-12-$1=$2" 2>&1 | grep -v unsandboxed || true
    dpkg-deb --extract "cpp-12-$1"_*.deb tools
    local words
    words=$(tools/usr/lib/gcc-cross/"$1"/12/cc1 -quiet nan.c -o - \
        | sed -nE 's/^\t\.(4byte|word|long|quad)\t(0x[0-9a-f]+|-?[0-9]+)$/\2/p')
    printf '%s:' "$1"
    for word in $words; do printf ' %x' "$((word & 0xffffffff))"; done
    printf '\n'
}
{
    echo "gcc 12.2.0"
    bits mips-linux-gnu 12.2.0-14cross5
    bits hppa-linux-gnu 12.2.0-13cross1
    bits powerpc-linux-gnu 12.2.0-13cross1
} | tee printed
grep -q '^mips-linux-gnu: 7ff7ffff ffffffff$' printed
grep -q '^hppa-linux-gnu: 7ff7ffff ffffffff$' printed
grep -q '^powerpc-linux-gnu: 7ff80000 0$' printed
