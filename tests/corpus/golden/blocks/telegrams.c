/* The C of tests/corpus/src/programs/blocks/telegrams.rs. Written by a test. */

/* commands.c */

void commands_init(commands_t *self)
{
    ring_buffer_u16_4_init(&self->queue);
}

bool commands_put(commands_t *self, uint16_t command)
{
    return ring_buffer_u16_4_push(&self->queue, command);
}

void commands_take(commands_t *BESSEMER_RESTRICT self, option_u16_t *BESSEMER_RESTRICT result)
{
    if (ring_buffer_u16_4_is_empty(&self->queue)) {
        *result = (option_u16_t){.is_some = false};
    } else {
        ring_buffer_u16_4_pop(&self->queue, result);
    }
}

/* commands.h */

/** Queue of commands between an interrupt and the main loop. */
typedef struct {
    ring_buffer_u16_4_t queue;
} commands_t;

/* telegrams.c */

static const uint32_t U32_MAX = UINT32_MAX;

void telegrams_wheels(const uint8_t frame[8], float values[BESSEMER_RESTRICT 3])
{
    for (uint32_t i = 0U; i < 3U; i++) {
        values[i] = bytes_read_signal_f32(frame, &TELEGRAMS_WHEELS[i]);
    }
}

void telegrams_wheels_frame(const float values[3], uint8_t frame[BESSEMER_RESTRICT 8])
{
    for (uint32_t i = 0U; i < 8U; i++) {
        frame[i] = 0U;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        bytes_write_signal_f32(frame, &TELEGRAMS_WHEELS[i], values[i]);
    }
    frame[7] = bytes_crc8(BYTES_CRC8_SMBUS, 0U, frame, UINT64_C(7));
}

void telegrams_exchanged(const uint8_t frame[8], const signal_f64_t *signal, double value,
    pair_f64_u8x8_t *BESSEMER_RESTRICT result)
{
    (void)memcpy(result->second, frame, sizeof(uint8_t[8]));
    const double before = bytes_read_signal_f64(result->second, signal);
    bytes_write_signal_f64(result->second, signal, value);
    result->first = before;
}

void telegrams_checksums(const uint8_t record[12], pair_u16_u32_t *BESSEMER_RESTRICT result)
{
    result->first = bytes_crc16(BYTES_CRC16_CCITT, 0xFFFFU, record, UINT64_C(12));
    result->second = ~bytes_crc32(BYTES_CRC32_IEEE, U32_MAX, record, UINT64_C(12));
}
