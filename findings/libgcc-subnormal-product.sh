#!/usr/bin/env bash
# libgcc of arm-none-eabi-gcc 12.2: a product of doubles in software takes eleven times as long if both numbers are subnormal.
#
# Guessed: on a processor without doubles each operation takes about the same time, since its shifts count leading zeros by one instruction.
# Seen:    sums do so. The product and the quotient shift a subnormal number by one place a pass: 1.5 * 1.5 takes 58 instructions,
#          1.5 * 2^-1074 takes 391, and 2^-1074 * 2^-1074, which is zero, takes 690, with its program of some ten.
# So:      a longest time that was measured with usual numbers does not hold: a filter that decays towards zero ends in subnormal ones.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in gcc-arm-none-eabi=15:12.2.rel1-1 binutils-arm-none-eabi qemu-user-static; do
    apt-get download --quiet=2 "$package" 2>/dev/null || apt-get download --quiet=2 "$package"
done
for package in *.deb; do dpkg-deb --extract "$package" tools; done
cat > product.c <<'C'
#include <stdint.h>
static volatile union { uint64_t word; double value; } a = { A }, b = { B }, result;
void begin(void)
{
    result.value = TERM;
    register int r7 __asm__("r7") = 1;
    register int r0 __asm__("r0") = 0;
    __asm__ volatile("svc 0" : : "r"(r7), "r"(r0) : "memory");
}
C
count() {
    PATH=$folder/tools/usr/bin:$PATH tools/usr/bin/arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfloat-abi=soft -O2 -ffreestanding -nostdlib \
        "-DA=UINT64_C($1)" "-DB=UINT64_C($2)" "-DTERM=$3" -Wl,-e,begin -Wl,-Ttext=0x10000 product.c -lgcc -o product
    tools/usr/bin/qemu-arm-static -cpu cortex-a9 -singlestep -d exec,nochain -D trace ./product
    grep -c '^Trace' trace
}
usual=0x3FF8000000000000 least=1
{
    PATH=$folder/tools/usr/bin:$PATH tools/usr/bin/arm-none-eabi-gcc --version | head -n 1
    for term in 'a.value * b.value' 'a.value / b.value' 'a.value + b.value'; do
        echo "$term: usual $(count $usual $usual "$term"), one subnormal $(count $usual $least "$term"), both $(count $least $least "$term")"
    done
} | tee printed
awk -F'[:,]' '/\*/ { split($2, u, " "); split($3, o, " "); split($4, t, " "); exit !(o[3] > 4 * u[2] && t[2] > 8 * u[2]) }' printed
