/*
 * A plugin for QEMU's user mode: the instructions executed between bench_begin and bench_end, one number a line,
 * on standard error. The interface (version 1 of the TCG plugins) is declared by hand, since Debian ships no header.
 */
#include <inttypes.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

struct qemu_plugin_tb;
struct qemu_plugin_insn;
typedef uint64_t qemu_plugin_id_t;
typedef struct qemu_info_t qemu_info_t;
typedef void (*translated_t)(qemu_plugin_id_t id, struct qemu_plugin_tb *tb);
typedef void (*executed_t)(unsigned int cpu, void *data);
enum { INLINE_ADD_U64 = 0, NO_REGISTERS = 0 };

size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *tb);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *tb, size_t index);
const char *qemu_plugin_insn_symbol(const struct qemu_plugin_insn *insn);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *insn);
void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t id, translated_t callback);
void qemu_plugin_register_vcpu_insn_exec_inline(
    struct qemu_plugin_insn *insn, int operation, void *counter, uint64_t step);
void qemu_plugin_register_vcpu_insn_exec_cb(
    struct qemu_plugin_insn *insn, executed_t callback, int registers, void *data);

int qemu_plugin_version = 1;

static uint64_t executed;
static uint64_t begun;

/* Called before the first instruction of a block that is that long, which is left out. */
static void at_begin(unsigned int cpu, void *length)
{
    (void)cpu;
    begun = executed + (uintptr_t)length;
}

static void at_end(unsigned int cpu, void *data)
{
    (void)cpu;
    (void)data;
    fprintf(stderr, "%" PRIu64 "\n", executed - begun);
}

/* The addresses of the two functions: a block may also begin in the middle of one, after an interruption. */
static uint64_t begins_at;
static uint64_t ends_at;

/* Whether an instruction is the first of a function. A function is entered at its first one, so that comes first. */
static bool is_first(const struct qemu_plugin_insn *insn, const char *function, uint64_t *address)
{
    const char *symbol = qemu_plugin_insn_symbol(insn);
    if (symbol == NULL || strstr(symbol, function) == NULL) {
        return false;
    }
    const uint64_t at = qemu_plugin_insn_vaddr(insn);
    if (*address == 0) {
        *address = at;
    }
    return *address == at;
}

static void translated(qemu_plugin_id_t id, struct qemu_plugin_tb *tb)
{
    (void)id;
    void *const length = (void *)(uintptr_t)qemu_plugin_tb_n_insns(tb);
    for (size_t i = 0; i < qemu_plugin_tb_n_insns(tb); i++) {
        struct qemu_plugin_insn *insn = qemu_plugin_tb_get_insn(tb, i);
        if (i == 0 && is_first(insn, "bench_begin", &begins_at)) {
            qemu_plugin_register_vcpu_insn_exec_cb(insn, at_begin, NO_REGISTERS, length);
        }
        if (i == 0 && is_first(insn, "bench_end", &ends_at)) {
            qemu_plugin_register_vcpu_insn_exec_cb(insn, at_end, NO_REGISTERS, NULL);
        }
        qemu_plugin_register_vcpu_insn_exec_inline(insn, INLINE_ADD_U64, &executed, 1);
    }
}

int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t *info, int arguments, char **argument)
{
    (void)info;
    (void)arguments;
    (void)argument;
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    return 0;
}
