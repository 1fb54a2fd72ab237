/* Start-up and semihosting of an emulated RISC-V, without a C library. */
#include "platform.h"

#include <stdint.h>

int main(void);

static uint32_t semihost(uint32_t operation, const void *argument)
{
    register uint32_t a0 __asm__("a0") = operation;
    register const void *a1 __asm__("a1") = argument;
    /* These three, uncompressed, are how a debugger knows the call. */
    __asm__ volatile(".option push\n.option norvc\n.balign 16\n"
                     "slli x0, x0, 0x1f\nebreak\nsrai x0, x0, 7\n"
                     ".option pop"
                     : "+r"(a0) : "r"(a1) : "memory");
    return a0;
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

__attribute__((used)) static void run(void)
{
    const uint32_t block[2] = {0x20026 /* the application ended */, (uint32_t)main()};
    semihost(0x20, block);
    for (;;) { }
}

__attribute__((naked, section(".vectors"), used)) void _start(void)
{
    __asm__ volatile("la sp, stack_top\nj run");
}
