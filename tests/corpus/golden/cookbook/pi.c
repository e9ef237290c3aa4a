/* The C of tests/corpus/src/programs/cookbook/pi.rs. Written by a test. */

/* pi_controller.c */

void pi_controller_init(pi_controller_t *self)
{
    pid_pid_f32_init(&self->pid);
}

float pi_controller_step(pi_controller_t *BESSEMER_RESTRICT self,
    const pid_parameters_f32_t *parameters, float target, float measured)
{
    return pid_pid_f32_step(&self->pid, parameters, target, measured);
}

void pi_controller_preset(pi_controller_t *BESSEMER_RESTRICT self,
    const pid_parameters_f32_t *parameters, float target, float measured, float output)
{
    pid_pid_f32_track(&self->pid, parameters, target, measured, output);
}

/* pi_controller.h */

/** Controls a speed. */
typedef struct {
    pid_pid_f32_t pid;
} pi_controller_t;
