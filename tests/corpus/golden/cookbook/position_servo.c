/* The C of tests/corpus/src/programs/cookbook/position_servo.rs. Written by a test. */

/* position_servo.c */

static const uint8_t SPEED_PERIODS = 10U;

/* The smaller of two numbers: -0 < +0, and a NaN gives the other. */
static float min_f32(float a, float b)
{
    if (a < b || isnan(b)) {
        return a;
    }
    if (b < a || isnan(a)) {
        return b;
    }
    return signbit(a) ? a : b;
}

/* The larger of two numbers: -0 < +0, and a NaN gives the other. */
static float max_f32(float a, float b)
{
    if (a > b || isnan(b)) {
        return a;
    }
    if (b > a || isnan(a)) {
        return b;
    }
    return !signbit(a) ? a : b;
}

/* a - b, or the limit of the type beyond which it lies. */
static uint8_t saturating_sub_u8(uint8_t a, uint8_t b)
{
    const int32_t exact = (int32_t)a - (int32_t)b;
    if (exact < 0) {
        return 0;
    }
    return (uint8_t)exact;
}

void position_servo_init(position_servo_t *self)
{
    pi_controller_init(&self->speed_loop);
    self->wanted_speed = 0.0F;
    self->countdown = 0U;
}

float position_servo_step(position_servo_t *self, const servo_parameters_t *parameters,
    float target, float position, float speed)
{
    if (self->countdown == 0U) {
        self->countdown = SPEED_PERIODS;
        const float limit = parameters->speed_limit;
        self->wanted_speed = min_f32(max_f32(parameters->stiffness * (target - position), -limit),
            limit);
    }
    self->countdown = saturating_sub_u8(self->countdown, 1U);
    return pi_controller_step(&self->speed_loop, &parameters->speed, self->wanted_speed, speed);
}

/* position_servo.h */

/** Gains and limits of both loops. */
typedef struct {
    /** Speed for each rad of position error, 0 or more. Unit: 1/s. */
    float stiffness;
    /** Highest speed that the position loop asks for, 0 or more. Unit: rad/s. */
    float speed_limit;
    /** The speed loop. */
    pi_parameters_t speed;
} servo_parameters_t;

/** Holds a position. */
typedef struct {
    pi_controller_t speed_loop;
    /** What the position loop asks for. Unit: rad/s. */
    float wanted_speed;
    /** Periods until the position loop is due. */
    uint8_t countdown;
} position_servo_t;
