/* What a firmware brings: the C of the function that random bodies call as an external one. */
#include "beside_sensor.h"

int16_t beside_sensor(int16_t x)
{
    const uint32_t product = (uint32_t)(uint16_t)x * 5U;
    return (int16_t)(uint16_t)((product ^ 9U) & 0xFFFFU);
}
