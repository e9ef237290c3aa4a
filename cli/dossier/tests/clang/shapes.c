#include <stdbool.h>
#include <stdint.h>
#include "shapes.h"

static bool odd(uint32_t x)
{
    return (x & 1U) != 0U;
}

uint32_t shapes(uint32_t a, uint32_t b, uint32_t c, uint32_t d)
{
    uint32_t sum = 0U;
    if (a > 1U && (b > 1U || !(c == 2U))) {
        sum += 1U;
    } else if (a == 0U || (b == 0U && c == 0U) || d == 3U) {
        sum += 2U;
    }
    while (sum < 9U && (d != 1U || odd(sum))) {
        sum += 3U;
    }
    for (uint32_t n = 0U; n < 4U && n != b; n++) {
        sum += (n > c || odd(n)) ? 1U : 2U;
    }
    const bool both = odd(a) && odd(b) && odd(c) && odd(d);
    if (both) {
        sum += 5U;
    }
    do {
        sum++;
    } while (odd(sum) && !both && a != 3U);
    switch (a) {
    case 0U:
        return sum;
    default:
        break;
    }
    return (!(a < b) || (c < d && !odd(d))) ? sum : 0U;
}
