#!/usr/bin/env python3
"""The tables and split constants of the elementary functions, from multiple precision.

    pip install mpmath numpy
    python3 dsl/coefficients/tables.py dsl/src/math/tables

A polynomial goes through its function at the Chebyshev points of its interval, which is within a
few percent of the best there is. Where a table leaves so little that the Taylor series will do, the
Rust has its coefficients as quotients of integers.
"""

import contextlib
import pathlib
import struct
import sys

import numpy
from mpmath import asin, atan, cos, exp, expm1, floor, log, lu_solve, matrix, mp, mpf, nint, pi, sin
from mpmath import sinh, sqrt, tan, tanh

mp.prec = 3000


def double(value):
    """The double nearest to a value, as an mpf."""
    return mpf(float(value)) if abs(value) < 1e-300 else mpf(rounded(value, 53))


def rounded(value, bits):
    """A value rounded to so many significant bits."""
    if value == 0:
        return mpf(0)
    scale = mpf(2) ** (bits - 1 - int(floor(log(abs(value), 2))))
    return nint(value * scale) / scale


def cut(value, bits):
    """A value cut off to so many significant bits, towards zero."""
    scale = mpf(2) ** (bits - 1 - int(floor(log(abs(value), 2))))
    return floor(value * scale) / scale


def grid(value, power):
    """The multiple of 2^power nearest to a value."""
    return nint(value / mpf(2) ** power) * mpf(2) ** power


def literal(value):
    text = repr(float(value))
    return text.replace("e-0", "e-") if "e" in text else text


def bits(value):
    """The bits of the double nearest to a value."""
    return struct.unpack("<Q", struct.pack("<d", float(value)))[0]


def constant(name, value, text):
    print(f"/// {text}\npub const {name}: f64 = {literal(value)};")


def table(name, values, text, ty="f64"):
    print(f"/// {text}\npub const {name}: [{ty}; {len(values)}] = [")
    for value in values:
        print(f"    {literal(value) if ty == 'f64' else f'0x{value:016x}'},")
    print("];")


def pair(name, value, text):
    constant(f"{name}_HIGH", double(value), f"{text}, to a double.")
    constant(f"{name}_LOW", double(value - double(value)), f"{text}, less its high part.")


def pairs(name, values, text):
    table(f"{name}_HIGH", [double(v) for v in values], f"{text}, to a double.")
    table(f"{name}_LOW", [double(v - double(v)) for v in values], f"{text}, less the high parts.")


def module(name, title):
    """From here on, what is printed goes into this module."""
    file = (pathlib.Path(sys.argv[1]) / f"{name}.rs").open("w", encoding="utf-8")
    files.enter_context(file)
    files.enter_context(contextlib.redirect_stdout(file))
    print(f"//! {title}")
    print("//!")
    print("//! Written by `dsl/coefficients/tables.py`: change that.")
    print()


def rows(name, values, text, ty="f64"):
    """A table of tuples."""
    print(f"/// {text}\npub const {name}: [[{ty}; {len(values[0])}]; {len(values)}] = [")
    for row in values:
        items = ", ".join(literal(v) if ty == "f64" else f"0x{v:016x}" for v in row)
        print(f"    [{items}],")
    print("];")


def polynomial(name, function, count, low, high, text):
    """Coefficients of the polynomial through a function at the Chebyshev points, ascending."""
    low, high = mpf(low), mpf(high)
    mp.prec, before = 400, mp.prec
    nodes = [(low + high) / 2 + (high - low) / 2 * cos(pi * (2 * k + 1) / (2 * count)) for k in range(count)]
    system = matrix(count, count)
    values = matrix(count, 1)
    for row, node in enumerate(nodes):
        values[row] = function(node)
        for power in range(count):
            system[row, power] = node**power
    table(name, [double(c) for c in lu_solve(system, values)], text)
    mp.prec = before


def odd(function):
    """z ↦ (f(x)/x − 1)/z with x = √z: what an odd function f leaves beside x, over x³."""
    return lambda z: (function(sqrt(z)) / sqrt(z) - 1) / z


def reciprocals(function, unit):
    """128 rows (c, f(1/c)), row j for mantissas near 1 + j/128, halved from the 53rd on so that 1 is
    in the middle; c has 32 bits, and is chosen so that f(1/c) is next to a multiple of `unit`."""
    mp.prec, before = 150, mp.prec
    table = []
    for j in range(128):
        middle = 1 + (mpf(j) + mpf(1) / 2) / 128
        if j >= 53:
            middle /= 2
        if j in (0, 127):
            table.append((mpf(1), mpf(0)))
            continue
        centre = rounded(1 / middle, 32)
        step = mpf(2) ** (-31 if centre >= 1 else -32)
        # Candidates within 2⁻¹¹ of it: by the series of the logarithm, in units, modulo one.
        step = mpf(2) ** (-31 if centre >= 1 else -32)
        scale = -function(mp.e) / unit
        x = numpy.arange(-(2**20), 2**20, dtype=float)
        first, second, third, fourth = (
            float((scale * (step / centre) ** n / n * (-1) ** (n + 1)) % 1 if n == 1 else
                  scale * (step / centre) ** n / n * (-1) ** (n + 1)) for n in (1, 2, 3, 4))
        start = float((function(1 / centre) / unit) % 1)
        value = start + x * first + x * x * (second + x * (third + x * fourth))
        away = numpy.abs(value - numpy.round(value))
        near = numpy.argsort(away)[:20]
        def rest(c):
            exact = function(1 / c) / unit
            return abs(exact - nint(exact))
        chosen = min((centre + step * int(x[k]) for k in near), key=rest)
        table.append((chosen, nint(function(1 / chosen) / unit) * unit))
    mp.prec = before
    return table


files = contextlib.ExitStack()
module("angles", "π and its parts, sines, tangents and arctangents.")
quarter = pi / 2
first = cut(quarter, 33)
second = cut(quarter - first, 33)
third = cut(quarter - first - second, 33)
constant("QUARTER_TURN_1", first, "The leading 33 bits of π/2: a multiple of it by up to 2²⁰ is exact.")
constant("QUARTER_TURN_2", second, "The next 33 bits of π/2.")
constant("QUARTER_TURN_3", third, "The next 33 bits of π/2.")
constant("QUARTER_TURN_4", double(quarter - first - second - third), "The rest of π/2.")
constant("QUARTER_TURN_REST", double(quarter - first), "π/2 less its leading 33 bits.")
constant("STEPS_PER_RADIAN", double(64 / pi), "64/π.")
constant("STEP_HIGH", first / 32, "The leading 33 bits of π/64: a multiple of it by up to 2²⁰ is exact.")
constant("STEP_LOW", double((quarter - first) / 32), "The rest of π/64.")
pair("HALF_PI", pi / 2, "π/2")
pair("WHOLE_PI", pi, "π")

bits_of_quotient = int(floor(2 / pi * mpf(2) ** (35 * 64)))
words = [0] + [(bits_of_quotient >> (64 * (34 - i))) & (2**64 - 1) for i in range(35)]
table("TWO_OVER_PI", words, "The bits of 2/π after 64 zeros, most significant first.", "u64")


def split(value):
    return double(value), double(value - double(value))


def exact(value):
    """Zero where the working precision leaves a trace of it."""
    return mpf(0) if abs(value) < mpf(10) ** -100 else value


rows("SINES", [split(exact(sin(k * pi / 64))) for k in range(128)], "sin(k·π/64), to a double and less that.")
rows("TANGENTS", [split(exact(tan(k * pi / 64))) if k != 32 else (mpf(0), mpf(0)) for k in range(64)],
     "tan(k·π/64), to a double and less that; at its pole 0.")
polynomial("SINE", odd(sin), 5, 0, (mpf("5.6") * pi / 64) ** 2, "(sin x − x)/x³ in powers of x², to 0.27.")
polynomial("TANGENT", odd(tan), 8, 0, (mpf("4.6") * pi / 64) ** 2, "(tan x − x)/x³ in powers of x², to 0.22.")
polynomial("SINE_F32", odd(sin), 4, 0, mpf("0.79") ** 2, "(sin x − x)/x³ in powers of x², to π/4, for single precision.")
polynomial("COSINE_F32", lambda z: ((cos(sqrt(z)) - 1) / z + mpf(1) / 2) / z, 3, 0, mpf("0.79") ** 2,
           "(cos x − 1 + x²/2)/x⁴ in powers of x², to π/4, for single precision.")

# Row j is for numbers whose exponent and first three binary digits are those of j/8 counted from 1/16.
centres = []
for j in range(64):
    octave, eighth = divmod(j, 8)
    centres.append(mpf(2) ** (octave - 4) * (1 + (mpf(eighth) + mpf(1) / 2) / 8))
rows("ARCTANGENTS", [(c, *split(atan(c))) for c in centres],
     "c and atan c, to a double and less that: eight c for each octave from 1/16 to 16.")
polynomial("ARCTANGENT", odd(atan), 6, 0, mpf(1) / 256, "(atan x − x)/x³ in powers of x², to 1/16.")
polynomial("ARCSINE", odd(asin), 13, 0, mpf(1) / 4, "(asin x − x)/x³ in powers of x², to 1/2.")
polynomial("ARCSINE_F32", odd(asin), 6, 0, mpf(1) / 4, "(asin x − x)/x³ in powers of x², to 1/2, for single precision.")

module("powers", "Powers of two and hyperbolic functions.")
two = log(mpf(2))
steps = [mpf(2) ** (mpf(k) / 128) for k in range(128)]
constant("STEPS_PER_UNIT", double(128 / two), "128/ln 2.")
constant("UNIT_STEP_HIGH", cut(two / 128, 36), "The leading 36 bits of (ln 2)/128: a multiple by up to 2¹⁷ is exact.")
constant("UNIT_STEP_LOW", double(two / 128 - cut(two / 128, 36)), "The rest of (ln 2)/128.")
rows("POWERS", [(bits((v - double(v)) / v), (bits(double(v)) - (k << 45)) % 2**64) for k, v in enumerate(steps)],
     "2^(k/128): what the double leaves out, as a fraction; its bits less k·2⁴⁵.", "u64")
table("POWERS_F32", [(bits(double(steps[4 * k])) - (k << 47)) % 2**64 for k in range(32)],
      "The bits of 2^(k/32) less k·2⁴⁷.", "u64")
constant("STEPS_PER_UNIT_F32", double(32 / two), "32/ln 2.")
polynomial("EXPONENTIAL_F32", lambda r: expm1(r * two / 32) / r, 3, mpf(-1) / 2, mpf(1) / 2,
           "(2^(r/32) − 1)/r in powers of r, −1/2 to 1/2.")
polynomial("EXP_M1", lambda x: (exp(x) - 1 - x - x * x / 2) / x**3, 11, mpf("-0.30"), mpf("0.3000001"),
           "(e^x − 1 − x − x²/2)/x³ in powers of x, −0.3 to 0.3.")
polynomial("SINH", odd(sinh), 5, 0, mpf("0.31") ** 2, "(sinh x − x)/x³ in powers of x², to 0.3.")
rows("TANHS", [split(tanh((k + mpf(1) / 2) / 16)) for k in range(64)],
     "tanh((k + 1/2)/16), to a double and less that.")
polynomial("TANH", odd(tanh), 8, 0, mpf("0.251") ** 2, "(tanh x − x)/x³ in powers of x², to 1/4.")

module("logarithms", "Logarithms.")
constant("LN_2_HIGH", grid(two, -42), "ln 2 to a multiple of 2⁻⁴².")
constant("LN_2_LOW", double(two - grid(two, -42)), "ln 2 less its high part.")
constant("LOG10_2_HIGH", grid(two / log(mpf(10)), -42), "log₁₀ 2 to a multiple of 2⁻⁴².")
constant("LOG10_2_LOW", double(two / log(mpf(10)) - grid(two / log(mpf(10)), -42)), "log₁₀ 2 less its high part.")
for base, unit in (("2", two), ("10", log(mpf(10)))):
    constant(f"RECIPROCAL_LN_{base}_HIGH", rounded(1 / unit, 31), f"1/ln {base}, to 31 bits.")
    constant(f"RECIPROCAL_LN_{base}_LOW", double(1 / unit - rounded(1 / unit, 31)), f"1/ln {base}, less its high part.")
about = "c near the reciprocal of a mantissa, and minus the logarithm of c,"
rows("LN_ROWS", reciprocals(log, mpf(2) ** -43), f"{about} natural.")
rows("LOG2_ROWS", reciprocals(lambda x: log(x) / two, mpf(2) ** -42), f"{about} to base 2.")
rows("LOG10_ROWS", reciprocals(lambda x: log(x) / log(mpf(10)), mpf(2) ** -43), f"{about} to base 10.")
polynomial("LN", lambda r: (log(1 + r) - r + r * r / 2) / r**3, 5, mpf(-1) / 200, mpf(1) / 128,
           "(ln(1 + r) − r + r²/2)/r³ in powers of r.")

module("finer", "Logarithms for powers and for single precision, cube roots.")
# The same rows with c of 12 bits at most.
coarse = []
for j in range(128):
    middle = (1 + (mpf(j) + mpf(1) / 2) / 128) / (2 if j >= 53 else 1)
    coarse.append(mpf(1) if j in (0, 127) else grid(1 / middle, -11))
logarithms = [-log(c) for c in coarse]
rows("COARSE_ROWS", [(c, grid(v, -42)) for c, v in zip(coarse, logarithms)],
     "c near the reciprocal of a mantissa, a multiple of 2⁻¹¹, and minus its ln to multiples of 2⁻⁴².")
table("COARSE_REST", [double(v - grid(v, -42)) for v in logarithms], "Minus ln of the first of `COARSE_ROWS`, less the second.")

# 32 rows for single precision: the first bits of a mantissa from 0.703 to 1.406.
single = []
for j in range(32):
    middle = 1 + (mpf(j) + mpf(1) / 2) / 32
    if j >= 13:
        middle /= 2
    single.append(mpf(1) if j in (0, 31) else double(1 / middle))
rows("LOG2_ROWS_F32", [(c, double(-log(c) / two)) for c in single],
     "c near the reciprocal of a mantissa, and minus its logarithm to base 2, for single precision.")
polynomial("LOG2_F32", lambda r: log(1 + r) / two / r if r else 1 / two, 5, mpf(-1) / 60, mpf(1) / 32,
           "log₂(1 + r)/r in powers of r.")
polynomial("FINER_LOG2_F32", lambda r: log(1 + r) / two / r if r else 1 / two, 7, mpf(-1) / 60, mpf(1) / 32,
           "The same, finer.")

polynomial("CUBE_ROOT", lambda r: r ** (-mpf(1) / 3), 5, mpf("0.90"), mpf("1.11"), "r^(−1/3) in powers of r, 0.9 to 1.1.")
polynomial("CUBE_ROOT_F32", lambda r: r ** (-mpf(1) / 3), 7, mpf("0.90"), mpf("1.11"), "The same, finer.")
files.close()
