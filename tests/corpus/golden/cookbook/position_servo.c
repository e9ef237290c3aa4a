/* The C of tests/corpus/src/programs/cookbook/position_servo.rs. Written by a test. */

/* position_servo.c */

static const schedule_1_t SCHEDULE = {.tasks = {{.period = 10U, .phase = 0U, .cost = 0U}}};

void position_servo_init(position_servo_t *self)
{
    pid_pid_f32_init(&self->speed_loop);
    self->wanted_speed = 0.0F;
    rates_1_init(&self->rates);
}

float position_servo_step(position_servo_t *BESSEMER_RESTRICT self,
    const servo_parameters_t *parameters, float target, float position, float speed)
{
    bool elements[1];
    rates_1_step(&self->rates, &SCHEDULE, elements);
    if (elements[0]) {
        const float limit = parameters->speed_limit;
        self->wanted_speed = min_f32(max_f32(parameters->stiffness * (target - position), -limit),
            limit);
    }
    return pid_pid_f32_step(&self->speed_loop, &parameters->speed, self->wanted_speed, speed);
}

/* position_servo.h */

/** Gains and limits of both loops. */
typedef struct {
    /** Speed setpoint for each rad of position error, 0 or more. Unit: 1/s. */
    float stiffness;
    /** Largest speed setpoint, 0 or more. Unit: rad/s. */
    float speed_limit;
    /** Parameters of the speed loop. */
    pid_parameters_f32_t speed;
} servo_parameters_t;

/** Controls a position. */
typedef struct {
    pid_pid_f32_t speed_loop;
    /** Speed setpoint from the position loop. Unit: rad/s. */
    float wanted_speed;
    rates_1_t rates;
} position_servo_t;
