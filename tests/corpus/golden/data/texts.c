/* The C of tests/corpus/src/programs/data/texts.rs. Written by a test. */

/* texts.c */

void texts_height(float scale, channel_t *channel)
{
    static const uint8_t new_name[6] = {104U, 101U, 105U, 103U, 104U, 116U};
    (void)memcpy(channel->name, new_name, sizeof(uint8_t[6]));
    channel->scale = scale;
}

bool texts_is_height(const channel_t *channel)
{
    static const uint8_t elements[6] = {104U, 101U, 105U, 103U, 104U, 116U};
    bool result_equal = true;
    for (uint32_t i = 0U; i < 6U; i++) {
        if (channel->name[i] != elements[i]) {
            result_equal = false;
            break;
        }
    }
    return result_equal;
}

/* texts.h */

/** A channel of the log. */
typedef struct {
    uint8_t name[6];
    float scale;
} channel_t;
