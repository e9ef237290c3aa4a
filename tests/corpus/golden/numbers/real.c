/* The C of tests/corpus/src/programs/numbers/real.rs. Written by a test. */

/* real.c */

static const double F64_PI = 3.141592653589793;

static float real_height_of_f32(float speed, float angle, float t);
static double real_height_of_f64(double speed, double angle, double t);

/** The height of a projectile after `t` seconds, m. */
static float real_height_of_f32(float speed, float angle, float t)
{
    const float fall = f32_from_f64(0.5 * 9.81) * t * t;
    return max_f32(speed * math_single_sinf(angle) * t - fall, 0.0F);
}

/** The height of a projectile after `t` seconds, m. */
static double real_height_of_f64(double speed, double angle, double t)
{
    const double fall = 0.5 * 9.81 * t * t;
    return max_f64(speed * sine_sin(angle) * t - fall, 0.0);
}

float real_height_f32(float speed, float angle, float t)
{
    return real_height_of_f32(speed, angle, t);
}

double real_height_f64(double speed, double half_turns, double t)
{
    return real_height_of_f64(speed, half_turns * F64_PI, t);
}
