        number = $spread;
#pragma GCC unroll 16
        for (uint32_t vector = 0U; vector < VECTORS; vector++) {
            sums[vector] += *(const lanes_t *)&a[$rows * (k + $next) + OFFSET(vector)] * number;
            IN_ITS_REGISTER(sums[vector]);
        }
$last_term