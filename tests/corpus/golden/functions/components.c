/* The C of tests/corpus/src/programs/functions/components.rs. Written by a test. */

/* contact.c */

static const uint8_t CONTACT_STABLE = 3U;

static void components_contact_count(components_contact_t *self, bool level);

void components_contact_init(components_contact_t *self)
{
    self->closed = false;
    self->agreeing = 0U;
}

bool components_contact_sample(components_contact_t *self, bool level)
{
    components_contact_count(self, level);
    if (self->agreeing >= CONTACT_STABLE) {
        self->closed = level;
        self->agreeing = 0U;
    }
    return self->closed;
}

void components_contact_reset(components_contact_t *self, bool closed)
{
    self->closed = closed;
    self->agreeing = 0U;
}

static void components_contact_count(components_contact_t *self, bool level)
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
} components_contact_t;
