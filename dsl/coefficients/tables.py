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


def float_literal(value):
    """The shortest text of the float nearest to a value."""
    return str(numpy.float32(float(value))).replace("e-0", "e-")


def bits(value):
    """The bits of the double nearest to a value."""
    return struct.unpack("<Q", struct.pack("<d", float(value)))[0]


WORDS = {"f64": literal, "f32": float_literal, "u64": lambda it: f"0x{it:016x}", "u32": lambda it: f"0x{it:08x}"}


# The C has what is said of a constant that is marked.
MARK = "#[crate::data]\n"


def constant(name, value, text, ty="f64", shared=False):
    """A number; shared: several modules read it, and the C has it once."""
    seen = "pub" if shared else "pub(crate)"
    print(f"/// {text}\n{MARK}{seen} const {name}: {ty} = {WORDS[ty](value)};")


def table(name, values, text, ty="f64", shared=False):
    """A table; shared: several modules read it, and the C has it once."""
    seen = "pub" if shared else "pub(crate)"
    print(f"/// {text}\n{MARK}{seen} const {name}: [{ty}; {len(values)}] = [")
    for value in values:
        print(f"    {WORDS[ty](value)},")
    print("];")


def pair(name, value, text):
    constant(f"{name}_HIGH", double(value), f"{text}, to a double.", shared=True)
    constant(f"{name}_LOW", double(value - double(value)), f"{text}, minus its high part.", shared=True)


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


def rows(name, values, text, ty="f64", shared=False):
    """A table of tuples; shared: several modules read it, and the C has it once."""
    seen = "pub" if shared else "pub(crate)"
    print(f"/// {text}\n{MARK}{seen} const {name}: [[{ty}; {len(values[0])}]; {len(values)}] = [")
    for row in values:
        items = ", ".join(WORDS[ty](v) for v in row)
        print(f"    [{items}],")
    print("];")


def polynomial(name, function, count, low, high, text, ty="f64"):
    """Coefficients of the polynomial through a function at the Chebyshev points, ascending, and how far off they are."""
    low, high = mpf(low), mpf(high)
    mp.prec, before = 400, mp.prec
    nodes = [(low + high) / 2 + (high - low) / 2 * cos(pi * (2 * k + 1) / (2 * count)) for k in range(count)]
    system = matrix(count, count)
    values = matrix(count, 1)
    for row, node in enumerate(nodes):
        values[row] = function(node)
        for power in range(count):
            system[row, power] = node**power
    found = [double(c) if ty == "f64" else rounded(c, 24) for c in lu_solve(system, values)]
    points = [low + (high - low) * (2 * k + 1) / 1000 for k in range(500)]
    off = max(abs(function(x) - sum(c * x**power for power, c in enumerate(found))) for x in points)
    through = f"{text.rstrip('.')}. Interpolated at {count} Chebyshev points"
    table(name, found, f"{through}; the error is below 2{raised(int(floor(log(off, 2))) + 1)}.", ty)
    mp.prec = before


def raised(power):
    return str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def odd(function):
    """z ↦ (f(x)/x − 1)/z with x = √z: what an odd function f leaves beside x, over x³."""
    return lambda z: (function(sqrt(z)) / sqrt(z) - 1) / z


def cell(j):
    """The significands of row j of 128: rows follow the first seven bits from 1 + 52.5/128 halved on,
    so that 1 is in the middle of row 75."""
    return tuple((1 + t) / 2 if t < 1 else t for t in (mpf(105 + 2 * (j + end)) / 256 for end in (0, 1)))


def accurate_rows(function, unit):
    """128 rows (1/c, f(c), c), c of 33 bits near the middle of its row, and chosen so that f(c) is next
    to a multiple of `unit` (S. Gal's accurate tables) and 1/c next to a double."""
    mp.prec, before = 150, mp.prec
    scale = function(mp.e) / unit
    found = []
    for j in range(128):
        low, high = cell(j)
        if low < 1 < high:
            found.append((mpf(1), mpf(0), mpf(1)))
            continue
        middle = rounded((low + high) / 2, 33)
        step = mpf(2) ** (-33 if middle < 1 else -32)
        # Candidates within 2⁻¹² of it: by the series of the logarithm, in units, modulo one.
        x = numpy.arange(-(2**20), 2**20, dtype=float)
        first, second, third, fourth = (scale * (step / middle) ** n / n for n in (1, 2, 3, 4))
        start = (function(middle) / unit) % 1
        value = float(start) + x * float(first % 1) - x * x * (float(second) - x * (float(third) - x * float(fourth)))
        near = numpy.argsort(numpy.abs(value - numpy.round(value)))[:40]

        def rests(c):
            exact = function(c) / unit
            away = abs(exact - nint(exact))
            return (max(away, mpf(2) ** -18), abs(double(1 / c) * c - 1))

        chosen = min((middle + step * int(x[k]) for k in near), key=rests)
        found.append((double(1 / chosen), nint(function(chosen) / unit) * unit, chosen))
    mp.prec = before
    return found


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
constant("STEPS_PER_RADIAN", double(64 / pi), "64/π.", shared=True)
constant("STEP_HIGH", first / 32, "The leading 33 bits of π/64: a multiple of it by up to 2²⁰ is exact.",
         shared=True)
constant("STEP_LOW", double((quarter - first) / 32), "The rest of π/64.", shared=True)
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


rows("SINE_ROWS", [(*split(exact(sin(k * pi / 64))), double(exact(cos(k * pi / 64)))) for k in range(64)],
     "sin(k·π/64) to a double, the rounding error, and cos(k·π/64).")
rows("TANGENT_ROWS", [split(exact(tan(k * pi / 64))) if k != 32 else (mpf(0), mpf(0)) for k in range(64)],
     "tan(k·π/64) to a double, and its rounding error; 0 at the pole.")
polynomial("SINE_POLYNOMIAL", odd(sin), 5, 0, (mpf("5.6") * pi / 64) ** 2, "(sin x − x)/x³ in powers of x², to 0.27.")
polynomial("TANGENT_POLYNOMIAL", odd(tan), 8, 0, (mpf("4.6") * pi / 64) ** 2, "(tan x − x)/x³ in powers of x², to 0.22.")
# Row j is for numbers whose exponent and first three binary digits are those of j/8 counted from 1/16.
centres = []
for j in range(64):
    octave, eighth = divmod(j, 8)
    centres.append(mpf(2) ** (octave - 4) * (1 + (mpf(eighth) + mpf(1) / 2) / 8))
rows("ARCTANGENT_ROWS", [(c, *split(atan(c))) for c in centres],
     "c, atan c to a double, and its rounding error, for eight c in each octave from 1/16 to 16.")
polynomial("ARCTANGENT_POLYNOMIAL", odd(atan), 6, 0, mpf(1) / 256, "(atan x − x)/x³ in powers of x², to 1/16.")
polynomial("ARCSINE_POLYNOMIAL", odd(asin), 13, 0, mpf(1) / 4, "(asin x − x)/x³ in powers of x², to 1/2.")
polynomial("ARCSINE_F32", odd(asin), 6, 0, mpf(1) / 4, "(asin x − x)/x³ in powers of x², to 1/2, for single precision.")

module("powers", "Powers of two and hyperbolic functions.")
two = log(mpf(2))
steps = [mpf(2) ** (mpf(k) / 128) for k in range(128)]
constant("STEPS_PER_UNIT", double(128 / two), "128/ln 2.", shared=True)
constant("UNIT_STEP_HIGH", cut(two / 128, 36), "The leading 36 bits of (ln 2)/128: a multiple by up to 138 499 is exact, in units of 2⁻⁴³ and below 1024.",
         shared=True)
constant("UNIT_STEP_LOW", double(two / 128 - cut(two / 128, 36)), "The rest of (ln 2)/128.", shared=True)
rows("OF_TWO", [(bits((v - double(v)) / v), (bits(double(v)) - (k << 45)) % 2**64) for k, v in enumerate(steps)],
     "For 2^(k/128) as a double, its rounding error as a fraction of it, and its bits minus k·2⁴⁵.", "u64", shared=True)
polynomial("EXPONENTIAL_F32", lambda r: expm1(r * two) / r, 2, mpf(-1) / 256, mpf(1) / 256,
           "(2^r − 1)/r in powers of r, −1/256 to 1/256.")
polynomial("EXP_M1", lambda x: (exp(x) - 1 - x - x * x / 2) / x**3, 11, mpf("-0.30"), mpf("0.3000001"),
           "(e^x − 1 − x − x²/2)/x³ in powers of x, −0.3 to 0.3.")
polynomial("SINH_POLYNOMIAL", odd(sinh), 5, 0, mpf("0.31") ** 2, "(sinh x − x)/x³ in powers of x², to 0.3.")
rows("TANH_ROWS", [split(tanh((k + mpf(1) / 2) / 16)) for k in range(64)],
     "tanh((k + 1/2)/16) to a double, and its rounding error.")
polynomial("TANH_POLYNOMIAL", odd(tanh), 8, 0, mpf("0.251") ** 2, "(tanh x − x)/x³ in powers of x², to 1/4.")

width = mpf("0.00404")


def logarithm(name, base, unit):
    """The tables of a logarithm."""
    found = accurate_rows(lambda x: log(x) / log(base), mpf(2) ** unit)
    off = max(abs(log(c) / log(base) - value) for _, value, c in found)
    rows(f"{name}_ROWS", [row[:2] for row in found],
         f"1/c to a double and the logarithm of c, c as in `{name}_CENTRES` (Gal): the error of the logarithm is below "
         f"2{raised(int(floor(log(off, 2))) + 1)}.")
    table(f"{name}_CENTRES", [row[2] for row in found], "c near the middle of the row's significands, chosen so that its logarithm is very nearly a double.")
    if base != mp.e:
        polynomial(f"{name}_POLYNOMIAL", lambda r: log(1 + r) / log(base) / r, 6, -width, width,
                   "log(1 + r)/r in powers of r, −0.00404 to 0.00404, the range of a row.")
        constant(f"{name}_E_HIGH", rounded(1 / log(base), 31), "The logarithm of e, to 31 bits.")
        constant(f"{name}_E_LOW", double(1 / log(base) - rounded(1 / log(base), 31)), "The logarithm of e, minus its high part.")
    if base != 2:
        part = log(mpf(2)) / log(base)
        constant(f"{name}_2_HIGH", grid(part, -42), "The logarithm of 2 to a multiple of 2⁻⁴².")
        constant(f"{name}_2_LOW", double(part - grid(part, -42)), "The logarithm of 2 minus its high part.")


module("logarithms", "Logarithms, natural and to base 2.")
logarithm("LN", mp.e, -43)
polynomial("LN_POLYNOMIAL", lambda r: (log(1 + r) - r + r * r / 2) / r**3, 4, -width, width,
           "(ln(1 + r) − r + r²/2)/r³ in powers of r, −0.00404 to 0.00404, the range of a row.")
polynomial("LN_NEAR_ONE", lambda r: (log(1 + r) - r + r * r / 2) / r**3, 11, mpf("-0.0625"), mpf("0.0626"),
           "(ln(1 + r) − r + r²/2)/r³ in powers of r, −1/16 to 1/16.")
logarithm("LOG2", mpf(2), -42)
module("decimal", "Logarithms to base 10.")
logarithm("LOG10", mpf(10), -43)

module("finer", "Logarithms for powers and for single precision, cube roots.")


def coarse_reciprocal(low, high):
    """1/c of few bits, such that a significand times it, less 1, is a double."""
    if low < 1 < high:
        return mpf(1)
    # Multiples of 2^(last digit of the significand − bits), below 2^−most.
    for bits in (10, 9, 8, 7):
        c = grid(2 / (low + high), -bits)
        most = bits if high <= 1 else bits - 1
        if max(abs(low * c - 1), abs(high * c - 1)) < mpf(2) ** -most:
            return c
    raise ValueError(f"no reciprocal for {low} to {high}")


coarse = [coarse_reciprocal(*cell(j)) for j in range(128)]
logarithms = [-log(c) for c in coarse]
rows("COARSE_ROWS", [(c, grid(v, -42)) for c, v in zip(coarse, logarithms)],
     "1/c, of ten bits at most, and ln c to multiples of 2⁻⁴².")
table("COARSE_REST", [double(v - grid(v, -42)) for v in logarithms], "ln c minus the second column of `COARSE_ROWS`, to a double.")
width = mpf("0.0068")
polynomial("FINER_LN", lambda r: (log(1 + r) - r + r * r / 2) / r**3, 7, -width, width * 1.01,
           "(ln(1 + r) − r + r²/2)/r³ in powers of r, −0.0068 to 0.0068, the range of a row of `COARSE_ROWS`.")

single = [mpf(1) if low < 1 < high else double(2 / (low + high)) for low, high in map(cell, range(128))]
rows("LOG2_ROWS_F32", [(c, double(-log(c) / two)) for c in single],
     "1/c and log₂ c, each to a double, for c in the middle of a row, for single precision.")
width = mpf("0.00392")
polynomial("LOG2_F32", lambda r: log(1 + r) / two / r, 4, -width, width, "log₂(1 + r)/r in powers of r, −0.00392 to 0.00392, the range of a row.")

polynomial("CUBE_ROOT", lambda r: r ** (-mpf(1) / 3), 5, mpf("0.90"), mpf("1.11"), "r^(−1/3) in powers of r, 0.9 to 1.1.")
polynomial("CUBE_ROOT_F32", lambda r: r ** (-mpf(1) / 3), 7, mpf("0.90"), mpf("1.11"), "r^(−1/3) in powers of r, 0.9 to 1.1, finer.")
module("narrow", "Constants for `f32` in `f32` arithmetic alone.")


def narrow(name, function, count, low, high, text):
    polynomial(f"NARROW_{name}", function, count, low, high, text, "f32")


def narrow_parts(name, value, text, *digits):
    """A value as a sum of floats of so many bits, and one more."""
    left = value
    names = ("HIGH", "LOW") if len(digits) == 1 else ("1", "2", "3")
    for part, end in enumerate((*digits, 24)):
        taken = rounded(left, 24) if part == len(digits) else cut(left, end)
        constant(f"NARROW_{name}_{names[part]}", taken, f"{text}, part {part + 1}.", "f32")
        left -= taken


eighth = mpf(pi) / 4
narrow_parts("TURN", quarter, "π/2 in 16, 16 and 24 bits: a multiple of the first two by up to 2⁸ is exact", 16, 16)
narrow_parts("QUARTER", quarter, "π/2 in 12, 12 and 24 bits", 12, 12)
narrow_parts("HALF_PI", quarter, "π/2 in 24 and 24 bits", 24)
narrow_parts("LN_2", log(mpf(2)), "ln 2 in 16 and 24 bits: a multiple of the first by up to 2⁸ is exact", 16)
constant("NARROW_STEP_LN_2_HIGH", grid(log(mpf(2)), -9), "ln 2 to a multiple of 2⁻⁹: a multiple of it by up to 2¹⁵ is exact.", "f32")
constant("NARROW_STEP_LN_2_LOW", log(mpf(2)) - grid(log(mpf(2)), -9), "ln 2 minus its high part.", "f32")
narrow_parts("LOG10_2", log(mpf(2)) / log(mpf(10)), "log₁₀ 2 in 16 and 24 bits", 16)
narrow_parts("LOG2_E", 1 / log(mpf(2)), "log₂ e in 24 and 24 bits", 24)
narrow_parts("LOG10_E", 1 / log(mpf(10)), "log₁₀ e in 12 and 24 bits", 12)
words = [0] + [(int(floor(2 / pi * mpf(2) ** 320)) >> (32 * (9 - i))) & (2**32 - 1) for i in range(10)]
table("TWO_OVER_PI_WORDS", words, "The bits of 2/π after 32 zeros, most significant first.", "u32")
# Of smaller angles the polynomials are a smaller part, so the interval begins where their error matters.
most = (eighth * mpf("1.00002")) ** 2
narrow("SINE", lambda z: (1 - sin(sqrt(z)) / sqrt(z)) / z, 3, mpf(1) / 4, most, "(x − sin x)/x³ in powers of x², 1/2 to π/4.")
narrow("COSINE", lambda z: (cos(sqrt(z)) - 1 + z / 2) / z**2, 3, mpf(1) / 4, most, "(cos x − 1 + x²/2)/x⁴ in powers of x², 1/2 to π/4.")
narrow("TANGENT", odd(tan), 7, 0, mpf("0.62") ** 2, "(tan x − x)/x³ in powers of x², to 0.62.")
narrow("ARCTANGENT", odd(atan), 4, 0, mpf(1) / 16, "(atan x − x)/x³ in powers of x², to 1/4.")
centres = [mpf(2) ** (j // 4 - 2) * (1 + (mpf(j % 4) + mpf(1) / 2) / 4) for j in range(16)]
rows("NARROW_ARCTANGENT_ROWS", [(c, rounded(atan(c), 24), atan(c) - rounded(atan(c), 24)) for c in centres],
     "c, atan c to a float, and its rounding error, for four c in each octave from 1/4 to 4.", "f32")
narrow("ARCSINE", odd(asin), 5, 0, mpf(1) / 4, "(asin x − x)/x³ in powers of x², to 1/2.")
narrow("EXPONENTIAL", lambda x: (exp(x) - 1 - x) / x**2, 6, -two / 2, two / 2 * mpf("1.001"),
       "(e^x − 1 − x)/x² in powers of x, to (ln 2)/2.")
most = mpf("0.1726") ** 2
narrow("LOGARITHM", lambda z: log((1 + sqrt(z)) / (1 - sqrt(z))) / sqrt(z) / z - 2 / z, 3, 0, most,
       "(2·artanh s − 2s)/s³ in powers of s², to 0.1726.")
narrow("SINH", odd(sinh), 4, 0, mpf("1.05") ** 2, "(sinh x − x)/x³ in powers of x², to 1.05.")
narrow("TANH", odd(tanh), 7, 0, mpf("0.85") ** 2, "(tanh x − x)/x³ in powers of x², to 0.85.")


def log2_row(row):
    """A factor c that brings a row of significands next to 1, and −log₂ c in two parts."""
    first, last = (struct.unpack("<f", struct.pack("<I", 0x3F348000 + (row << 16) + more))[0] for more in (0, 0xFFFF))
    # What is left is below 2⁻⁷ and a multiple of 2⁻³¹, so that it is a float. A logarithm next to 0 must not be a difference, hence 255/256.
    if max(abs(first - 1), abs(last - 1)) < 2**-7:
        factor = mpf(1)
    elif first == 1 + 2**-8:
        factor = mpf(255) / 256
    else:
        factor = grid(2 / (mpf(first) + mpf(last)), -7 if last < 1 else -8)
    assert max(abs(first * factor - 1), abs(last * factor - 1)) < 2**-7
    value = -log(factor) / two
    return factor, grid(value, -16), value - grid(value, -16)


rows("NARROW_LOG2_ROWS", [log2_row(row) for row in range(128)],
     "A factor c of at most nine bits for a row of significands; −log₂ c to a multiple of 2⁻¹⁶, and the rest.", "f32")
steps = [mpf(2) ** (mpf(j) / 128) for j in range(128)]


def float_bits(value):
    return struct.unpack("<I", struct.pack("<f", float(value)))[0]


rows("NARROW_OF_TWO", [(float_bits(v / rounded(v, 24) - 1), (float_bits(v) - (j << 16)) % 2**32) for j, v in enumerate(steps)],
     "For 2^(j/128) as a float, its rounding error as a fraction of it, and its bits minus j·2¹⁶.", "u32", shared=True)


def logarithm_rows(name, base, unit):
    """Rows of the significands from 0x3f340600 on, a 32nd or a 64th wide: next to 1 c is 1, so that what is left is exact; else c is in the
    middle, and such that 1/c is next to a float."""
    mp.prec, before = 150, mp.prec
    found = []
    for row in range(64):
        first, last = (mpf(struct.unpack("<f", struct.pack("<I", 0x3F340600 + (row << 17) + more))[0]) for more in (0, 0x1FFFF))
        if first < 1 < last or max(abs(first - 1), abs(last - 1)) < mpf("0.0159"):
            found.append((mpf(1), mpf(1), mpf(0), mpf(0)))
            continue
        middle = rounded(2 / (1 / first + 1 / last), 24)
        step = mpf(2) ** (-24 if middle < 1 else -23)
        c = min((middle + step * k for k in range(-1000, 1000)), key=lambda it: abs(rounded(1 / it, 24) * it - 1))
        value = log(c) / log(base)
        found.append((c, rounded(1 / c, 24), grid(value, unit), value - grid(value, unit)))
    mp.prec = before
    rows(name, found, f"c near the middle of a row of significands, 1/c, the logarithm of c to a multiple of 2{raised(unit)}, and the rest.", "f32")


logarithm_rows("NARROW_LN_ROWS", mp.e, -17)
width = mpf("0.0159")
narrow("LN", lambda r: (log(1 + r) - r) / r**2, 3, -width, width * mpf("1.001"), "(ln(1 + r) − r)/r² in powers of r, −0.0159 to 0.0159.")
logarithm_rows("NARROW_BINARY_LOG_ROWS", mpf(2), -16)
narrow("BINARY_LOG", lambda r: log(1 + r) / two / r - mpf(23) / 16, 4, -width, width,
       "log₂(1 + r)/r − 23/16 in powers of r, −0.0159 to 0.0159.")
# To 0.0375 is what there is: weighted with w³, points a third further out lose least.
narrow("CUBE_ROOT", lambda w: (((1 + 2 * w) / (1 - w)) ** (mpf(1) / 3) - 1 - w) / w**3, 2, mpf("-0.0495"), mpf("0.0495"),
       "(((1 + 2w)/(1 − w))^(1/3) − 1 − w)/w³ in powers of w, −0.0495 to 0.0495.")

module("fast", "Tables of the fast elementary functions.")
fast_step = mpf(pi) / 64
narrow_step = cut(fast_step, 13)
constant("ANGLE_STEPS", rounded(1 / fast_step, 24), "64/π.", "f32")
constant("ANGLE_STEP_HIGH", narrow_step, "π/64 in 13 bits: a multiple by up to 2¹¹ is exact.", "f32")
constant("ANGLE_STEP_LOW", rounded(fast_step - narrow_step, 24), "π/64 less [`ANGLE_STEP_HIGH`].", "f32")
table("ANGLE_SINES", [exact(sin(k * pi / 64)) for k in range(160)],
      "sin(k·π/64) for k from 0 to 159; the cosine of an angle is the sine 32 elements behind.", "f32", shared=True)
polynomial("ARCTANGENT_OF_RATIO", odd(atan), 7, 0, 1, "(atan x − x)/x³ in powers of x², to 1.", "f32")
files.close()
