/* The C of blocks/src/trajectories.rs. Written by a test. */

/* trajectories.c */

static const point_f32_t TRAJECTORIES_POINT_DEFAULT = {
    .position = 0.0F,
    .speed = 0.0F,
    .acceleration = 0.0F,
    .jerk = 0.0F
};
static const point_f64_t TRAJECTORIES_POINT_DEFAULT_2 = {
    .position = 0.0,
    .speed = 0.0,
    .acceleration = 0.0,
    .jerk = 0.0
};

static void trajectories_evaluated_f64_6(const double coefficients[6], double duration, double time,
    point_f64_t *BESSEMER_RESTRICT point);
static void trajectories_evaluated_f64_8(const double coefficients[8], double duration, double time,
    point_f64_t *BESSEMER_RESTRICT point);

void trapezoid_f64_plan(double distance, double speed, double acceleration,
    trapezoid_f64_t *trapezoid)
{
    const double length = fabs(distance);
    const double highest = min_f64(speed, sqrt(length * acceleration));
    const double ramp = highest / acceleration;
    double cruise;
    if (highest > 0.0) {
        cruise = max_f64(length / highest - ramp, 0.0);
    } else {
        cruise = 0.0;
    }
    trapezoid->distance = distance;
    trapezoid->acceleration = copysign_f64(acceleration, distance);
    trapezoid->ramp = ramp;
    trapezoid->cruise = cruise;
}

double trapezoid_f64_duration(const trapezoid_f64_t *self)
{
    return 2.0 * self->ramp + self->cruise;
}

void trapezoid_f64_at(const trapezoid_f64_t *self, double time,
    point_f64_t *BESSEMER_RESTRICT point)
{
    const double half = 0.5;
    const double left = trapezoid_f64_duration(self) - time;
    const bool first = time < half * trapezoid_f64_duration(self);

    /* The second half is the first one from the end. */
    double from;
    if (first) {
        from = time;
    } else {
        from = left;
    }
    if (from <= 0.0 || isnan(from) != 0) {
        double position;
        if (first) {
            position = 0.0;
        } else {
            position = self->distance;
        }
        point_f64_t point_value = TRAJECTORIES_POINT_DEFAULT_2;
        point_value.position = position;
        *point = point_value;
        return;
    }
    const bool rising = from < self->ramp;
    double acceleration;
    if (rising) {
        acceleration = self->acceleration;
    } else {
        acceleration = 0.0;
    }
    const double speed = self->acceleration * min_f64(from, self->ramp);
    const double beyond = max_f64(from - self->ramp, 0.0);
    const double way = half * speed * min_f64(from, self->ramp) + speed * beyond;
    double result_choice;
    if (first) {
        result_choice = way;
    } else {
        result_choice = self->distance - way;
    }
    double result_choice_2;
    if (first) {
        result_choice_2 = acceleration;
    } else {
        result_choice_2 = -acceleration;
    }
    point->position = result_choice;
    point->speed = speed;
    point->acceleration = result_choice_2;
    point->jerk = 0.0;
}

void s_curve_f32_plan(float distance, float speed, float acceleration, float jerk,
    s_curve_f32_t *scurve)
{
    const float half = 0.5F;
    const float two = 2.0F;
    const float length = fabsf(distance);
    const bool full = speed * jerk >= acceleration * acceleration;
    float bend;
    if (full) {
        bend = acceleration / jerk;
    } else {
        bend = sqrtf(speed / jerk);
    }
    float ramp;
    if (full) {
        ramp = bend + speed / acceleration;
    } else {
        ramp = two * bend;
    }
    float cruise = length / speed - ramp;
    if (cruise < 0.0F) {
        /* The speed limit is not reached. */
        cruise = 0.0F;
        const float short_ = two * acceleration * acceleration * acceleration / (jerk * jerk);
        if (length >= short_) {
            bend = acceleration / jerk;
            ramp = half * bend + sqrtf(half * half * bend * bend + length / acceleration);
        } else {
            bend = math_single_cbrtf(length / (two * jerk));
            ramp = two * bend;
        }
    }
    scurve->distance = distance;
    scurve->jerk = copysign_f32(jerk, distance);
    scurve->bend = bend;
    scurve->ramp = ramp;
    scurve->cruise = cruise;
}

void s_curve_f64_plan(double distance, double speed, double acceleration, double jerk,
    s_curve_f64_t *scurve)
{
    const double half = 0.5;
    const double two = 2.0;
    const double length = fabs(distance);
    const bool full = speed * jerk >= acceleration * acceleration;
    double bend;
    if (full) {
        bend = acceleration / jerk;
    } else {
        bend = sqrt(speed / jerk);
    }
    double ramp;
    if (full) {
        ramp = bend + speed / acceleration;
    } else {
        ramp = two * bend;
    }
    double cruise = length / speed - ramp;
    if (cruise < 0.0) {
        /* The speed limit is not reached. */
        cruise = 0.0;
        const double short_ = two * acceleration * acceleration * acceleration / (jerk * jerk);
        if (length >= short_) {
            bend = acceleration / jerk;
            ramp = half * bend + sqrt(half * half * bend * bend + length / acceleration);
        } else {
            bend = roots_cbrt(length / (two * jerk));
            ramp = two * bend;
        }
    }
    scurve->distance = distance;
    scurve->jerk = copysign_f64(jerk, distance);
    scurve->bend = bend;
    scurve->ramp = ramp;
    scurve->cruise = cruise;
}

float s_curve_f32_duration(const s_curve_f32_t *self)
{
    return 2.0F * self->ramp + self->cruise;
}

double s_curve_f64_duration(const s_curve_f64_t *self)
{
    return 2.0 * self->ramp + self->cruise;
}

void s_curve_f32_at(const s_curve_f32_t *self, float time, point_f32_t *BESSEMER_RESTRICT point)
{
    const float half = 0.5F;
    const float left = s_curve_f32_duration(self) - time;
    const bool first = time < half * s_curve_f32_duration(self);

    /*
     * The second half is the first one from the end: position and acceleration with the other sign.
     */
    float from;
    if (first) {
        from = time;
    } else {
        from = left;
    }
    if (from <= 0.0F || isnan(from) != 0) {
        float position;
        if (first) {
            position = 0.0F;
        } else {
            position = self->distance;
        }
        point_f32_t point_value = TRAJECTORIES_POINT_DEFAULT;
        point_value.position = position;
        *point = point_value;
        return;
    }
    const float highest = self->jerk * self->bend * (self->ramp - self->bend);
    const float sixth = self->jerk / 6.0F;
    point_f32_t point_value;
    if (from < self->bend) {
        point_value.position = sixth * from * from * from;
        point_value.speed = half * self->jerk * from * from;
        point_value.acceleration = self->jerk * from;
        point_value.jerk = self->jerk;
    } else if (from < self->ramp - self->bend) {
        const float acceleration = self->jerk * self->bend;
        const float three = 3.0F;
        const float way = three * from * from - three * self->bend * from + self->bend * self->bend;
        point_value.position = acceleration / 6.0F * way;
        point_value.speed = acceleration * (from - half * self->bend);
        point_value.acceleration = acceleration;
        point_value.jerk = 0.0F;
    } else if (from < self->ramp) {
        const float rest = self->ramp - from;
        point_value.position = half * highest * self->ramp - highest * rest
            + sixth * rest * rest * rest;
        point_value.speed = highest - half * self->jerk * rest * rest;
        point_value.acceleration = self->jerk * rest;
        point_value.jerk = -self->jerk;
    } else {
        const float position = half * highest * self->ramp + highest * (from - self->ramp);
        point_f32_t point_value_2 = TRAJECTORIES_POINT_DEFAULT;
        point_value_2.position = position;
        point_value_2.speed = highest;
        point_value = point_value_2;
    }
    if (!first) {
        point_value.position = self->distance - point_value.position;
        point_value.acceleration = -point_value.acceleration;
    }
    *point = point_value;
}

void s_curve_f64_at(const s_curve_f64_t *self, double time, point_f64_t *BESSEMER_RESTRICT point)
{
    const double half = 0.5;
    const double left = s_curve_f64_duration(self) - time;
    const bool first = time < half * s_curve_f64_duration(self);

    /*
     * The second half is the first one from the end: position and acceleration with the other sign.
     */
    double from;
    if (first) {
        from = time;
    } else {
        from = left;
    }
    if (from <= 0.0 || isnan(from) != 0) {
        double position;
        if (first) {
            position = 0.0;
        } else {
            position = self->distance;
        }
        point_f64_t point_value = TRAJECTORIES_POINT_DEFAULT_2;
        point_value.position = position;
        *point = point_value;
        return;
    }
    const double highest = self->jerk * self->bend * (self->ramp - self->bend);
    const double sixth = self->jerk / 6.0;
    point_f64_t point_value;
    if (from < self->bend) {
        point_value.position = sixth * from * from * from;
        point_value.speed = half * self->jerk * from * from;
        point_value.acceleration = self->jerk * from;
        point_value.jerk = self->jerk;
    } else if (from < self->ramp - self->bend) {
        const double acceleration = self->jerk * self->bend;
        const double three = 3.0;
        const double way = three * from * from - three * self->bend * from
            + self->bend * self->bend;
        point_value.position = acceleration / 6.0 * way;
        point_value.speed = acceleration * (from - half * self->bend);
        point_value.acceleration = acceleration;
        point_value.jerk = 0.0;
    } else if (from < self->ramp) {
        const double rest = self->ramp - from;
        point_value.position = half * highest * self->ramp - highest * rest
            + sixth * rest * rest * rest;
        point_value.speed = highest - half * self->jerk * rest * rest;
        point_value.acceleration = self->jerk * rest;
        point_value.jerk = -self->jerk;
    } else {
        const double position = half * highest * self->ramp + highest * (from - self->ramp);
        point_f64_t point_value_2 = TRAJECTORIES_POINT_DEFAULT_2;
        point_value_2.position = position;
        point_value_2.speed = highest;
        point_value = point_value_2;
    }
    if (!first) {
        point_value.position = self->distance - point_value.position;
        point_value.acceleration = -point_value.acceleration;
    }
    *point = point_value;
}

void minimum_jerk_f64_between(const point_f64_t *from, const point_f64_t *to, double duration,
    minimum_jerk_f64_t *BESSEMER_RESTRICT minimum_jerk)
{
    const double half = 0.5;
    const double square = duration * duration;
    const double c0 = from->position;
    const double c1 = from->speed * duration;
    const double c2 = half * from->acceleration * square;
    const double position = to->position - c0 - c1 - c2;
    const double speed = to->speed * duration - c1 - 2.0 * c2;
    const double bend = half * (to->acceleration * square - 2.0 * c2);
    minimum_jerk->coefficients[0] = c0;
    minimum_jerk->coefficients[1] = c1;
    minimum_jerk->coefficients[2] = c2;
    minimum_jerk->coefficients[3] = 10.0 * position - 4.0 * speed + bend;
    minimum_jerk->coefficients[4] = -15.0 * position + 7.0 * speed - 2.0 * bend;
    minimum_jerk->coefficients[5] = 6.0 * position - 3.0 * speed + bend;
    minimum_jerk->duration = duration;
}

void minimum_jerk_f64_at(const minimum_jerk_f64_t *self, double time,
    point_f64_t *BESSEMER_RESTRICT point)
{
    trajectories_evaluated_f64_6(self->coefficients, self->duration, time, point);
}

void minimum_snap_f64_between(const point_f64_t *from, const point_f64_t *to, double duration,
    minimum_snap_f64_t *BESSEMER_RESTRICT minimum_snap)
{
    const double half = 0.5;
    const double two = 2.0;
    const double six = 6.0;
    const double square = duration * duration;
    const double cube = square * duration;
    const double c0 = from->position;
    const double c1 = from->speed * duration;
    const double c2 = half * from->acceleration * square;
    const double c3 = from->jerk * cube / six;
    const double position = to->position - c0 - c1 - c2 - c3;
    const double speed = to->speed * duration - c1 - two * c2 - 3.0 * c3;
    const double bend = half * (to->acceleration * square - two * c2 - six * c3);
    const double jerk = (to->jerk * cube - six * c3) / six;
    minimum_snap->coefficients[0] = c0;
    minimum_snap->coefficients[1] = c1;
    minimum_snap->coefficients[2] = c2;
    minimum_snap->coefficients[3] = c3;
    minimum_snap->coefficients[4] = 35.0 * position - 15.0 * speed + 5.0 * bend - jerk;
    minimum_snap->coefficients[5] = -84.0 * position + 39.0 * speed - 14.0 * bend + 3.0 * jerk;
    minimum_snap->coefficients[6] = 70.0 * position - 34.0 * speed + 13.0 * bend - 3.0 * jerk;
    minimum_snap->coefficients[7] = -20.0 * position + 10.0 * speed - 4.0 * bend + jerk;
    minimum_snap->duration = duration;
}

void minimum_snap_f64_at(const minimum_snap_f64_t *self, double time,
    point_f64_t *BESSEMER_RESTRICT point)
{
    trajectories_evaluated_f64_8(self->coefficients, self->duration, time, point);
}

/** Returns the state on a polynomial of the time divided by the duration, by Horner's rule. */
static void trajectories_evaluated_f64_6(const double coefficients[6], double duration, double time,
    point_f64_t *BESSEMER_RESTRICT point)
{
    const double at = min_f64(max_f64(time / duration, 0.0), 1.0);
    double value = 0.0;
    double first = 0.0;
    double second = 0.0;
    double third = 0.0;
    for (uint32_t i = 6U; i-- > 0U;) {
        third = third * at + 3.0 * second;
        second = second * at + 2.0 * first;
        first = first * at + value;
        value = value * at + coefficients[i];
    }
    const double rate = 1.0 / duration;
    point->position = value;
    point->speed = first * rate;
    point->acceleration = second * rate * rate;
    point->jerk = third * rate * rate * rate;
}

/** Returns the state on a polynomial of the time divided by the duration, by Horner's rule. */
static void trajectories_evaluated_f64_8(const double coefficients[8], double duration, double time,
    point_f64_t *BESSEMER_RESTRICT point)
{
    const double at = min_f64(max_f64(time / duration, 0.0), 1.0);
    double value = 0.0;
    double first = 0.0;
    double second = 0.0;
    double third = 0.0;
    for (uint32_t i = 8U; i-- > 0U;) {
        third = third * at + 3.0 * second;
        second = second * at + 2.0 * first;
        first = first * at + value;
        value = value * at + coefficients[i];
    }
    const double rate = 1.0 / duration;
    point->position = value;
    point->speed = first * rate;
    point->acceleration = second * rate * rate;
    point->jerk = third * rate * rate * rate;
}

/* trajectories.h */

/** State on a trajectory. */
typedef struct {
    /** Position, U. */
    float position;
    /** Speed, U/s. */
    float speed;
    /** Acceleration, U/s². */
    float acceleration;
    /** Jerk, U/s³. */
    float jerk;
} point_f32_t;

/** State on a trajectory. */
typedef struct {
    /** Position, U. */
    double position;
    /** Speed, U/s. */
    double speed;
    /** Acceleration, U/s². */
    double acceleration;
    /** Jerk, U/s³. */
    double jerk;
} point_f64_t;

/**
 * Trajectory of three segments from rest to rest: constant acceleration, constant speed, constant deceleration.
 *
 * Saturation: a short distance does not reach the speed limit and has no middle segment.
 *
 * ```
 * use bessemer_blocks::Trapezoid;
 *
 * let trapezoid = Trapezoid::plan(6.0, 2.0, 1.0);
 * assert_eq!(trapezoid.duration(), 5.0);
 * assert_eq!((trapezoid.at(1.0).position, trapezoid.at(2.5).speed, trapezoid.at(9.0).position), (0.5, 2.0, 6.0));
 * ```
 */
typedef struct {
    /** Distance, with its sign, U. */
    double distance;
    /** Acceleration of the first segment, with its sign, U/s². */
    double acceleration;
    /** Duration of the first and of the last segment. Unit: s. */
    double ramp;
    /** Duration of the middle segment. Unit: s. */
    double cruise;
} trapezoid_f64_t;

/**
 * S-curve: seven segments from rest to rest with a limited jerk.
 *
 * Saturation: a short distance reaches neither the speed limit nor, if it is shorter still, the acceleration's.
 *
 * ```
 * use bessemer_blocks::SCurve;
 *
 * let curve = SCurve::plan(10.0, 5.0, 10.0, 40.0);
 * assert_eq!((curve.duration(), curve.at(1.375).speed, curve.at(9.0).position), (2.75, 5.0, 10.0));
 * ```
 */
typedef struct {
    /** Distance, with its sign, U. */
    float distance;
    /** Jerk of the first segment, with its sign, U/s³. */
    float jerk;
    /** Duration of a segment with jerk. Unit: s. */
    float bend;
    /** Duration of the acceleration, its two bends included. Unit: s. */
    float ramp;
    /** Duration of the segment with constant speed. Unit: s. */
    float cruise;
} s_curve_f32_t;

/**
 * S-curve: seven segments from rest to rest with a limited jerk.
 *
 * Saturation: a short distance reaches neither the speed limit nor, if it is shorter still, the acceleration's.
 *
 * ```
 * use bessemer_blocks::SCurve;
 *
 * let curve = SCurve::plan(10.0, 5.0, 10.0, 40.0);
 * assert_eq!((curve.duration(), curve.at(1.375).speed, curve.at(9.0).position), (2.75, 5.0, 10.0));
 * ```
 */
typedef struct {
    /** Distance, with its sign, U. */
    double distance;
    /** Jerk of the first segment, with its sign, U/s³. */
    double jerk;
    /** Duration of a segment with jerk. Unit: s. */
    double bend;
    /** Duration of the acceleration, its two bends included. Unit: s. */
    double ramp;
    /** Duration of the segment with constant speed. Unit: s. */
    double cruise;
} s_curve_f64_t;

/**
 * Motion with minimum jerk between two states: the polynomial of fifth degree.
 *
 * It has the smallest integral of the squared jerk of all motions between the two positions, speeds and accelerations.
 * The jerk of the ends is not used. Range: a duration above 0.
 *
 * ```
 * use bessemer_blocks::{MinimumJerk, Point};
 *
 * let end = Point { position: 2.0, ..Point::default() };
 * let motion = MinimumJerk::between(&Point::default(), &end, 4.0);
 * assert_eq!((motion.at(2.0).position, motion.at(2.0).speed, motion.at(5.0).position), (1.0, 0.9375, 2.0));
 * ```
 */
typedef struct {
    /** Coefficients of the powers 0 to 5 of the time divided by the duration. */
    double coefficients[6];
    /** Duration. Unit: s. */
    double duration;
} minimum_jerk_f64_t;

/**
 * Motion with minimum snap between two states: the polynomial of seventh degree.
 *
 * It has the smallest integral of the squared snap, the fourth derivative, of all motions between the two positions,
 * speeds, accelerations and jerks. Range: a duration above 0.
 *
 * ```
 * use bessemer_blocks::{MinimumSnap, Point};
 *
 * let end = Point { position: 2.0, ..Point::default() };
 * let motion = MinimumSnap::between(&Point::default(), &end, 4.0);
 * assert_eq!((motion.at(2.0).position, motion.at(2.0).speed, motion.at(5.0).position), (1.0, 1.09375, 2.0));
 * ```
 */
typedef struct {
    /** Coefficients of the powers 0 to 7 of the time divided by the duration. */
    double coefficients[8];
    /** Duration. Unit: s. */
    double duration;
} minimum_snap_f64_t;
