/* The C of tests/corpus/src/programs/blocks/driving.rs. Written by a test. */

/* driving.c */

void driving_frames(double direct, double quadrature, double angle, pair_f64x3_rotor_f64_t *result)
{
    pair_f64_f64_t sine_cosine;
    sine_sin_cos(angle, &sine_cosine);
    const rotor_f64_t phases_vector = {.direct = direct, .quadrature = quadrature};
    stator_f64_t phases_vector_2;
    drives_park_inverse_f64(&phases_vector, sine_cosine.first, sine_cosine.second,
        &phases_vector_2);
    drives_clarke_inverse_f64(&phases_vector_2, result->first);
    stator_f64_t result_vector;
    drives_clarke_f64(result->first[0], result->first[1], &result_vector);
    drives_park_f64(&result_vector, sine_cosine.first, sine_cosine.second, &result->second);
}

/* driving.h */

/** Parameters of the drive. */
typedef struct {
    /** Loops of the currents, V for A. */
    pid_parameters_f32_t current;
    /** Observer of the flux. */
    flux_parameters_f32_t observer;
    /** Loop that follows the flux. */
    pll_gains_f32_t pll;
    /** Inductance across the flux. Unit: H. */
    float quadrature_inductance;
} drive_parameters_t;

/* resolver.c */

static const stator_f64_t STATOR_DEFAULT = {.alpha = 0.0, .beta = 0.0};

void resolver_init(resolver_t *self)
{
    pll_f64_init(&self->pll);
    flux_observer_f64_init(&self->observer);
}

void resolver_step(resolver_t *BESSEMER_RESTRICT self, const pll_gains_f64_t *gains,
    const flux_parameters_f64_t *motor, const stator_f64_t *vector,
    pair_f64_f64_t *BESSEMER_RESTRICT result)
{
    const double angle = pll_f64_step(&self->pll, gains, vector);
    stator_f64_t flux;
    flux_observer_f64_step(&self->observer, motor, vector, &STATOR_DEFAULT, &flux);
    const double result_speed = pll_f64_speed(&self->pll);
    duties_f64_t duties;
    drives_space_vector_f64(&flux, 24.0, &duties);
    result->first = angle;
    result->second = result_speed + duties.duties[0];
}

/* resolver.h */

/** Follows a resolver. */
typedef struct {
    pll_f64_t pll;
    flux_observer_f64_t observer;
} resolver_t;

/* sensorless.c */

void sensorless_init(sensorless_t *self)
{
    pid_pid_f32_init(&self->direct);
    pid_pid_f32_init(&self->quadrature);
    flux_observer_f32_init(&self->observer);
    pll_f32_init(&self->pll);
    self->voltage.alpha = 0.0F;
    self->voltage.beta = 0.0F;
}

void sensorless_step(sensorless_t *BESSEMER_RESTRICT self, const drive_parameters_t *parameters,
    float wanted, const float currents[2], float supply, duties_f32_t *BESSEMER_RESTRICT duties)
{
    stator_f32_t current;
    drives_clarke_f32(currents[0], currents[1], &current);
    stator_f32_t flux;
    flux_observer_f32_step(&self->observer, &parameters->observer, &self->voltage, &current, &flux);
    const float scale = 1.0F / parameters->observer.flux;
    const stator_f32_t unit = {.alpha = flux.alpha * scale, .beta = flux.beta * scale};
    const float sine_cosine_x = pll_f32_step(&self->pll, &parameters->pll, &unit);
    pair_f32_f32_t sine_cosine;
    math_single_sin_cosf(sine_cosine_x, &sine_cosine);
    rotor_f32_t is;
    drives_park_f32(&current, sine_cosine.first, sine_cosine.second, &is);
    rotor_f32_t wanted_2;
    drives_mtpa_f32(wanted, parameters->observer.flux, parameters->observer.inductance,
        parameters->quadrature_inductance, &wanted_2);
    const float voltage_direct = pid_pid_f32_step(&self->direct, &parameters->current,
        wanted_2.direct, is.direct);
    const float voltage_quadrature = pid_pid_f32_step(&self->quadrature, &parameters->current,
        wanted_2.quadrature, is.quadrature);
    const rotor_f32_t voltage = {.direct = voltage_direct, .quadrature = voltage_quadrature};
    drives_park_inverse_f32(&voltage, sine_cosine.first, sine_cosine.second, &self->voltage);
    drives_space_vector_f32(&self->voltage, supply, duties);
}

float sensorless_speed(const sensorless_t *self)
{
    return pll_f32_speed(&self->pll);
}

float sensorless_align(sensorless_t *BESSEMER_RESTRICT self, const drive_parameters_t *parameters,
    float angle)
{
    flux_observer_f32_preset(&self->observer, &parameters->observer, angle);
    return flux_observer_f32_angle(&self->observer);
}

/* sensorless.h */

/** Controls the torque of a motor. */
typedef struct {
    pid_pid_f32_t direct;
    pid_pid_f32_t quadrature;
    flux_observer_f32_t observer;
    pll_f32_t pll;
    /** Voltage of the last period. */
    stator_f32_t voltage;
} sensorless_t;
