#!/usr/bin/env bash
# newlib 3.3 of Debian for Cortex-M and Cortex-A: `memmove` to a higher address that overlaps copies byte by byte.
#
# Guessed: `memmove` takes about as long as `memcpy`, since both ends of an array of words are aligned: 296 bytes in some 180 instructions.
# Seen:    the loop that runs from the end has one byte a pass and four instructions, with any alignment: 296 bytes take 1,190. The one that
#          runs from the beginning has words. There is no load of a word with a negative step in the function.
# So:      a history that is shifted up by one element, as filters have, takes seven times what it takes if it is shifted down. A ring costs less.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libnewlib-arm-none-eabi=3.3.0-1.3+deb12u1 libnewlib-dev=3.3.0-1.3+deb12u1 binutils-arm-none-eabi; do
    apt-get download --quiet=2 "$package" 2>/dev/null || apt-get download --quiet=2 "$package"
done
for package in *.deb; do dpkg-deb --extract "$package" "$folder/tools"; done
for variant in thumb/v7e-m+fp/hard thumb/v7-a+fp/hard; do
    library=$(find tools -path "*/newlib/$variant/libc.a")
    tools/usr/bin/arm-none-eabi-ar p "$library" lib_a-memmove.o > memmove.o
    tools/usr/bin/arm-none-eabi-objdump --disassemble=memmove --no-show-raw-insn memmove.o > memmove.txt
    bytes=$(grep -cE 'ldrb.*\[[a-z0-9]+, #-1\]!' memmove.txt || true)
    back=$(grep -cE 'ldr(\.w)?[[:space:]].*#-4\]!|ldmdb' memmove.txt || true)
    ahead=$(grep -cE 'ldr(\.w)?[[:space:]]|ldmia' memmove.txt || true)
    printf '%s: from the end %s loads of bytes, %s of words; all loads of words: %s\n' "$variant" "$bytes" "$back" "$ahead"
    awk '/ldrb.*#-1\]!/ { n = 4 } n-- > 0' memmove.txt
done | tee printed
test "$(grep -c 'from the end 1 loads of bytes, 0 of words' printed)" = 2
