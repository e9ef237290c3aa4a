/* The C of tests/corpus/src/programs/data/shadowing.rs. Written by a test. */

/* shadowing.c */

float shadowing_temperature(uint16_t raw)
{
    const uint16_t raw_2 = (uint16_t)(raw & 0xFFFU);
    const float volts = (float)raw_2 * (3.3F / 4096.0F);
    const float volts_2 = volts - 0.5F;
    return volts_2 / 0.01F;
}
