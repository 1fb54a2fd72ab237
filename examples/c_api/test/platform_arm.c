/* Start-up and semihosting of an emulated Cortex-M, without a C library. */
#include "platform.h"

#include <stdint.h>

int main(void);
extern const uint32_t stack_top; /* board.ld */

static uint32_t semihost(uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

/* Opened for each text, so that no handle has to be kept. */
void put_text(const char *text)
{
    uintptr_t length = 0;
    while (text[length] != 0)
        length++;
    const uintptr_t console[3] = {(uintptr_t)":tt", 4 /* to write: the standard output */, 3};
    const uintptr_t handle = semihost(0x01, console);
    const uintptr_t write[3] = {handle, (uintptr_t)text, length};
    semihost(0x05, write);
    semihost(0x02, &handle);
}

static void leave(uint32_t status)
{
    const uint32_t block[2] = {0x20026 /* the application ended */, status};
    semihost(0x20, block);
    for (;;) { }
}

static void reset(void)
{
#ifdef __ARM_FP
    /* Full access to the floating-point unit, before any of its instructions. */
    *(volatile uint32_t *)0xe000ed88 |= 0xfu << 20;
    __asm__ volatile("dsb\nisb" ::: "memory");
#endif
    leave((uint32_t)main());
}

static void fault(void) { leave(2); }

/* What the processor reads first; exceptions that are not used have no entry. */
struct vectors {
    const uint32_t *stack;
    void (*reset)(void), (*nmi)(void), (*hard_fault)(void);
};

__attribute__((section(".vectors"), used)) static const struct vectors vectors = {
    &stack_top, reset, fault, fault,
};
