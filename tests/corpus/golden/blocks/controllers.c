/* The C of tests/corpus/src/programs/blocks/controllers.rs. Written by a test. */

/* oven.c */

void oven_init(oven_t *self)
{
    pid_pid_f64_init(&self->pid);
}

double oven_step(oven_t *BESSEMER_RESTRICT self, const pid_parameters_f64_t *parameters,
    double target, double temperature, const option_f64_t *manual)
{
    if (manual->is_some) {
        const double power = manual->value;
        pid_pid_f64_track(&self->pid, parameters, target, temperature, power);
        return power;
    } else {
        return pid_pid_f64_step(&self->pid, parameters, target, temperature);
    }
}

/* oven.h */

/** Holds a temperature, or follows an operator. */
typedef struct {
    pid_pid_f64_t pid;
} oven_t;

/* speed_loop.c */

void speed_loop_init(speed_loop_t *self)
{
    pid_pid_f32_init(&self->pid);
}

float speed_loop_step(speed_loop_t *BESSEMER_RESTRICT self, const pid_parameters_f32_t *parameters,
    float target, float speed)
{
    return pid_pid_f32_step(&self->pid, parameters, target, speed);
}

/* speed_loop.h */

/** Holds a speed. */
typedef struct {
    pid_pid_f32_t pid;
} speed_loop_t;
