/* The C of blocks/src/drives.rs. Written by a test. */

/* drives.c */

void drives_clarke_f32(float a, float b, stator_f32_t *stator)
{
    stator->alpha = a;
    stator->beta = (a + 2.0F * b) * 0.57735026F;
}

void drives_clarke_f64(double a, double b, stator_f64_t *stator)
{
    stator->alpha = a;
    stator->beta = (a + 2.0 * b) * 0.5773502691896258;
}

void drives_clarke_inverse_f32(const stator_f32_t *vector, float result[BESSEMER_RESTRICT 3])
{
    const float half = 0.5F * vector->alpha;
    const float across = 0.8660254F * vector->beta;
    result[0] = vector->alpha;
    result[1] = across - half;
    result[2] = -across - half;
}

void drives_clarke_inverse_f64(const stator_f64_t *vector, double result[BESSEMER_RESTRICT 3])
{
    const double half = 0.5 * vector->alpha;
    const double across = 0.8660254037844386 * vector->beta;
    result[0] = vector->alpha;
    result[1] = across - half;
    result[2] = -across - half;
}

void drives_park_f32(const stator_f32_t *vector, float sine, float cosine,
    rotor_f32_t *BESSEMER_RESTRICT rotor)
{
    rotor->direct = cosine * vector->alpha + sine * vector->beta;
    rotor->quadrature = cosine * vector->beta - sine * vector->alpha;
}

void drives_park_f64(const stator_f64_t *vector, double sine, double cosine,
    rotor_f64_t *BESSEMER_RESTRICT rotor)
{
    rotor->direct = cosine * vector->alpha + sine * vector->beta;
    rotor->quadrature = cosine * vector->beta - sine * vector->alpha;
}

void drives_park_inverse_f32(const rotor_f32_t *vector, float sine, float cosine,
    stator_f32_t *BESSEMER_RESTRICT stator)
{
    stator->alpha = cosine * vector->direct - sine * vector->quadrature;
    stator->beta = sine * vector->direct + cosine * vector->quadrature;
}

void drives_park_inverse_f64(const rotor_f64_t *vector, double sine, double cosine,
    stator_f64_t *BESSEMER_RESTRICT stator)
{
    stator->alpha = cosine * vector->direct - sine * vector->quadrature;
    stator->beta = sine * vector->direct + cosine * vector->quadrature;
}

void drives_space_vector_f32(const stator_f32_t *voltage, float supply,
    duties_f32_t *BESSEMER_RESTRICT duties)
{
    const float half = 0.5F;
    float phases[3];
    drives_clarke_inverse_f32(voltage, phases);
    const float a = phases[0];
    const float b = phases[1];
    const float c = phases[2];
    const float highest = max_f32(max_f32(a, b), c);
    const float lowest = min_f32(min_f32(a, b), c);
    const float middle = half * (highest + lowest);
    const float scale = 1.0F / supply;
    for (uint32_t i = 0U; i < 3U; i++) {
        const float phase = phases[i];
        duties->duties[i] = min_f32(max_f32(half + (phase - middle) * scale, 0.0F), 1.0F);
    }
    duties->is_limited = highest - lowest > supply;
}

void drives_space_vector_f64(const stator_f64_t *voltage, double supply,
    duties_f64_t *BESSEMER_RESTRICT duties)
{
    const double half = 0.5;
    double phases[3];
    drives_clarke_inverse_f64(voltage, phases);
    const double a = phases[0];
    const double b = phases[1];
    const double c = phases[2];
    const double highest = max_f64(max_f64(a, b), c);
    const double lowest = min_f64(min_f64(a, b), c);
    const double middle = half * (highest + lowest);
    const double scale = 1.0 / supply;
    for (uint32_t i = 0U; i < 3U; i++) {
        const double phase = phases[i];
        duties->duties[i] = min_f64(max_f64(half + (phase - middle) * scale, 0.0), 1.0);
    }
    duties->is_limited = highest - lowest > supply;
}

void drives_mtpa_f32(float current, float flux, float direct_inductance,
    float quadrature_inductance, rotor_f32_t *rotor)
{
    const float difference = quadrature_inductance - direct_inductance;
    const float square = current * current;
    const float root = sqrtf(flux * flux + 8.0F * difference * difference * square);
    const float direct = -2.0F * difference * square / (flux + root);
    const float quadrature = sqrtf(max_f32(square - direct * direct, 0.0F));
    rotor->direct = direct;
    rotor->quadrature = copysign_f32(quadrature, current);
}

/* drives.h */

/** Vector in the stator's frame. */
typedef struct {
    /** Component along phase A. */
    float alpha;
    /** Component 90° ahead. */
    float beta;
} stator_f32_t;

/** Vector in the stator's frame. */
typedef struct {
    /** Component along phase A. */
    double alpha;
    /** Component 90° ahead. */
    double beta;
} stator_f64_t;

/** Vector in the rotor's frame. */
typedef struct {
    /** Component along the flux of the magnet. */
    double direct;
    /** Component 90° ahead, which makes torque. */
    double quadrature;
} rotor_f64_t;

/** `([f64; 3], Rotor_f64)`. */
typedef struct {
    double first[3];
    rotor_f64_t second;
} pair_f64x3_rotor_f64_t;

/** Vector in the rotor's frame. */
typedef struct {
    /** Component along the flux of the magnet. */
    float direct;
    /** Component 90° ahead, which makes torque. */
    float quadrature;
} rotor_f32_t;

/** Duties of three half bridges. */
typedef struct {
    /** Share of the period in which each upper switch is on, 0 to 1. */
    float duties[3];
    /** True if the voltage was beyond the hexagon, so that duties were limited. */
    bool is_limited;
} duties_f32_t;

/** Duties of three half bridges. */
typedef struct {
    /** Share of the period in which each upper switch is on, 0 to 1. */
    double duties[3];
    /** True if the voltage was beyond the hexagon, so that duties were limited. */
    bool is_limited;
} duties_f64_t;

/** Gains of a `Pll`. For a natural frequency w in rad/s and a damping ζ: 2 ζ w and w². */
typedef struct {
    /** Gain of the angle. Unit: 1/s. */
    float proportional;
    /** Gain of the speed. Unit: 1/s². */
    float integral;
    /** Period h, above 0; gain · h stays below 1. Unit: s. */
    float period;
} pll_gains_f32_t;

/** Gains of a `Pll`. For a natural frequency w in rad/s and a damping ζ: 2 ζ w and w². */
typedef struct {
    /** Gain of the angle. Unit: 1/s. */
    double proportional;
    /** Gain of the speed. Unit: 1/s². */
    double integral;
    /** Period h, above 0; gain · h stays below 1. Unit: s. */
    double period;
} pll_gains_f64_t;

/** Motor of a `FluxObserver`. */
typedef struct {
    /** Resistance of a phase. Unit: Ω. */
    float resistance;
    /** Inductance of a phase, the same in both axes. Unit: H. */
    float inductance;
    /** Flux linkage of the magnet, above 0. Unit: Wb. */
    float flux;
    /** Gain γ of the correction: about 1000/flux². Unit: 1/(Wb²·s). */
    float gain;
    /** Period h, above 0. Unit: s. */
    float period;
} flux_parameters_f32_t;

/** Motor of a `FluxObserver`. */
typedef struct {
    /** Resistance of a phase. Unit: Ω. */
    double resistance;
    /** Inductance of a phase, the same in both axes. Unit: H. */
    double inductance;
    /** Flux linkage of the magnet, above 0. Unit: Wb. */
    double flux;
    /** Gain γ of the correction: about 1000/flux². Unit: 1/(Wb²·s). */
    double gain;
    /** Period h, above 0. Unit: s. */
    double period;
} flux_parameters_f64_t;

/* flux_observer_f32.c */

void flux_observer_f32_init(flux_observer_f32_t *self)
{
    self->flux.alpha = 0.0F;
    self->flux.beta = 0.0F;
    self->magnet.alpha = 0.0F;
    self->magnet.beta = 0.0F;
}

void flux_observer_f32_step(flux_observer_f32_t *BESSEMER_RESTRICT self,
    const flux_parameters_f32_t *motor, const stator_f32_t *voltage, const stator_f32_t *current,
    stator_f32_t *BESSEMER_RESTRICT stator)
{
    const float alpha = self->magnet.alpha;
    const float beta = self->magnet.beta;
    const float missing = motor->flux * motor->flux - alpha * alpha - beta * beta;
    const float correction = 0.5F * motor->gain * missing;
    const stator_f32_t flux = {
        .alpha = self->flux.alpha + motor->period
            * (voltage->alpha - motor->resistance * current->alpha + correction * alpha),
        .beta = self->flux.beta + motor->period
            * (voltage->beta - motor->resistance * current->beta + correction * beta)
    };
    const stator_f32_t magnet = {
        .alpha = flux.alpha - motor->inductance * current->alpha,
        .beta = flux.beta - motor->inductance * current->beta
    };
    if (isfinite(magnet.alpha) != 0 && isfinite(magnet.beta) != 0) {
        self->flux = flux;
        self->magnet = magnet;
    }
    *stator = self->magnet;
}

float flux_observer_f32_angle(const flux_observer_f32_t *self)
{
    return math_single_atan2f(self->magnet.beta, self->magnet.alpha);
}

void flux_observer_f32_preset(flux_observer_f32_t *BESSEMER_RESTRICT self,
    const flux_parameters_f32_t *motor, float angle)
{
    pair_f32_f32_t sine_cosine;
    math_single_sin_cosf(angle, &sine_cosine);
    self->magnet.alpha = motor->flux * sine_cosine.second;
    self->magnet.beta = motor->flux * sine_cosine.first;
    self->flux = self->magnet;
}

/* flux_observer_f32.h */

/**
 * Flux observer of a motor with surface magnets: the angle of the rotor from voltages and currents.
 *
 * With the stator's flux x and the magnet's flux η = x − L i: x' = v − R i + γ/2 η (ψ² − |η|²), by Euler's step. The
 * magnet's flux points along the rotor. It needs some speed: at rest the angle is undefined.
 *
 * Initialisation: `Default` has no flux; `FluxObserver::preset` begins at an angle. Saturation: none; the correction
 * limits |η| to about ψ if h·γ·ψ² is below 1. An input that is not finite is ignored. Source: Lee, Hong, Nam, Ortega, Praly
 * and Astolfi, *Sensorless Control of Surface-Mount Permanent-Magnet Synchronous Motors Based on a Nonlinear Observer*,
 * IEEE Transactions on Power Electronics 25 (2), 2010.
 *
 * ```
 * use bessemer_blocks::{FluxObserver, FluxParameters, Stator};
 *
 * let motor = FluxParameters { resistance: 0.1, inductance: 1e-4, flux: 0.01_f64, gain: 1e7, period: 1e-4 };
 * let mut observer = FluxObserver::default();
 * observer.preset(&motor, 0.0);
 * // No current: the voltage is the speed times the flux, 90° ahead of the magnet.
 * for k in 1..=1000 {
 *    let angle = 100.0 * 1e-4 * (f64::from(k) - 0.5);
 *    let voltage = Stator { alpha: -angle.sin(), beta: angle.cos() };
 *    observer.step(&motor, voltage, Stator::default());
 * }
 * assert!((observer.angle() - (10.0 - core::f64::consts::TAU - core::f64::consts::TAU)).abs() < 1e-3);
 * ```
 */
typedef struct {
    /** Flux of the stator. Unit: Wb. */
    stator_f32_t flux;
    /** Flux of the magnet. Unit: Wb. */
    stator_f32_t magnet;
} flux_observer_f32_t;

/* flux_observer_f64.c */

void flux_observer_f64_init(flux_observer_f64_t *self)
{
    self->flux.alpha = 0.0;
    self->flux.beta = 0.0;
    self->magnet.alpha = 0.0;
    self->magnet.beta = 0.0;
}

void flux_observer_f64_step(flux_observer_f64_t *BESSEMER_RESTRICT self,
    const flux_parameters_f64_t *motor, const stator_f64_t *voltage, const stator_f64_t *current,
    stator_f64_t *BESSEMER_RESTRICT stator)
{
    const double alpha = self->magnet.alpha;
    const double beta = self->magnet.beta;
    const double missing = motor->flux * motor->flux - alpha * alpha - beta * beta;
    const double correction = 0.5 * motor->gain * missing;
    const stator_f64_t flux = {
        .alpha = self->flux.alpha + motor->period
            * (voltage->alpha - motor->resistance * current->alpha + correction * alpha),
        .beta = self->flux.beta + motor->period
            * (voltage->beta - motor->resistance * current->beta + correction * beta)
    };
    const stator_f64_t magnet = {
        .alpha = flux.alpha - motor->inductance * current->alpha,
        .beta = flux.beta - motor->inductance * current->beta
    };
    if (isfinite(magnet.alpha) != 0 && isfinite(magnet.beta) != 0) {
        self->flux = flux;
        self->magnet = magnet;
    }
    *stator = self->magnet;
}

/* flux_observer_f64.h */

/**
 * Flux observer of a motor with surface magnets: the angle of the rotor from voltages and currents.
 *
 * With the stator's flux x and the magnet's flux η = x − L i: x' = v − R i + γ/2 η (ψ² − |η|²), by Euler's step. The
 * magnet's flux points along the rotor. It needs some speed: at rest the angle is undefined.
 *
 * Initialisation: `Default` has no flux; `FluxObserver::preset` begins at an angle. Saturation: none; the correction
 * limits |η| to about ψ if h·γ·ψ² is below 1. An input that is not finite is ignored. Source: Lee, Hong, Nam, Ortega, Praly
 * and Astolfi, *Sensorless Control of Surface-Mount Permanent-Magnet Synchronous Motors Based on a Nonlinear Observer*,
 * IEEE Transactions on Power Electronics 25 (2), 2010.
 *
 * ```
 * use bessemer_blocks::{FluxObserver, FluxParameters, Stator};
 *
 * let motor = FluxParameters { resistance: 0.1, inductance: 1e-4, flux: 0.01_f64, gain: 1e7, period: 1e-4 };
 * let mut observer = FluxObserver::default();
 * observer.preset(&motor, 0.0);
 * // No current: the voltage is the speed times the flux, 90° ahead of the magnet.
 * for k in 1..=1000 {
 *    let angle = 100.0 * 1e-4 * (f64::from(k) - 0.5);
 *    let voltage = Stator { alpha: -angle.sin(), beta: angle.cos() };
 *    observer.step(&motor, voltage, Stator::default());
 * }
 * assert!((observer.angle() - (10.0 - core::f64::consts::TAU - core::f64::consts::TAU)).abs() < 1e-3);
 * ```
 */
typedef struct {
    /** Flux of the stator. Unit: Wb. */
    stator_f64_t flux;
    /** Flux of the magnet. Unit: Wb. */
    stator_f64_t magnet;
} flux_observer_f64_t;

/* pll_f32.c */

static const float F32_TAU = 6.2831855F;

void pll_f32_init(pll_f32_t *self)
{
    self->angle = 0.0F;
    self->speed = 0.0F;
}

float pll_f32_step(pll_f32_t *BESSEMER_RESTRICT self, const pll_gains_f32_t *gains,
    const stator_f32_t *vector)
{
    pair_f32_f32_t sine_cosine;
    math_single_sin_cosf(self->angle, &sine_cosine);
    const float error = vector->beta * sine_cosine.second - vector->alpha * sine_cosine.first;
    float error_2;
    if (isfinite(error) != 0) {
        error_2 = error;
    } else {
        error_2 = 0.0F;
    }
    self->speed += gains->period * gains->integral * error_2;
    const float moved = self->angle + gains->period * (self->speed + gains->proportional * error_2);
    self->angle = moved - F32_TAU * roundf(moved / F32_TAU);
    return self->angle;
}

float pll_f32_speed(const pll_f32_t *self)
{
    return self->speed;
}

/* pll_f32.h */

/**
 * Phase-locked loop: follows the angle of a vector, and estimates its speed.
 *
 * With the error e = sin(angle of the vector − θ) by a product: speed += h Ki e, θ += h (speed + Kp e), wrapped to
 * −π … π. The vector's length should be about 1, since the gains are multiplied by it. Initialisation: `Default` is at
 * angle 0 and at rest. An input that is not finite moves the angle by the speed.
 *
 * ```
 * use bessemer_blocks::{Pll, PllGains, Stator};
 *
 * let gains = PllGains { proportional: 100.0_f64, integral: 2500.0, period: 0.001 };
 * let mut pll = Pll::default();
 * for k in 0..2000 {
 *    let angle = 0.02 * f64::from(k);
 *    pll.step(&gains, Stator { alpha: angle.cos(), beta: angle.sin() });
 * }
 * assert!((pll.speed() - 20.0).abs() < 1e-6);
 * ```
 */
typedef struct {
    /** Angle of the next period. Unit: rad. */
    float angle;
    /** Speed. Unit: rad/s. */
    float speed;
} pll_f32_t;

/* pll_f64.c */

static const double F64_TAU = 6.283185307179586;

void pll_f64_init(pll_f64_t *self)
{
    self->angle = 0.0;
    self->speed = 0.0;
}

double pll_f64_step(pll_f64_t *BESSEMER_RESTRICT self, const pll_gains_f64_t *gains,
    const stator_f64_t *vector)
{
    pair_f64_f64_t sine_cosine;
    sine_sin_cos(self->angle, &sine_cosine);
    const double error = vector->beta * sine_cosine.second - vector->alpha * sine_cosine.first;
    double error_2;
    if (isfinite(error) != 0) {
        error_2 = error;
    } else {
        error_2 = 0.0;
    }
    self->speed += gains->period * gains->integral * error_2;
    const double moved = self->angle
        + gains->period * (self->speed + gains->proportional * error_2);
    self->angle = moved - F64_TAU * round(moved / F64_TAU);
    return self->angle;
}

double pll_f64_speed(const pll_f64_t *self)
{
    return self->speed;
}

/* pll_f64.h */

/**
 * Phase-locked loop: follows the angle of a vector, and estimates its speed.
 *
 * With the error e = sin(angle of the vector − θ) by a product: speed += h Ki e, θ += h (speed + Kp e), wrapped to
 * −π … π. The vector's length should be about 1, since the gains are multiplied by it. Initialisation: `Default` is at
 * angle 0 and at rest. An input that is not finite moves the angle by the speed.
 *
 * ```
 * use bessemer_blocks::{Pll, PllGains, Stator};
 *
 * let gains = PllGains { proportional: 100.0_f64, integral: 2500.0, period: 0.001 };
 * let mut pll = Pll::default();
 * for k in 0..2000 {
 *    let angle = 0.02 * f64::from(k);
 *    pll.step(&gains, Stator { alpha: angle.cos(), beta: angle.sin() });
 * }
 * assert!((pll.speed() - 20.0).abs() < 1e-6);
 * ```
 */
typedef struct {
    /** Angle of the next period. Unit: rad. */
    double angle;
    /** Speed. Unit: rad/s. */
    double speed;
} pll_f64_t;
