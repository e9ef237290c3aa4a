#!/usr/bin/env bash
# gcov 12.2: `a < b ? a : b` of integers has no branch, even without optimisation, and counts as covered after one side.
#
# Guessed: at `-O0` each `?:` is a branch, so a test that takes one side only leaves the other "never executed".
# Seen:    gcc makes a minimum, an absolute value and a comparison of integers before it inserts the counters: gcov reports no branch
#          for them. The same minimum of doubles, and the same choice by `if`, have two each, of which one was taken.
# So:      a branch coverage of 100 % by gcov does not show that both values of a conditional expression were tested.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in cpp-12 gcc-12 libgcc-12-dev; do
    apt-get download --quiet=2 "$package=12.2.0-14+deb12u1" 2>/dev/null || apt-get download --quiet=2 "$package=12.2.0-14"
    dpkg-deb --extract "$package"_*.deb tools
done
cat > choices.c <<'C'
static int least(int a, int b) { return a < b ? a : b; }
static int magnitude(int a) { return a < 0 ? -a : a; }
static int above(int a) { return a > 3 ? 1 : 0; }
static int least_by_if(int a, int b) { if (a < b) { return a; } return b; }
static double least_double(double a, double b) { return a < b ? a : b; }
int main(void)
{
    return least(1, 2) + magnitude(1) + above(1) + least_by_if(1, 2) + (int)least_double(1.0, 2.0) == 0;
}
C
tools/usr/bin/gcc-12 -O0 --coverage -c choices.c
tools/usr/bin/gcc-12 --coverage choices.o -o choices
./choices
tools/usr/bin/gcov-12 --branch-probabilities --branch-counts choices.c > /dev/null
{
    tools/usr/bin/gcov-12 --version | head -n 1
    awk -F: '/^branch/ { branches[name]++; if ($0 ~ /taken [1-9]/) taken[name]++; next }
        $3 ~ /^static/ { split($3, words, /[ (]/); name = words[3]; order[++count] = name }
        $3 !~ /^static/ && !/^function|^call/ { name = "" }
        END { for (i = 1; i <= count; i++)
            print order[i] ": " branches[order[i]] + 0 " branches, " taken[order[i]] + 0 " taken" }' choices.c.gcov
} | tee printed
grep -qx 'least: 0 branches, 0 taken' printed
grep -qx 'magnitude: 0 branches, 0 taken' printed
grep -qx 'above: 0 branches, 0 taken' printed
grep -qx 'least_by_if: 2 branches, 1 taken' printed
grep -qx 'least_double: 2 branches, 1 taken' printed
