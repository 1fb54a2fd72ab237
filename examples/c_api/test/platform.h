/* What main.c needs of where it runs: one put_text for each in platform_*.c. */
#ifndef PLATFORM_H
#define PLATFORM_H

/* Writes a text that ends with 0 to the standard output. */
void put_text(const char *text);

#endif
