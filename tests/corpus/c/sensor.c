/* What a vendor's library brings: the C of functions/external.rs. */
#include "sensor.h"

float sensor_linear(uint16_t raw)
{
    return (float)raw * 0.01F - 5.0F;
}

void sensor_axes(const float raw[3], float scale, float axes[3])
{
    axes[0] = raw[1] * scale;
    axes[1] = raw[0] * scale;
    axes[2] = -raw[2] * scale;
}
