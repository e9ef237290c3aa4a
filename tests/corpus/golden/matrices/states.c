/* The C of tests/corpus/src/programs/matrices/states.rs. Written by a test. */

/* estimate.c */

void estimate_init(estimate_t *self)
{
    self->motion.attitude.i = 0.0;
    self->motion.attitude.j = 0.0;
    self->motion.attitude.k = 0.0;
    self->motion.attitude.w = 1.0;
    self->motion.velocity[0] = 0.0;
    self->motion.velocity[1] = 0.0;
    self->motion.velocity[2] = 0.0;
    self->motion.bias = 0.0;
}

double estimate_correct(estimate_t *BESSEMER_RESTRICT self, const double errors[7])
{
    states_motion_t motion_next;
    states_motion_retracted(&self->motion, errors, &motion_next);
    self->motion = motion_next;
    return errors[STATES_MOTION_VELOCITY + 2U];
}

void estimate_errors(const estimate_t *self, const states_motion_t *truth,
    double result[BESSEMER_RESTRICT 7])
{
    states_motion_difference(truth, &self->motion, result);
}

/* estimate.h */

/** An estimate of motion. */
typedef struct {
    states_motion_t motion;
} estimate_t;

/* states.c */

static const uint64_t SEGMENTS = UINT64_C(3);

void states_motion_difference(const states_motion_t *self, const states_motion_t *from,
    double errors[BESSEMER_RESTRICT 7])
{
    unit_quaternion_f64_t attitude_change_first;
    unit_quaternion_inverse_f64(&from->attitude, &attitude_change_first);
    unit_quaternion_f64_t attitude_change;
    unit_quaternion_product_f64(&attitude_change_first, &self->attitude, &attitude_change);
    double attitude_turn[3];
    rotation_scaled_axis_f64(&attitude_change, attitude_turn);
    for (uint32_t n = 0U; n < 3U; n++) {
        errors[STATES_MOTION_ATTITUDE + n] = attitude_turn[n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        errors[STATES_MOTION_VELOCITY + n] = self->velocity[n] - from->velocity[n];
    }
    errors[STATES_MOTION_BIAS] = self->bias - from->bias;
}

void states_motion_retracted(const states_motion_t *self, const double errors[7],
    states_motion_t *BESSEMER_RESTRICT moved)
{
    *moved = *self;
    const double attitude_turn[3] = {
        errors[STATES_MOTION_ATTITUDE], errors[STATES_MOTION_ATTITUDE + 1U],
        errors[STATES_MOTION_ATTITUDE + 2U]
    };
    unit_quaternion_f64_t attitude_second;
    rotation_from_scaled_axis_f64(attitude_turn, &attitude_second);
    unit_quaternion_product_f64(&self->attitude, &attitude_second, &moved->attitude);
    for (uint32_t n = 0U; n < 3U; n++) {
        moved->velocity[n] += errors[STATES_MOTION_VELOCITY + n];
    }
    moved->bias += errors[STATES_MOTION_BIAS];
}

void beam_difference(const beam_t *self, const beam_t *from, float errors[BESSEMER_RESTRICT 4])
{
    for (uint32_t n = 0U; n < SEGMENTS; n++) {
        errors[STATES_BEAM_SEGMENTS + n] = self->segments[n] - from->segments[n];
    }
    errors[STATES_BEAM_HEATER] = self->heater - from->heater;
}

void beam_of_vector(const float vector[4], beam_t *BESSEMER_RESTRICT beam)
{
    beam->segments[0] = vector[STATES_BEAM_SEGMENTS];
    beam->segments[1] = vector[STATES_BEAM_SEGMENTS + 1U];
    beam->segments[2] = vector[STATES_BEAM_SEGMENTS + 2U];
    beam->heater = vector[STATES_BEAM_HEATER];
}

void beam_retracted(const beam_t *self, const float errors[4], beam_t *BESSEMER_RESTRICT moved)
{
    *moved = *self;
    for (uint32_t n = 0U; n < SEGMENTS; n++) {
        const uint32_t segments_index = (uint32_t)(STATES_BEAM_SEGMENTS + n);
        moved->segments[n] += errors[segments_index];
    }
    moved->heater += errors[STATES_BEAM_HEATER];
}

void beam_vector(const beam_t *self, float vector[BESSEMER_RESTRICT 4])
{
    for (uint32_t n = 0U; n < SEGMENTS; n++) {
        vector[STATES_BEAM_SEGMENTS + n] = self->segments[n];
    }
    vector[STATES_BEAM_HEATER] = self->heater;
}

void axis_f64_retracted(const axis_f64_t *self, const double errors[3],
    axis_f64_t *BESSEMER_RESTRICT moved)
{
    *moved = *self;
    moved->angle += errors[STATES_AXIS_F64_ANGLE];
    for (uint32_t n = 0U; n < 2U; n++) {
        moved->rates[n] += errors[STATES_AXIS_F64_RATES + n];
    }
}

void single_axis_difference(const single_axis_t *self, const single_axis_t *from,
    float errors[BESSEMER_RESTRICT 3])
{
    errors[STATES_AXIS_F64_ANGLE] = self->angle - from->angle;
    for (uint32_t n = 0U; n < 2U; n++) {
        errors[STATES_SINGLE_AXIS_RATES + n] = self->rates[n] - from->rates[n];
    }
}

void single_axis_of_vector(const float vector[3], single_axis_t *BESSEMER_RESTRICT single_axis)
{
    single_axis->angle = vector[STATES_AXIS_F64_ANGLE];
    single_axis->rates[0] = vector[STATES_SINGLE_AXIS_RATES];
    single_axis->rates[1] = vector[STATES_SINGLE_AXIS_RATES + 1U];
}

void single_axis_retracted(const single_axis_t *self, const float errors[3],
    single_axis_t *BESSEMER_RESTRICT moved)
{
    *moved = *self;
    moved->angle += errors[STATES_AXIS_F64_ANGLE];
    for (uint32_t n = 0U; n < 2U; n++) {
        moved->rates[n] += errors[STATES_SINGLE_AXIS_RATES + n];
    }
}

void single_axis_vector(const single_axis_t *self, float vector[BESSEMER_RESTRICT 3])
{
    vector[STATES_AXIS_F64_ANGLE] = self->angle;
    for (uint32_t n = 0U; n < 2U; n++) {
        vector[STATES_SINGLE_AXIS_RATES + n] = self->rates[n];
    }
}

void states_heated(const float values[4], float by,
    pair_vector4_f32_vector4_f32_t *BESSEMER_RESTRICT result)
{
    beam_t beam;
    beam_of_vector(values, &beam);
    beam_t warmer = beam;
    warmer.heater += by;
    warmer.segments[0] += by;
    beam_vector(&warmer, result->first);
    beam_difference(&warmer, &beam, result->second);
}

void states_turned(const axis_f64_t *axis, const double errors[3],
    axis_f64_t *BESSEMER_RESTRICT result)
{
    axis_f64_retracted(axis, errors, result);
}

/* states.h */

/** State of a vehicle. */
typedef struct {
    /** From the body's frame to the world's. */
    unit_quaternion_f64_t attitude;
    /** Velocity, m/s. */
    double velocity[3];
    /** Bias of the barometer, m. */
    double bias;
} states_motion_t;

/** State of a heated beam. */
typedef struct {
    /** Temperatures of the segments, °C. */
    float segments[3];
    /** Temperature of the heater, °C. */
    float heater;
} beam_t;

/** State of an axis in either precision. */
typedef struct {
    /** Angle, rad. */
    double angle;
    /** Rates of both gyroscopes, rad/s. */
    double rates[2];
} axis_f64_t;

/** State of an axis in single precision. */
typedef struct {
    /** Angle, rad. */
    float angle;
    /** Rates of both gyroscopes, rad/s. */
    float rates[2];
} single_axis_t;
