#include <stdint.h>
uint32_t shapes(uint32_t a, uint32_t b, uint32_t c, uint32_t d);
