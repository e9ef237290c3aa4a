/* A row in registers: else a compiler loads it again for each fused step. */
static inline row_t load_operand(const $real *from)
{
    row_t row = load_row(from);
    __asm__("" : "+v"(row.low), "+v"(row.high));
    return row;
}
