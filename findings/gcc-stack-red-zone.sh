#!/usr/bin/env bash
# gcc 12.2 for x86-64: `-fstack-usage` does not count the red zone; a function with an array of 96 bytes uses "8 bytes".
#
# Guessed: the size that `-fstack-usage` writes is at least that of the arrays that a function keeps on the stack.
# Seen:    a function that calls no other keeps up to 128 bytes below the stack pointer, and the file of sizes has 8 for it, as for
#          a function without an array. With `-mno-red-zone` it has 112, as for a function that calls another.
# So:      add 128 bytes to a bound of the stack that is summed up from these files on x86-64, or compile with `-mno-red-zone`.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in cpp-12 gcc-12; do
    apt-get download --quiet=2 "$package=12.2.0-14+deb12u1" 2>/dev/null || apt-get download --quiet=2 "$package=12.2.0-14"
    dpkg-deb --extract "$package"_*.deb tools
done
cat > functions.c <<'C'
void other(volatile char *values);
int nothing(int x) { return x + 1; }
int leaf(int x)
{
    volatile char values[96];
    values[x] = 1;
    return values[x];
}
int caller(int x)
{
    volatile char values[96];
    other(values);
    return values[x];
}
C
sizes() {
    tools/usr/bin/gcc-12 -O2 "$@" -fstack-usage -S functions.c -o functions.s
    cut -f 1,2 functions.su | sed -E "s/^.*:([a-z]+)\t/${*:-default}, \1: /"
}
{
    tools/usr/bin/gcc-12 --version | head -n 1
    sizes
    sizes -mno-red-zone
} | tee printed
grep -qx 'default, nothing: 8' printed
grep -qx 'default, leaf: 8' printed
grep -qx 'default, caller: 112' printed
grep -qx -- '-mno-red-zone, leaf: 1[0-9][0-9]' printed
