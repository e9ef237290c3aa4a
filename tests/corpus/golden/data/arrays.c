/* The C of tests/corpus/src/programs/data/arrays.rs. Written by a test. */

/* recent.c */

void recent_init(recent_t *self)
{
    self->values[0] = 0;
    self->values[1] = 0;
    self->values[2] = 0;
    self->values[3] = 0;
}

void recent_push(recent_t *BESSEMER_RESTRICT self, int32_t value,
    int32_t before[BESSEMER_RESTRICT 4])
{
    before[0] = self->values[0];
    before[1] = self->values[1];
    before[2] = self->values[2];
    before[3] = self->values[3];
    self->values[0] = value;
    for (uint32_t i = 1U; i < 4U; i++) {
        self->values[i] = before[i - 1U];
    }
}

/* recent.h */

/** The last four values, newest first. */
typedef struct {
    int32_t values[4];
} recent_t;
