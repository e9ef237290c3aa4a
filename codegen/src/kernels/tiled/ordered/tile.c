/* Rows of a panel that go through it side by side. */
#define TALL $tall
/* Rows in whole tiles of them: those beyond the last give nothing that is used. */
#define TALL_ROWS ((ROWS + TALL - 1U) / TALL * TALL)

typedef struct {
$rows} tile_t;

/* The matrix' rows of a tile. */
typedef struct {
$places} rows_t;

static inline tile_t load_tile(const $real *from)
{
    tile_t tile;
$load    return tile;
}

static inline void store_tile($real *to, const tile_t *tile)
{
$store}

/* Takes a row, times a multiplier of each row of the tile, from the tile. */
static inline void step(tile_t *tile, const rows_t *of, size_t column, const $real *row)
{
    const row_t other = load_operand(row);
$minus$hold}

/* The steps of a tile's own rows, so many, which are above the diagonal: each is taken from those below it, and is then
   done with, a row of the matrix from a column on. */
static inline void own_steps(tile_t *tile, const rows_t *of, size_t column, uint32_t steps, uint32_t from)
{
$own}

/* Takes the columns on the left of a panel, times the panel's rows, from rows of it. Those above the diagonal have as many
   columns as there are rows above them. */
NOT_INLINE static void subtract(const elimination_t *work, uint32_t first, uint32_t row)
{
    rows_t of;
$find    $real *const to = &work->panel[WIDTH * row];
    const $real *upper = work->panel;
    const uint32_t above = (row < first) ? first - row : 0U;
    const size_t columns = (row < first) ? row : first;
    tile_t tile = load_tile(to);
    for (size_t column = 0U; column < columns; column += $unrolled) {
$steps        upper += $unrolled * WIDTH;
    }
    own_steps(&tile, &of, columns, above, first);
    store_tile(to, &tile);
}

