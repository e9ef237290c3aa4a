#!/usr/bin/env bash
# cppcheck 2.10: a test that only NaN passes "is always false", and the last branch of a comparison that NaN reaches "always true".
#
# Guessed: a checker of C for embedded systems knows that neither `x < 1.0` nor `x >= 1.0` is true of NaN.
# Seen:    it warns that `!(x < 1.0) && !(x >= 1.0)` always evaluates to false, and that `x >= 1.0` is always true once `x < 1.0` was
#          false. Both programs answer otherwise for NaN. Of `x != x` it says nothing.
# So:      do not remove a guard against NaN because cppcheck calls it unreachable; write it as `x != x` or `isnan(x)`.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in cppcheck=2.10-2 libpcre3 libtinyxml2-9; do
    apt-get download --quiet=2 "$package" 2>&1 | grep -v unsandboxed || true
done
for package in *.deb; do dpkg-deb --extract "$package" tools; done
# cppcheck finds its configuration beside the program.
cp tools/usr/bin/cppcheck tools/usr/lib/x86_64-linux-gnu/cppcheck/
cat > guards.c <<'C'
int is_unordered(double x) { return !(x < 1.0) && !(x >= 1.0); }
int class_of(double x)
{
    if (x < 1.0) { return 0; }
    if (x >= 1.0) { return 1; }
    return 2;
}
int is_nan(double x) { return x != x; }
C
cat > main.c <<'C'
#include <stdio.h>
int is_unordered(double x);
int class_of(double x);
int is_nan(double x);
int main(void)
{
    const double nan = __builtin_nan("");
    printf("for NaN: is_unordered %d, class_of %d, is_nan %d\n", is_unordered(nan), class_of(nan), is_nan(nan));
    return 0;
}
C
cc -std=c99 guards.c main.c -o main
export LD_LIBRARY_PATH=$folder/tools/usr/lib/x86_64-linux-gnu:$folder/tools/lib/x86_64-linux-gnu
{
    tools/usr/lib/x86_64-linux-gnu/cppcheck/cppcheck --version
    ./main
    tools/usr/lib/x86_64-linux-gnu/cppcheck/cppcheck --quiet --std=c99 --enable=warning,style \
        --template='line {line}: {id}: {message}' --template-location='' guards.c 2>&1
} | tee printed
grep -qx 'for NaN: is_unordered 1, class_of 2, is_nan 1' printed
grep -q '^line 1: incorrectLogicOperator: .*always evaluates to false' printed
grep -q "^line 5: knownConditionTrueFalse: Condition 'x>=1.0' is always true" printed
if grep -q '^line 8:' printed; then exit 1; fi
