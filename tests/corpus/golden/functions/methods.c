/* The C of tests/corpus/src/programs/functions/methods.rs. Written by a test. */

/* methods.c */

static const uint32_t VERSION_FIRST = 0x1000000U;

void methods_version_unpacked(uint32_t word, methods_version_t *version)
{
    version->major = (uint8_t)(word >> 24);
    version->minor = (uint8_t)(word >> 16);
    version->patch = (uint16_t)word;
}

uint32_t methods_version_packed(const methods_version_t *self)
{
    return ((uint32_t)self->major << 24) | ((uint32_t)self->minor << 16) | (uint32_t)self->patch;
}

void methods_version_patch(methods_version_t *self)
{
    self->patch = (uint16_t)((uint32_t)self->patch + 1U);
}

void methods_patched(uint32_t word, uint32_t result[2])
{
    methods_version_t version;
    methods_version_unpacked(word, &version);
    methods_version_patch(&version);
    const uint32_t packed = methods_version_packed(&version);
    uint32_t result_choice;
    if (packed >= VERSION_FIRST) {
        result_choice = 1U;
    } else {
        result_choice = 0U;
    }
    result[0] = packed;
    result[1] = result_choice;
}

/* methods.h */

/** A version as three numbers. */
typedef struct {
    uint8_t major;
    uint8_t minor;
    uint16_t patch;
} methods_version_t;
