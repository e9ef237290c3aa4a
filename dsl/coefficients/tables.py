#!/usr/bin/env python3
"""The tables and split constants of the elementary functions, from multiple precision.

    pip install mpmath
    python3 dsl/coefficients/tables.py dsl/src/math/tables

Polynomials need none of this: their coefficients are those of the Taylor series, written in the
Rust as quotients of integers, since the tables leave arguments of 1/128 and less.
"""

import contextlib
import pathlib
import sys

from mpmath import atan, cos, floor, log, mp, mpf, nint, pi, sin

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


files = contextlib.ExitStack()
module("angles", "π and its parts, sines, cosines and arctangents.")
quarter = pi / 2
first = cut(quarter, 33)
second = cut(quarter - first, 33)
third = cut(quarter - first - second, 33)
constant("QUARTER_TURN_1", first, "The leading 33 bits of π/2: a multiple of it by up to 2²⁰ is exact.")
constant("QUARTER_TURN_2", second, "The next 33 bits of π/2.")
constant("QUARTER_TURN_3", third, "The next 33 bits of π/2.")
constant("QUARTER_TURN_4", double(quarter - first - second - third), "The rest of π/2.")
pair("HALF_PI", pi / 2, "π/2")
pair("WHOLE_PI", pi, "π")

bits = int(floor(2 / pi * mpf(2) ** (35 * 64)))
words = [0] + [(bits >> (64 * (34 - i))) & (2**64 - 1) for i in range(35)]
table("TWO_OVER_PI", words, "The bits of 2/π after 64 zeros, most significant first.", "u64")

pairs("SINE", [sin(mpf(k) / 64) for k in range(64)], "sin(k/64)")
pairs("COSINE", [cos(mpf(k) / 64) for k in range(64)], "cos(k/64)")
pairs("ARCTANGENT", [atan(mpf(k) / 64) for k in range(64)], "atan(k/64)")

module("powers", "Powers of two, logarithms, cube roots.")
step = log(mpf(2)) / 64
constant("STEPS_PER_UNIT", double(1 / step), "64/ln 2.")
constant("STEP_HIGH", cut(step, 36), "The leading 36 bits of (ln 2)/64: a multiple by up to 2¹⁷ is exact.")
constant("STEP_LOW", double(step - cut(step, 36)), "The rest of (ln 2)/64.")
pairs("POWER", [mpf(2) ** (mpf(k) / 64) for k in range(64)], "2^(k/64)")

two = log(mpf(2))
constant("LN_2_HIGH", grid(two, -42), "ln 2 to a multiple of 2⁻⁴².")
constant("LN_2_LOW", double(two - grid(two, -42)), "ln 2 less its high part.")
pair("RECIPROCAL_LN_2", 1 / two, "1/ln 2")
pair("RECIPROCAL_LN_10", 1 / log(mpf(10)), "1/ln 10")

# Entry j mod 128 belongs to mantissas near j/128, which go from 1/√2 to √2.
reciprocals, logarithms = [mpf(1)] * 128, [mpf(0)] * 128
for j in range(90, 183):
    reciprocals[j % 128] = grid(mpf(128) / j, -11)
    logarithms[j % 128] = -log(reciprocals[j % 128])
table("RECIPROCAL", reciprocals, "128/j to a multiple of 2⁻¹¹, at j modulo 128 for j from 90 to 182.")
table("LOGARITHM_HIGH", [grid(v, -42) for v in logarithms], "Minus ln of `RECIPROCAL`, to multiples of 2⁻⁴².")
table("LOGARITHM_LOW", [double(v - grid(v, -42)) for v in logarithms], "Minus ln of `RECIPROCAL`, less the high parts.")

# The parabola through the cube root at the Chebyshev points of 1 to 8.
nodes = [mpf("4.5") + mpf("3.5") * cos(pi * (2 * k + 1) / 6) for k in range(3)]
values = [n ** (mpf(1) / 3) for n in nodes]
d01 = (values[1] - values[0]) / (nodes[1] - nodes[0])
d12 = (values[2] - values[1]) / (nodes[2] - nodes[1])
c2 = (d12 - d01) / (nodes[2] - nodes[0])
c1 = d01 - c2 * (nodes[0] + nodes[1])
c0 = values[0] - d01 * nodes[0] + c2 * nodes[0] * nodes[1]
for name, value in (("ROOT_0", c0), ("ROOT_1", c1), ("ROOT_2", c2)):
    constant(name, double(value), "A parabola near the cube root of 1 to 8, a coefficient.")
files.close()
