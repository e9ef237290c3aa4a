/* The C of tests/corpus/src/programs/functions/several_entries.rs. Written by a test. */

/* events.c */

void events_init(events_t *self)
{
    self->count = 0U;
}

bool events_happened(events_t *self, uint32_t limit)
{
    self->count = saturating_add_u32(self->count, 1U);
    return self->count >= limit;
}

uint32_t events_count(const events_t *self)
{
    return self->count;
}

uint32_t events_clear(events_t *self)
{
    const uint32_t count = self->count;
    self->count = 0U;
    return count;
}

/* events.h */

/** A counter of events with a limit. */
typedef struct {
    uint32_t count;
} events_t;
