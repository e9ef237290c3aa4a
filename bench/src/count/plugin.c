/*
 * A plugin of QEMU's translator: counts the instructions that run between two functions of the
 * program, and prints the count each time the second is entered. Its arguments are their addresses,
 * begin=0x… and end=0x….
 *
 * QEMU's own header is not packaged; what is used of version 1 of its interface is declared here.
 */
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef uint64_t qemu_plugin_id_t;
struct qemu_plugin_tb;
enum { CB_NO_REGS };
extern void qemu_plugin_register_vcpu_tb_trans_cb(
    qemu_plugin_id_t id, void (*callback)(qemu_plugin_id_t, struct qemu_plugin_tb *));
extern void qemu_plugin_register_vcpu_tb_exec_cb(struct qemu_plugin_tb *block,
    void (*callback)(unsigned, void *), int flags, void *data);
extern size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *block);
extern uint64_t qemu_plugin_tb_vaddr(const struct qemu_plugin_tb *block);
extern void qemu_plugin_outs(const char *text);

__attribute__((visibility("default"))) int qemu_plugin_version = 1;

static uint64_t begin_address;
static uint64_t end_address;
static uint64_t count;
static bool counting;

static void begin(unsigned cpu, void *data)
{
    (void)cpu;
    (void)data;
    count = 0;
    counting = true;
}

static void end(unsigned cpu, void *data)
{
    char text[32];
    (void)cpu;
    (void)data;
    counting = false;
    snprintf(text, sizeof text, "%" PRIu64 "\n", count);
    qemu_plugin_outs(text);
}

static void executed(unsigned cpu, void *data)
{
    (void)cpu;
    if (counting) {
        count += (uintptr_t)data;
    }
}

static void translated(qemu_plugin_id_t id, struct qemu_plugin_tb *block)
{
    const uint64_t address = qemu_plugin_tb_vaddr(block);
    void *const length = (void *)(uintptr_t)qemu_plugin_tb_n_insns(block);
    (void)id;
    if (address == begin_address) {
        qemu_plugin_register_vcpu_tb_exec_cb(block, begin, CB_NO_REGS, NULL);
    } else if (address == end_address) {
        qemu_plugin_register_vcpu_tb_exec_cb(block, end, CB_NO_REGS, NULL);
    } else {
        qemu_plugin_register_vcpu_tb_exec_cb(block, executed, CB_NO_REGS, length);
    }
}

__attribute__((visibility("default"))) int qemu_plugin_install(
    qemu_plugin_id_t id, const void *info, int argc, char **argv)
{
    (void)info;
    for (int index = 0; index < argc; index++) {
        const char *const value = strchr(argv[index], '=');
        if (value != NULL) {
            const uint64_t address = strtoull(value + 1, NULL, 0);
            *(argv[index][0] == 'b' ? &begin_address : &end_address) = address;
        }
    }
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    return 0;
}
