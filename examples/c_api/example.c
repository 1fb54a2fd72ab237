/* Four directions around a normal: gcc example.c -I include -L lib -lcoslobe, as README.md says. */
#include <coslobe.h>
#include <stdio.h>

/* xorshift32 (Marsaglia); on a device, its random number generator. Any code above 0 is a failure. */
static int next_u32(void *context, uint32_t *word)
{
    uint32_t *state = context;
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    *word = *state;
    return 0;
}

int main(void)
{
    uint32_t state = 2024;
    coslobe_rng rng;
    const float normal[3] = {0.0f, 0.0f, 1.0f};
    float direction[3];
    int i;
    rng.next_u32 = next_u32;
    rng.context = &state;
    for (i = 0; i < 4; i++) {
        if (coslobe_lambert_sample_around_f32(normal, &rng, direction) != COSLOBE_OK)
            return 1;
        printf("% .6f % .6f % .6f\n", (double)direction[0], (double)direction[1],
               (double)direction[2]);
    }
    return 0;
}
