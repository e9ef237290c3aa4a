#!/usr/bin/env bash
# Counts the instructions of each block under QEMU, and writes them to costs.tsv: the most of any call of `verify`, with random
# inputs, for both processors. Needs `cargo bessemer`, gcc for ARM and QEMU (`cargo xtask test --install`).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
counts() {
    cargo bessemer verify --target "$1" | sed -n 's/^  \([A-Za-z]*::[a-z0-9_]*\)  *\([0-9][0-9]*\) .*$/\1\t\2/p'
}
join -t "$(printf '\t')" <(counts cortex-m4f | sort) <(counts cortex-a9 | sort) > costs.tsv.new
mv costs.tsv.new costs.tsv
