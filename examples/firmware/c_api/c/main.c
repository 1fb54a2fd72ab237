/* Every function of coslobe.h on a few inputs, its results as bit patterns; the same program on a host and
 * on boards. tools/on_target/src/c.rs compares what it prints with what Rust computes. */
#include "../coslobe.h"
#include "platform.h"

#include <stddef.h>

/* PCG32: O'Neill, pcg-random.org. */
struct pcg {
    uint64_t state, increment;
};

static uint32_t pcg_next(void *context)
{
    struct pcg *pcg = context;
    const uint64_t old = pcg->state;
    pcg->state = old * 6364136223846793005u + pcg->increment;
    const uint32_t shifted = (uint32_t)(((old >> 18) ^ old) >> 27), turn = (uint32_t)(old >> 59);
    return (shifted >> turn) | (shifted << (-turn & 31));
}

static struct pcg pcg_new(uint64_t seed, uint64_t stream)
{
    struct pcg pcg = {0, (stream << 1) | 1};
    pcg.state = pcg.increment + seed;
    pcg_next(&pcg);
    return pcg;
}

union word {
    uint32_t bits;
    float x;
};

static float of_bits(uint32_t bits)
{
    const union word word = {.bits = bits};
    return word.x;
}

static void put_word(uint32_t bits)
{
    char text[10] = " ";
    for (int i = 0; i < 8; i++)
        text[1 + i] = "0123456789abcdef"[bits >> (28 - 4 * i) & 15];
    put_text(text);
}

static void put_bits(float x)
{
    const union word word = {.x = x};
#ifdef PLANTED_BIT /* in one result, for the comparison to find */
    const uint32_t bits = word.bits ^ (word.bits == 0x3d026136);
#else
    const uint32_t bits = word.bits;
#endif
    if ((bits & 0x7fffffff) > 0x7f800000) {
        put_text(" NaN"); /* which NaN is no matter */
    } else {
        put_word(bits);
    }
}

static void put_pair(coslobe_cos_sin_f32 at)
{
    put_bits(at.cos);
    put_bits(at.sin);
}

/* Probabilities, angles and cosines alike: inside, at and beyond every end, and NaN. */
static const uint32_t INPUTS[] = {
    0x00000000, 0x80000000, 0x00000001, 0x1e3ce508, 0x38d1b717, 0x3dcccccd, 0x3e800000, 0x3f000000,
    0x3f19999a, 0x3f7fffff, 0x3f800000, 0x3f800001, 0x3fc90fda, 0x3fc90fdb, 0xbf000000, 0xbfc90fda,
    0x7f800000, 0xff800000, 0x7fc00000,
};
#define INPUTS_COUNT (sizeof INPUTS / sizeof INPUTS[0])

struct law {
    const char *name;
    coslobe_status (*plane)(const coslobe_rng *, float (*)[2]);
    coslobe_status (*space)(const coslobe_rng *, float (*)[3]);
    coslobe_cos_sin_f32 (*warp)(float);
    float (*density)(coslobe_cos_sin_f32);
    float (*cdf)(float);
    float (*quantile)(float);
};

#define PLANE(law) {#law, coslobe_##law##_sample_f32, NULL, coslobe_##law##_warp_f32, \
    coslobe_##law##_density_f32, coslobe_##law##_cdf_f32, coslobe_##law##_quantile_f32}
#define SPACE(law) {#law, NULL, coslobe_##law##_sample_f32, coslobe_##law##_warp_f32, \
    coslobe_##law##_density_f32, coslobe_##law##_cdf_f32, coslobe_##law##_quantile_f32}

static void evaluations(const struct law *law)
{
    for (size_t i = 0; i < INPUTS_COUNT; i++) {
        const float x = of_bits(INPUTS[i]);
        const coslobe_cos_sin_f32 at = law->warp(x), pair = {x, of_bits(0x3f19999a)};
        put_text(law->name);
        put_bits(x);
        put_pair(at);
        put_bits(law->density(at));
        put_bits(law->density(pair));
        put_bits(law->cdf(x));
        put_bits(law->quantile(x));
        put_text("\n");
    }
}

static void samples(const struct law *law, const coslobe_rng *rng)
{
    for (int i = 0; i < 8; i++) {
        float flat[2], direction[3];
        put_text(law->name);
        if (law->plane != NULL && law->plane(rng, &flat) == COSLOBE_STATUS_OK) {
            put_bits(flat[0]);
            put_bits(flat[1]);
        }
        if (law->space != NULL && law->space(rng, &direction) == COSLOBE_STATUS_OK) {
            put_bits(direction[0]);
            put_bits(direction[1]);
            put_bits(direction[2]);
        }
        put_text("\n");
    }
}

static void cos_power(float exponent, const coslobe_rng *rng)
{
    for (size_t i = 0; i < INPUTS_COUNT; i++) {
        const float x = of_bits(INPUTS[i]);
        const coslobe_cos_sin_f32 at = coslobe_cos_power_warp_f32(exponent, x);
        put_text("cos_power");
        put_bits(exponent);
        put_bits(x);
        put_pair(at);
        put_bits(coslobe_cos_power_density_f32(exponent, at));
        put_bits(coslobe_cos_power_cdf_f32(exponent, x));
        put_bits(coslobe_cos_power_quantile_f32(exponent, x));
        put_text("\n");
    }
    float direction[3];
    if (coslobe_cos_power_sample_f32(exponent, rng, &direction) == COSLOBE_STATUS_OK) {
        put_text("cos_power");
        put_bits(direction[0]);
        put_bits(direction[1]);
        put_bits(direction[2]);
        put_text("\n");
    }
}

struct law_q31 {
    const char *name;
    coslobe_status (*plane)(const coslobe_rng *, int32_t (*)[2]);
    coslobe_status (*space)(const coslobe_rng *, int32_t (*)[3]);
    coslobe_cos_sin_q31 (*warp)(uint32_t);
    uint32_t (*density)(coslobe_cos_sin_q31);
    uint32_t (*cdf)(int32_t);
    int32_t (*quantile)(uint32_t);
};

#define PLANE_Q31(law) {#law " q31", coslobe_##law##_sample_q31, NULL, coslobe_##law##_warp_q31, \
    coslobe_##law##_density_q31, coslobe_##law##_cdf_q31, coslobe_##law##_quantile_q31}
#define SPACE_Q31(law) {#law " q31", NULL, coslobe_##law##_sample_q31, coslobe_##law##_warp_q31, \
    coslobe_##law##_density_q31, coslobe_##law##_cdf_q31, coslobe_##law##_quantile_q31}

static void put_direction_q31(const char *name, const int32_t *direction, int length)
{
    put_text(name);
    for (int i = 0; i < length; i++)
        put_word((uint32_t)direction[i]);
    put_text("\n");
}

static void put_row_q31(const char *name, uint32_t x, coslobe_cos_sin_q31 at, uint32_t density,
                        uint32_t cdf, int32_t quantile)
{
    const uint32_t row[] = {x, (uint32_t)at.cos, (uint32_t)at.sin, density, cdf, (uint32_t)quantile};
    put_text(name);
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++)
        put_word(row[i]);
    put_text("\n");
}

/* The inputs' bits as they are: of integers every pattern is a number. */
static void in_integers(const struct law_q31 *law, const coslobe_rng *rng)
{
    int32_t flat[2], direction[3];
    if (law->plane != NULL && law->plane(rng, &flat) == COSLOBE_STATUS_OK)
        put_direction_q31(law->name, flat, 2);
    if (law->space != NULL && law->space(rng, &direction) == COSLOBE_STATUS_OK)
        put_direction_q31(law->name, direction, 3);
    for (size_t i = 0; i < INPUTS_COUNT; i++) {
        const uint32_t x = INPUTS[i];
        const coslobe_cos_sin_q31 at = law->warp(x);
        put_row_q31(law->name, x, at, law->density(at), law->cdf((int32_t)x), law->quantile(x));
    }
}

static void cos_power_q31(uint32_t k, const coslobe_rng *rng)
{
    int32_t direction[3];
    if (coslobe_cos_power_sample_q31(k, rng, &direction) == COSLOBE_STATUS_OK)
        put_direction_q31("cos_power q31", direction, 3);
    for (size_t i = 0; i < INPUTS_COUNT; i++) {
        const uint32_t x = INPUTS[i];
        const coslobe_cos_sin_q31 at = coslobe_cos_power_warp_q31(k, x);
        put_row_q31("cos_power q31", x, at, coslobe_cos_power_density_q31(k, at),
                    coslobe_cos_power_cdf_q31(k, (int32_t)x), coslobe_cos_power_quantile_q31(k, x));
    }
}

/* Statuses; a null pointer draws no word and writes nothing. */
static int refuses(const coslobe_rng *rng, const struct pcg *pcg)
{
    const uint64_t before = pcg->state;
    const coslobe_rng none = {NULL, rng->context};
    float flat[2] = {9, 9}, direction[3] = {9, 9, 9};
    const int as_documented =
        coslobe_disk_sample_f32(NULL, &flat) == COSLOBE_STATUS_NULL_POINTER &&
        coslobe_disk_sample_f32(&none, &flat) == COSLOBE_STATUS_NULL_POINTER &&
        coslobe_disk_sample_f32(rng, NULL) == COSLOBE_STATUS_NULL_POINTER &&
        coslobe_lambert_sample_f32(NULL, &direction) == COSLOBE_STATUS_NULL_POINTER &&
        coslobe_cos_power_sample_f32(1, rng, NULL) == COSLOBE_STATUS_NULL_POINTER &&
        coslobe_cos_power_sample_f32(-1, rng, &direction) == COSLOBE_STATUS_EXPONENT &&
        coslobe_cos_power_sample_f32(of_bits(0x7fc00000), NULL, NULL) == COSLOBE_STATUS_EXPONENT;
    return as_documented && pcg->state == before && flat[0] == 9 && direction[0] == 9;
}

#ifdef PLANTED_PANIC /* for the proof that none is linked */
uint32_t coslobe_planted(uint32_t i);
#endif

int main(void)
{
#ifdef PLANTED_PANIC
    coslobe_planted(0);
#endif
    static const struct law LAWS[] = {
        PLANE(disk), PLANE(circle_shell), PLANE(circle_arc),
        SPACE(ball), SPACE(sphere_shell), SPACE(lambert),
    };
    struct pcg pcg = pcg_new(2024, 1);
    const coslobe_rng rng = {pcg_next, &pcg};
    for (size_t i = 0; i < sizeof LAWS / sizeof LAWS[0]; i++) {
        samples(&LAWS[i], &rng);
        evaluations(&LAWS[i]);
    }
    cos_power(of_bits(0x40e9999a), &rng); /* 7.3 */
    cos_power(-1, &rng);
    static const struct law_q31 LAWS_Q31[] = {
        PLANE_Q31(disk), PLANE_Q31(circle_shell), PLANE_Q31(circle_arc),
        SPACE_Q31(ball), SPACE_Q31(sphere_shell), SPACE_Q31(lambert),
    };
    for (size_t i = 0; i < sizeof LAWS_Q31 / sizeof LAWS_Q31[0]; i++)
        in_integers(&LAWS_Q31[i], &rng);
    cos_power_q31(0x74ccd, &rng); /* 7.3 */
    const int refused = refuses(&rng, &pcg);
    put_text(refused ? "refused as documented\n" : "REFUSED OTHERWISE THAN DOCUMENTED\n");
    return refused ? 0 : 1;
}
