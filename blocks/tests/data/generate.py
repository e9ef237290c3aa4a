"""Writes the reference values of `bessemer-blocks` beside this file, by independent implementations.

pip install numpy==2.4.6 scipy==1.17.1 AHRS==0.4.0 pymap3d==3.2.0 cantools==45.1.0 control==0.10.2 clarabel==0.11.1 && python3 generate.py

A line is a name and its numbers. `blocks/tests/` reads the files, so that the tests need no Python.
"""

import binascii
import pathlib
import zlib

import ahrs
import cantools
import clarabel
import control
import numpy as np
import pymap3d
from scipy import integrate, interpolate, linalg, optimize, signal, sparse
from scipy.spatial.transform import Rotation

HERE = pathlib.Path(__file__).parent


def write(family, values, folder=HERE):
    lines = []
    for name, numbers in values.items():
        numbers = np.asarray(numbers).flatten().tolist()
        lines.append(" ".join([name] + [repr(number) for number in numbers]))
    (folder / f"{family}.txt").write_text("\n".join(lines) + "\n")


def noise(seed, count):
    return np.round(np.random.default_rng(seed).normal(size=count), 3)


def controllers():
    """The linear PID as transfer functions, by scipy.signal.lfilter."""
    kp, ki, kd, b, c, tf, h = 2.0, 3.0, 0.4, 0.6, 0.3, 0.05, 0.01
    r, y = noise(1, 40), noise(2, 40)
    r[0] = y[0] = 0.0
    proportional = kp * (b * r - y)
    integral = signal.lfilter([0, h * ki], [1, -1], r - y)
    derivative = signal.lfilter([kd, -kd], [tf + h, -tf], c * r - y)
    write("pid", {
        "parameters": [kp, ki, kd, b, c, tf, h],
        "target": r,
        "measured": y,
        "output": proportional + integral + derivative,
    })


def filters():
    """Sections by scipy.signal.bilinear of the analog filters, outputs by lfilter and sosfilt."""
    values = {"input": noise(3, 60)}
    u = values["input"]
    tau, lead, lag, h = 0.03, 0.05, 0.01, 0.004
    for name, above, below in [
        ("low_pass", [1], [tau, 1]),
        ("high_pass", [tau, 0], [tau, 1]),
        ("lead_lag", [lead, 1], [lag, 1]),
    ]:
        numerator, denominator = signal.bilinear(above, below, 1 / h)
        values["first_" + name] = signal.lfilter(numerator, denominator, u)
    frequency, quality, rate = 60.0, 0.8, 1000.0
    # Prewarped: s is in units of the frequency.
    warped = 1 / (2 * np.tan(np.pi * frequency / rate))
    sections = []
    for name, above in [
        ("low_pass", [1]),
        ("high_pass", [1, 0, 0]),
        ("band_pass", [1 / quality, 0]),
        ("notch", [1, 0, 1]),
    ]:
        numerator, denominator = signal.bilinear(above, [1, 1 / quality, 1], warped)
        numerator = np.concatenate([numerator, np.zeros(3 - len(numerator))])
        values["section_" + name] = np.concatenate([numerator, denominator[1:]])
        sections.append(np.concatenate([numerator, denominator]))
    values["cascade"] = signal.sosfilt(np.array([sections[0], sections[3]]), u)
    write("filters", values)


def windows():
    u = noise(4, 50)
    taps = np.round(signal.firwin(7, 0.3), 4)
    padded = np.concatenate([np.full(5, u[0]), u])
    window = np.lib.stride_tricks.sliding_window_view(padded, 5)[1:]
    tau, h = 0.02, 0.01
    shifted = u - u[0]
    write("windows", {
        "input": u,
        "taps": taps,
        "fir": signal.lfilter(taps, [1], u),
        "decimated": signal.upfirdn(taps, u, down=3)[:17],
        "mean": window.mean(axis=1),
        "variance": window.var(axis=1, ddof=1),
        "derivative": signal.lfilter([1, -1], [tau + h, -tau], shifted),
        "integral": integrate.cumulative_trapezoid(u, dx=h, initial=0),
    })


def limits():
    """Han's tracking differentiator with his formula of signs (2009, equations (19) and (20))."""
    def fhan(x1, x2, r, h):
        d = r * h * h
        a0 = h * x2
        y = x1 + a0
        a1 = np.sqrt(d * (d + 8 * abs(y)))
        a2 = a0 + np.sign(y) * (a1 - d) / 2
        sy = (np.sign(y + d) - np.sign(y - d)) / 2
        a = (a0 + y - a2) * sy + a2
        sa = (np.sign(a + d) - np.sign(a - d)) / 2
        return -r * (a / d - np.sign(a)) * sa - r * np.sign(a)

    rate, acceleration, h = 2.0, 5.0, 0.02
    target = np.repeat([1.0, -0.5, 3.0], 60)
    value = speed = 0.0
    outputs = []
    for wanted in target:
        change = fhan(value - wanted, speed, acceleration, h)
        value, speed = value + h * speed, np.clip(speed + h * change, -rate, rate)
        outputs.append([value, speed])
    write("limits", {"target": target, "motion": outputs})


def tables():
    axis = np.array([-1.0, 0.0, 0.5, 2.0, 5.0])
    values = np.array([3.0, 1.0, 4.0, 1.5, 9.0])
    rows = np.array([0.0, 1.0, 4.0])
    grid = np.round(np.random.default_rng(5).normal(size=(3, 5)), 2)
    at = np.linspace(-3, 7, 41)
    surface = interpolate.RegularGridInterpolator((rows, axis), grid, bounds_error=False, fill_value=None)
    points = np.stack([np.linspace(-1, 6, 41), at], axis=1)
    held = np.stack([np.clip(points[:, 0], 0, 4), np.clip(at, -1, 5)], axis=1)
    uniform = np.linspace(-2, 6, 5)
    write("tables", {
        "axis": axis, "values": values, "rows": rows, "grid": grid, "at": at,
        "row_at": points[:, 0],
        "held": np.interp(at, axis, values),
        "extended": interpolate.interp1d(axis, values, fill_value="extrapolate")(at),
        "uniform_held": np.interp(at, uniform, values),
        "uniform_extended": interpolate.interp1d(uniform, values, fill_value="extrapolate")(at),
        "surface_held": surface(held),
        "surface_extended": surface(points),
    })


def trajectories():
    """Polynomials by solving their boundary conditions."""
    def polynomial(states, count, duration):
        degree = 2 * count - 1
        matrix, right = [], []
        for time, state in zip((0.0, duration), states):
            for order in range(count):
                row = np.zeros(degree + 1)
                for power in range(order, degree + 1):
                    factor = np.prod(np.arange(power - order + 1, power + 1))
                    row[power] = factor * time ** (power - order)
                matrix.append(row)
                right.append(state[order])
        return np.polynomial.Polynomial(np.linalg.solve(matrix, right))

    start, end, duration = [1.0, -0.5, 0.3, 0.2], [4.0, 0.4, -0.6, 1.0], 2.5
    times = np.linspace(0, duration, 11)
    values = {"start": start, "end": end, "times": times}
    for name, count in [("jerk", 3), ("snap", 4)]:
        curve = polynomial((start, end), count, duration)
        values[name] = np.stack([curve.deriv(k)(times) if k else curve(times) for k in range(4)], axis=1)
    write("trajectories", values)


def drives():
    # Space vectors by the textbook's sectors and times.
    def duties(alpha, beta, supply):
        angle, length = np.arctan2(beta, alpha) % (2 * np.pi), np.hypot(alpha, beta)
        sector = int(angle // (np.pi / 3))
        within = angle - sector * np.pi / 3
        first = np.sqrt(3) * length / supply * np.sin(np.pi / 3 - within)
        second = np.sqrt(3) * length / supply * np.sin(within)
        rest = (1 - first - second) / 2
        # Phases in order of falling duty, for each sector.
        order = [(0, 1, 2), (1, 0, 2), (1, 2, 0), (2, 1, 0), (2, 0, 1), (0, 2, 1)][sector]
        times = [rest + first + second, rest + (second if sector % 2 == 0 else first), rest]
        result = np.zeros(3)
        for phase, time in zip(order, times):
            result[phase] = time
        return result

    angles = np.arange(12) * 0.53 + 0.1
    vectors = np.stack([10 * np.cos(angles), 10 * np.sin(angles)], axis=1)
    # The largest torque for a current, by search.
    flux, ld, lq = 0.05, 2e-3, 5e-3
    currents = np.array([2.0, 10.0, -25.0])
    best = []
    for current in currents:
        def torque(angle):
            d, q = -abs(current) * np.sin(angle), abs(current) * np.cos(angle)
            return -(flux + (ld - lq) * d) * q
        angle = optimize.minimize_scalar(torque, bounds=(0, np.pi / 2), method="bounded", options={"xatol": 1e-12}).x
        best.append([-abs(current) * np.sin(angle), np.sign(current) * abs(current) * np.cos(angle)])
    # A motor at a rising speed, by an ODE: voltages as means of each period, currents at its end.
    resistance, inductance, magnet, period = 0.3, 4e-4, 0.012, 1e-4

    def field(time, state):
        theta = 500 * time + 2000 * time * time
        omega = 500 + 4000 * time
        voltage = voltages(time)
        back = magnet * omega * np.array([-np.sin(theta), np.cos(theta)])
        return (voltage - resistance * state - back) / inductance

    def voltages(time):
        k = np.floor(time / period + 1e-9)
        middle = (k + 0.5) * period
        theta, omega = 500 * middle + 2000 * middle * middle, 500 + 4000 * middle
        return 1.3 * magnet * omega * np.array([-np.sin(theta), np.cos(theta)])

    state, rows = np.zeros(2), []
    for k in range(400):
        inside = (k * period, (k + 1) * period)
        state = integrate.solve_ivp(field, inside, state, rtol=1e-9, atol=1e-12, max_step=period / 4).y[:, -1]
        theta = 500 * inside[1] + 2000 * inside[1] ** 2
        rows.append([*voltages(inside[0]), *state, (theta + np.pi) % (2 * np.pi) - np.pi])
    write("drives", {
        "vectors": vectors,
        "duties": [duties(a, b, 24.0) for a, b in vectors],
        "motor": [flux, ld, lq],
        "currents": currents,
        "mtpa": best,
        "observed": [resistance, inductance, magnet, period],
        "motion": np.round(rows, 9),
    })


def attitude():
    rng = np.random.default_rng(7)
    gyro = np.round(rng.normal(scale=0.5, size=(30, 3)), 3)
    force = np.round(rng.normal(scale=1.0, size=(30, 3)) + [0, 0, 9.81], 3)
    period, kp, ki, beta = 0.01, 1.5, 0.2, 0.08
    mahony = ahrs.filters.Mahony(Dt=period, k_P=kp, k_I=ki, q0=[1.0, 0.0, 0.0, 0.0])
    madgwick = ahrs.filters.Madgwick(Dt=period, gain=beta, q0=[1.0, 0.0, 0.0, 0.0])
    q_mahony = q_madgwick = np.array([1.0, 0.0, 0.0, 0.0])
    outputs = {"mahony": [], "madgwick": []}
    for rates, acceleration in zip(gyro, force):
        q_mahony = mahony.updateIMU(q_mahony, rates, acceleration)
        q_madgwick = madgwick.updateIMU(q_madgwick, rates, acceleration)
        outputs["mahony"].append(q_mahony)
        outputs["madgwick"].append(q_madgwick)
    attitudes = Rotation.random(8, rng=rng)
    targets = Rotation.random(8, rng=rng)
    # Twice the sine of half the angle, along the axis.
    turn = (attitudes.inv() * targets).as_rotvec()
    angle = np.linalg.norm(turn, axis=1, keepdims=True)
    write("attitude", {
        "gyro": gyro, "force": force, "gains": [period, kp, ki, beta], **outputs,
        "attitudes": attitudes.as_quat(), "targets": targets.as_quat(),
        "errors": turn / angle * 2 * np.sin(angle / 2),
    })


def frames():
    rng = np.random.default_rng(8)
    latitudes, longitudes = rng.uniform(-1.57, 1.57, 12), rng.uniform(-3.14, 3.14, 12)
    heights = np.array([0, 100, -400, 8848, 1e4, 4e5, 2e7, 0, 50, 1e3, 3.6e7, -1e4])
    geodetic = np.stack([latitudes, longitudes, heights], axis=1)
    ecef = np.stack(pymap3d.geodetic2ecef(*geodetic.T, deg=False), axis=1)
    origin = [0.8, 0.15, 500.0]
    enu = np.stack(pymap3d.ecef2enu(*ecef.T, *origin, deg=False), axis=1)
    ned = np.stack(pymap3d.ecef2ned(*ecef.T, *origin, deg=False), axis=1)
    write("frames", {"geodetic": geodetic, "ecef": ecef, "origin": origin, "enu": enu, "ned": ned})


def bytes_():
    rng = np.random.default_rng(9)
    text = rng.integers(0, 256, 40)
    dbc = """VERSION ""
BU_: A
BO_ 1 M: 8 A
"""
    shapes = [(0, 12, 1, "-", 0.5, -3), (12, 9, 1, "+", 0.1, 0), (7, 16, 0, "-", 0.25, 10), (37, 11, 0, "+", 2, -100), (3, 1, 1, "+", 1, 0)]
    rows = []
    for start, bits, little, sign, scale, offset in shapes:
        line = f' SG_ S : {start}|{bits}@{little}{sign} ({scale},{offset}) [0|0] "" A\n'
        message = cantools.database.load_string(dbc + line, "dbc").get_message_by_name("M")
        for _ in range(4):
            frame = rng.integers(0, 256, 8).tolist()
            value = message.decode(bytes(frame), decode_choices=False)["S"]
            alone = list(message.encode({"S": value}))
            rows.append([start, bits, little, sign == "-", scale, offset, *frame, value, *alone])
    write("bytes", {
        "text": text,
        "crc32": [zlib.crc32(bytes(text.tolist()))],
        "crc16": [binascii.crc_hqx(bytes(text.tolist()), 0xFFFF)],
        "signals": np.array(rows, dtype=float),
    })


def spectrum():
    rng = np.random.default_rng(10)
    x = np.round(rng.normal(size=32) + 1j * rng.normal(size=32), 3)
    spectrum = np.fft.fft(x)
    cycles = np.array([0.0, 0.1, 0.25, 0.37, 0.5])
    k = np.arange(32)
    tones = [abs(np.sum(x.real * np.exp(-2j * np.pi * turn * k))) ** 2 for turn in cycles]
    write("spectrum", {
        "re": x.real, "im": x.imag, "spectrum_re": spectrum.real, "spectrum_im": spectrum.imag,
        "cycles": cycles, "tones": tones,
    })


def design():
    """Discrete models, gains and filters by python-control and SciPy."""
    a = np.array([[0.0, 1.0, 0.0], [-20.0, -0.4, 3.0], [0.0, -2.0, -50.0]])
    b, c, d, h = np.array([[0.0], [1.5], [40.0]]), np.array([[1.0, 0.2, 0.0]]), 0.1, 0.02
    held = signal.cont2discrete((a, b, c, np.array([[d]])), h)
    values = {"a": a, "b": b, "c": c, "held_a": held[0], "held_b": held[1]}
    for name, step in [("tustin", h), ("prewarped", 2 * np.tan(30 * h / 2) / 30)]:
        for part, matrix in zip("abcd", signal.cont2discrete((a, b, c, np.array([[d]])), step, "bilinear")):
            values[f"{name}_{part}"] = matrix
    q, r = np.diag([10.0, 1.0, 0.1]), np.array([[0.5]])
    gain, x, _ = control.dlqr(held[0], held[1], q, r)
    values.update({"riccati": x, "lqr": gain})
    noise, seen = np.diag([0.01, 0.1, 0.2]), np.array([[0.3]])
    p, _, _ = control.dare(held[0].T, c.T, noise, seen)
    values["kalman"] = p @ c.T @ np.linalg.inv(c @ p @ c.T + seen)
    poles = [0.7, 0.6 + 0.2j, 0.6 - 0.2j]
    values["place"] = control.acker(held[0], held[1], poles)
    cycles = np.linspace(0.01, 0.49, 13)
    values["cycles"] = cycles
    for order in (1, 2, 3, 4, 5, 8):
        for kind in ("lowpass", "highpass"):
            shapes = {
                "butterworth": signal.butter(order, 60, kind, fs=1000, output="sos"),
                "chebyshev": signal.cheby1(order, 1.5, 60, kind, fs=1000, output="sos"),
            }
            for name, sections in shapes.items():
                _, response = signal.freqz_sos(sections, worN=2 * np.pi * cycles)
                values[f"{name}_{kind}_{order}"] = np.stack([response.real, response.imag], axis=1)
    model = signal.dlti(*held[:2], c, np.array([[d]]), dt=h)
    values["step"] = signal.dstep(model, n=20)[1][0]
    write("design", values, HERE.parent.parent / "design" / "tests")


def minimum(hessian, gradient, rows, low, high, cones=0, size=3):
    """The minimum, or nothing, by Clarabel's interior point; the last rows are cones."""
    limits = len(rows) - cones * size
    finite_high, finite_low = np.isfinite(high[:limits]), np.isfinite(low[:limits])
    above, below = rows[:limits][finite_high], rows[:limits][finite_low]
    matrix = np.concatenate([above, -below, -rows[limits:]])
    right = np.concatenate([high[:limits][finite_high], -low[:limits][finite_low], -low[limits:]])
    kinds = [clarabel.NonnegativeConeT(len(above) + len(below))]
    kinds += [clarabel.SecondOrderConeT(size)] * cones
    settings = clarabel.DefaultSettings()
    settings.verbose = False
    settings.tol_gap_abs = settings.tol_gap_rel = settings.tol_feas = 1e-12
    found = clarabel.DefaultSolver(
        sparse.csc_matrix(np.triu(hessian)), gradient, sparse.csc_matrix(matrix), right, kinds, settings
    ).solve()
    if str(found.status) == "PrimalInfeasible":
        return []
    assert str(found.status) in ("Solved", "AlmostSolved"), found.status
    return found.x


def programs():
    """Quadratic programs of 6 variables and 10 rows, by an interior point: limits alone, and with cones."""
    rng = np.random.default_rng(71)
    n, m = 6, 10
    square = rng.normal(size=(n, n)).round(3)
    hessian = square @ square.T + np.eye(n)
    rows = rng.normal(size=(m, n)).round(3)
    rows[9] = rows[8]
    values = {"hessian": hessian, "rows": rows}
    for index in range(16):
        gradient = (6 * rng.normal(size=n)).round(3)
        middle = (rows @ rng.normal(size=n)).round(3)
        width = rng.uniform(0.02, 1.0, size=m).round(3)
        low, high = middle - width, middle + width
        low[7], high[6] = -np.inf, np.inf
        if index % 3 == 1:
            low[0] = high[0]
        if index % 5 == 4:
            low[9] = high[8] + 0.1
            high[9] = low[9] + 1.0
        values[f"gradient_{index}"], values[f"low_{index}"], values[f"high_{index}"] = gradient, low, high
        values[f"point_{index}"] = minimum(hessian, gradient, rows, low, high)
        offset = middle - np.where(np.arange(m) % 3 == 1, 0.3, 0.0)
        offset[:4] = low[:4]
        if index % 5 == 4:
            offset[0] = high[0] + 0.5
        values[f"cone_low_{index}"] = offset
        values[f"cone_point_{index}"] = minimum(hessian, gradient, rows, offset, high, 2)
    write("programs", values)


def receding():
    """A pendulum on a cart: the best plan from a state, and the way to the middle with the best plan in each period, by SLSQP."""
    h, periods, goal = 0.05, 20, np.zeros(4)
    q = np.array([2.0, 4.0, 0.1, 0.2])

    def law(x, u):
        turn = (9.81 * np.sin(x[1]) - u * np.cos(x[1])) / 0.5 - 0.1 * x[3]
        speed, rate = x[2] + h * u, x[3] + h * turn
        return np.array([x[0] + h * speed, x[1] + h * rate, speed, rate])

    def states(u, x):
        found = []
        for push in u:
            x = law(x, push)
            found.append(x)
        return np.array(found)

    def by_inputs(u, x):
        """The Jacobians of the states by the inputs."""
        jacobian, found = np.zeros((4, periods)), []
        for k, push in enumerate(u):
            sine, cosine = np.sin(x[1]), np.cos(x[1])
            angle = (9.81 * cosine + push * sine) / 0.5
            a = np.array([[1, 0, h, 0], [0, 1 + h * h * angle, 0, h - 0.1 * h * h], [0, 0, 1, 0], [0, h * angle, 0, 1 - 0.1 * h]])
            b = np.array([h * h, -h * h * cosine / 0.5, h, -h * cosine / 0.5])
            jacobian = a @ jacobian
            jacobian[:, k] += b
            found.append(jacobian)
            x = law(x, push)
        return found

    def best(x, start):
        weights = np.array([q] * (periods - 1) + [20 * q])

        def cost(u):
            return 0.5 * np.sum(weights * states(u, x) ** 2) + 0.005 * np.sum(u**2)

        def slope(u):
            rows = zip(by_inputs(u, x), weights * states(u, x))
            return sum(jacobian.T @ row for jacobian, row in rows) + 0.01 * u

        rails = [
            {
                "type": "ineq",
                "fun": lambda u: np.concatenate([0.8 - states(u, x)[:, 0], 0.8 + states(u, x)[:, 0]]),
                "jac": lambda u: np.concatenate([[-j[0] for j in by_inputs(u, x)], [j[0] for j in by_inputs(u, x)]]),
            }
        ]
        found = optimize.minimize(
            cost, start, jac=slope, method="SLSQP", bounds=[(-12, 12)] * periods, constraints=rails,
            options={"ftol": 1e-15, "maxiter": 500},
        )
        assert found.success, found.message
        return found.x

    values = {}
    for index, x in enumerate([[0.5, 0.2, 0.0, 0.0], [-0.6, 0.1, -0.2, -0.3], [0.2, -0.5, -0.4, 0.5]]):
        plan = best(np.array(x), np.zeros(periods))
        values[f"start_{index}"], values[f"plan_{index}"] = x, plan
    x, plan, track, cost = np.array([-0.5, 0.4, 0.0, 0.0]), np.zeros(periods), [], 0.0
    for k in range(40):
        plan = best(x, np.append(plan[1:], plan[-1]))
        x = law(x, plan[0])
        cost += 0.5 * np.sum(q * x**2) + 0.005 * plan[0] ** 2
        track.append(x)
    values["track"], values["track_cost"] = track, [cost]
    write("receding", values)


def riccati():
    """Plans of a mass in three dimensions with limits and a cone of its inputs, by Clarabel, as one sparse program."""
    h, periods, weight = 0.2, 8, 2.0
    a = np.block([[np.eye(3), h * np.eye(3)], [np.zeros((3, 3)), np.eye(3)]])
    b = np.vstack([h * h / 2 * np.eye(3), h * np.eye(3)])
    q, r = np.diag([4.0, 3.0, 3.0, 1.0, 0.5, 0.5]), np.diag([0.3, 0.2, 0.2])
    last = linalg.solve_discrete_are(a, b, q + weight * np.eye(6), r + weight * np.eye(3))
    values = {"a": a, "b": b, "q": q, "r": r, "last": last}
    rng, goal = np.random.default_rng(41), np.array([1.0, 0.2, -0.1, 0.0, 0.0, 0.0])
    values["goal"] = goal
    # The unknowns are the inputs, then the states from the first that follows.
    forced, free = np.zeros((6 * periods, 3 * periods)), np.zeros((6 * periods, 6))
    for k in range(periods):
        free[6 * k : 6 * k + 6] = np.linalg.matrix_power(a, k + 1)
        for j in range(k + 1):
            forced[6 * k : 6 * k + 6, 3 * j : 3 * j + 3] = np.linalg.matrix_power(a, k - j) @ b
    weights = linalg.block_diag(*[q] * (periods - 1), last - weight * np.eye(6))
    hessian = linalg.block_diag(*[r] * periods) + forced.T @ weights @ forced
    for index in range(12):
        x = np.concatenate([rng.normal(size=3) * 0.8, rng.normal(size=3) * 0.6]).round(3)
        if index % 4 == 3:
            x[3] = 6.0
        cone = index % 2
        low, high = np.array([-2.0, -1.0, -1.0]), np.array([2.0, 1.0, 1.5])
        lowest, highest = np.array([-9.0, -9.0, -9.0, -0.8, -0.8, -9.0]), np.array([9.0, 9.0, 9.0, 1.0, 0.8, 9.0])
        if cone:
            low = np.array([-3.0, 0.0, 0.0])
        apart = np.tile(goal, periods) - free @ x
        gradient = -forced.T @ weights @ apart
        rows = np.vstack([forced, np.eye(3 * periods)])
        under = np.concatenate([np.tile(lowest, periods) - free @ x, np.tile(low, periods)])
        above = np.concatenate([np.tile(highest, periods) - free @ x, np.tile(high, periods)])
        plan = minimum(hessian, gradient, rows, under, above, periods if cone else 0)
        for name, numbers in [("x", x), ("low", low), ("high", high), ("lowest", lowest), ("highest", highest)]:
            values[f"{name}_{index}"] = numbers
        values[f"input_{index}"] = plan[:3]
    write("riccati", values)


def error_state():
    """The error-state filter on dense matrices, with Joseph's form and SciPy's rotations."""
    h, rates_noise, drift, force_noise, field_noise = 0.01, 1e-5, 1e-8, 4e-3, 1e-2
    rng, north = np.random.default_rng(8), np.array([0.6, 0.0, -0.8])
    truth, bias = Rotation.from_euler("xyz", [0.4, -0.3, 1.2]), np.array([0.02, -0.01, 0.03])
    q, b = Rotation.identity(), np.zeros(3)
    p = np.diag([0.25, 0.25, 1.5, 1e-3, 1e-3, 1e-3])
    all_rates, forces, fields, quaternions, biases, surprises = [], [], [], [], [], []

    def across(v):
        return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])

    def correct(q, b, p, direction, measured, variance):
        expected = q.inv().apply(direction)
        row = np.hstack([across(expected), np.zeros((3, 3))])
        spread = row @ p @ row.T + variance * np.eye(3)
        gain = p @ row.T @ np.linalg.inv(spread)
        off = measured / np.linalg.norm(measured) - expected
        errors = gain @ off
        kept = np.eye(6) - gain @ row
        p = kept @ p @ kept.T + variance * gain @ gain.T
        return q * Rotation.from_rotvec(errors[:3]), b + errors[3:], p, off @ np.linalg.inv(spread) @ off

    for k in range(300):
        rates = np.array([0.5 * np.sin(0.02 * k), 0.3, 0.4 * np.cos(0.013 * k)])
        truth = truth * Rotation.from_rotvec(rates * h)
        measured = (rates + bias + rng.normal(size=3) * 0.03).round(6)
        force = (9.81 * (truth.inv().apply([0, 0, 1]) + 0.05 * rng.normal(size=3))).round(6)
        field = (45.0 * (truth.inv().apply(north) + 0.05 * rng.normal(size=3))).round(6)
        turn = Rotation.from_rotvec((measured - b) * h)
        jacobian = np.eye(6)
        jacobian[:3, :3], jacobian[:3, 3:] = turn.inv().as_matrix(), -h * np.eye(3)
        q, p = q * turn, jacobian @ p @ jacobian.T + np.diag([rates_noise * h] * 3 + [drift * h] * 3)
        q, b, p, surprise = correct(q, b, p, np.array([0.0, 0.0, 1.0]), force, force_noise)
        if k % 5 == 0:
            fields.append(field)
            q, b, p, surprise = correct(q, b, p, north, field, field_noise)
        for kept, numbers in [
            (all_rates, measured), (forces, force), (quaternions, q.as_quat()), (biases, b), (surprises, surprise)
        ]:
            kept.append(numbers)
    write(
        "error_state",
        {"rates": all_rates, "force": forces, "field": fields, "attitude": quaternions[::20], "bias": biases[::20],
         "surprise": surprises[::20], "truth": truth.as_quat(), "true_bias": bias},
    )


for family in [controllers, filters, windows, limits, tables, trajectories, drives, attitude, error_state, frames, bytes_, spectrum, programs, receding, riccati, design]:
    family()
