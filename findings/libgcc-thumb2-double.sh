#!/usr/bin/env bash
# libgcc of arm-none-eabi-gcc 12.2: double addition in software rounds one sum wrongly on ARMv7-M, and rightly on ARMv6-M.
#
# Guessed: a double in software is the double of IEEE 754: each operation gives the nearest one, on every processor.
# Seen:    0xC1367383709435B6 + 0x4340000000000000 gives 0x433FFFFFFFE98C7C with the library for a Cortex-M3 or M4 (written in
#          assembly) and 0x433FFFFFFFE98C7D, which is the nearest, with the library for a Cortex-M0 (written in C).
# So:      a program with doubles does not have the same bits on a Cortex-M4F as elsewhere, whatever its source does.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in gcc-arm-none-eabi=15:12.2.rel1-1 binutils-arm-none-eabi qemu-user-static; do
    apt-get download --quiet=2 "$package" 2>&1 | grep -v unsandboxed || true
done
for package in *.deb; do dpkg-deb --extract "$package" tools; done
cat >sum.c <<'C'
#include <stdint.h>
static volatile union { uint64_t word; double value; } a = { UINT64_C(0xC1367383709435B6) },
    b = { UINT64_C(0x4340000000000000) }, sum;
static int system_call(int number, int first, const void *second, int third)
{
    register int r7 __asm__("r7") = number;
    register int r0 __asm__("r0") = first;
    register const void *r1 __asm__("r1") = second;
    register int r2 __asm__("r2") = third;
    __asm__ volatile("svc 0" : "+r"(r0) : "r"(r7), "r"(r1), "r"(r2) : "memory");
    return r0;
}
void begin(void)
{
    char text[17];
    sum.value = a.value + b.value;
    for (int i = 0; i < 16; i++) {
        text[i] = "0123456789ABCDEF"[(sum.word >> (60 - 4 * i)) & 15];
    }
    text[16] = '\n';
    system_call(4, 1, text, 17);
    system_call(1, 0, 0, 0);
}
C
gcc=tools/usr/bin/arm-none-eabi-gcc
emulator=tools/usr/bin/qemu-arm-static
{
    PATH=$folder/tools/usr/bin:$PATH "$gcc" --version | head -n 1
    for processor in cortex-m4 cortex-m3 cortex-m0; do
        PATH=$folder/tools/usr/bin:$PATH "$gcc" -mcpu=$processor -mthumb -mfloat-abi=soft -O2 -ffreestanding -nostdlib \
            -Wl,-e,begin -Wl,-Ttext=0x10000 sum.c -lgcc -o sum-$processor
        echo "$processor: $("$emulator" -cpu cortex-a9 sum-$processor)"
    done
} | tee printed
grep -q 'cortex-m4: 433FFFFFFFE98C7C' printed
grep -q 'cortex-m3: 433FFFFFFFE98C7C' printed
grep -q 'cortex-m0: 433FFFFFFFE98C7D' printed
