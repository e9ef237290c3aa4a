/* The C of tests/corpus/src/programs/functions/components.rs. Written by a test. */

/* contact.c */

static const uint8_t CONTACT_STABLE = 3U;

static void contact_count(contact_t *self, bool level);

void contact_init(contact_t *self)
{
    self->closed = false;
    self->agreeing = 0U;
}

bool contact_sample(contact_t *self, bool level)
{
    contact_count(self, level);
    if (self->agreeing >= CONTACT_STABLE) {
        self->closed = level;
        self->agreeing = 0U;
    }
    return self->closed;
}

void contact_reset(contact_t *self, bool closed)
{
    self->closed = closed;
    self->agreeing = 0U;
}

static void contact_count(contact_t *self, bool level)
{
    if (level == self->closed) {
        self->agreeing = 0U;
    } else {
        self->agreeing = saturating_add_u8(self->agreeing, 1U);
    }
}

/* contact.h */

/** Debounces a contact. */
typedef struct {
    bool closed;
    uint8_t agreeing;
} contact_t;
