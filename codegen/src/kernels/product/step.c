        number = $spread;
#pragma GCC unroll 16
        for (uint32_t down = 0U; down < DOWN; down++) {
            sums[down] += *(const lanes_t *)&a[$rows * (k + $next) + OFFSET(down)] * number;
            IN_ITS_REGISTER(sums[down]);
        }
$last_term