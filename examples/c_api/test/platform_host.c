#include "platform.h"

#include <stdio.h>

void put_text(const char *text) { fputs(text, stdout); }
