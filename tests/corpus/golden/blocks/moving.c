/* The C of tests/corpus/src/programs/blocks/moving.rs. Written by a test. */

/* moved_axis.c */

void moved_axis_init(moved_axis_t *self)
{
    self->curve.distance = 0.0F;
    self->curve.jerk = 0.0F;
    self->curve.bend = 0.0F;
    self->curve.ramp = 0.0F;
    self->curve.cruise = 0.0F;
    self->start = 0.0F;
    self->time = 0.0F;
}

void moved_axis_start(moved_axis_t *self, float from, float to)
{
    s_curve_f32_plan(to - from, 0.5F, 2.0F, 20.0F, &self->curve);
    self->start = from;
    self->time = 0.0F;
}

void moved_axis_step(moved_axis_t *BESSEMER_RESTRICT self, point_f32_t *BESSEMER_RESTRICT point)
{
    self->time = min_f32(self->time + 0.001F, s_curve_f32_duration(&self->curve));
    s_curve_f32_at(&self->curve, self->time, point);
    point->position += self->start;
}

/* moved_axis.h */

/** Moves an axis to a target with limited jerk. */
typedef struct {
    s_curve_f32_t curve;
    float start;
    float time;
} moved_axis_t;

/* moving.c */

void moving_three_segments(double distance, double speed, double acceleration, double time,
    point_f64_t *point)
{
    trapezoid_f64_t trapezoid;
    trapezoid_f64_plan(distance, speed, acceleration, &trapezoid);
    trapezoid_f64_at(&trapezoid, time * trapezoid_f64_duration(&trapezoid), point);
}

void moving_s_curve(double distance, const double limits[3], double time,
    point_f64_t *BESSEMER_RESTRICT point)
{
    s_curve_f64_t curve;
    s_curve_f64_plan(distance, limits[0], limits[1], limits[2], &curve);
    s_curve_f64_at(&curve, time * s_curve_f64_duration(&curve), point);
}

void moving_smoothest(const point_f64_t *from, const point_f64_t *to, double duration, double time,
    point_f64_t result[BESSEMER_RESTRICT 2])
{
    minimum_jerk_f64_t result_self;
    minimum_jerk_f64_between(from, to, duration, &result_self);
    point_f64_t result_at;
    minimum_jerk_f64_at(&result_self, time, &result_at);
    minimum_snap_f64_t result_self_2;
    minimum_snap_f64_between(from, to, duration, &result_self_2);
    point_f64_t result_at_2;
    minimum_snap_f64_at(&result_self_2, time, &result_at_2);
    result[0] = result_at;
    result[1] = result_at_2;
}
