#!/usr/bin/env bash
# gcc 12.2: `-ffp-contract=off` does not keep gcc from fusing products and sums in vectors of its own making.
#
# Guessed: with `-std=c99 -ffp-contract=off` no product is fused with a sum; each rounds by itself.
# Seen:    a complex product, compiled for a processor with FMA, contains `vfmaddsub`; with a pragma against vectors of
#          straight-line code it does not.
# So:      bits that must be the same everywhere need that pragma (or `-fno-tree-slp-vectorize`) with gcc 12.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in cpp-12 gcc-12; do
    apt-get download --quiet=2 "$package=12.2.0-14+deb12u1" 2>/dev/null || apt-get download --quiet=2 "$package=12.2.0-14"
    dpkg-deb --extract "$package"_*.deb tools
done
gcc=tools/usr/bin/gcc-12
cat >complex.c <<'C'
typedef struct { double re, im; } complex_t;
void product(complex_t *out, const complex_t *a, const complex_t *b)
{
    const double re = a->re * b->re - a->im * b->im;
    const double im = a->re * b->im + a->im * b->re;
    out->re = re;
    out->im = im;
}
C
flags=(-std=c99 -O2 -ffp-contract=off -march=x86-64-v3 -S -o -)
{
    "$gcc" --version | head -n 1
    echo "fused instructions:               $("$gcc" "${flags[@]}" complex.c | grep -c 'vfn\?m' || true)"
    echo "with -fno-tree-slp-vectorize:     $("$gcc" "${flags[@]}" -fno-tree-slp-vectorize complex.c | grep -c 'vfn\?m' || true)"
} | tee printed
grep -q 'fused instructions: *[1-9]' printed
grep -q 'vectorize: *0$' printed
