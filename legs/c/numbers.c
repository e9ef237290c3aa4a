/* Where the lowest bytes of a word stand in it, so many of them. */
__attribute__((unused)) static size_t lowest(size_t size)
{
    const uint16_t one = 1;
    unsigned char first;
    memcpy(&first, &one, 1);
    return first == 1 ? 0 : 8 - size;
}

/* Numbers of so many bytes that lie one behind the other. */
__attribute__((unused)) static void get_numbers(void *place, size_t size, uint32_t count)
{
    unsigned char *to = place;
    for (; count > 0; --count, to += size) {
        const uint64_t word = get();
        memcpy(to, (const unsigned char *)&word + lowest(size), size);
    }
}

__attribute__((unused)) static void put_numbers(const void *place, size_t size, uint32_t count)
{
    const unsigned char *from = place;
    for (; count > 0; --count, from += size) {
        uint64_t word = 0;
        memcpy((unsigned char *)&word + lowest(size), from, size);
        put(word);
    }
}

/* The same of signed ones: what is above their bytes is their sign. */
__attribute__((unused)) static void put_signed(const void *place, size_t size, uint32_t count)
{
    const unsigned char *from = place;
    for (; count > 0; --count, from += size) {
        uint64_t word = from[lowest(size) == 0 ? size - 1 : 0] >= 128 ? UINT64_MAX : 0;
        memcpy((unsigned char *)&word + lowest(size), from, size);
        put(word);
    }
}
