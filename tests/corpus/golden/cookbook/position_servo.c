/* The C of tests/corpus/src/programs/cookbook/position_servo.rs. Written by a test. */

/* position_servo.c */

static const uint8_t SPEED_PERIODS = 10U;

void position_servo_init(position_servo_t *self)
{
    pi_controller_init(&self->speed_loop);
    self->wanted_speed = 0.0F;
    self->countdown = 0U;
}

float position_servo_step(position_servo_t *BESSEMER_RESTRICT self,
    const servo_parameters_t *parameters, float target, float position, float speed)
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
    /** Speed setpoint for each rad of position error, 0 or more. Unit: 1/s. */
    float stiffness;
    /** Largest speed setpoint, 0 or more. Unit: rad/s. */
    float speed_limit;
    /** Parameters of the speed loop. */
    pi_parameters_t speed;
} servo_parameters_t;

/** Controls a position. */
typedef struct {
    pi_controller_t speed_loop;
    /** Speed setpoint from the position loop. Unit: rad/s. */
    float wanted_speed;
    /** Number of periods until the position loop is due. */
    uint8_t countdown;
} position_servo_t;
