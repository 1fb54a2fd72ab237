/* coslobe for C: directions of the laws p ~ cos^k(theta). Made by surface/, not by hand.
 *
 * theta is the angle from the axis +y; a direction is [sin(theta), cos(theta)] in the plane and
 * [sin(theta) cos(phi), cos(theta), sin(theta) sin(phi)] in space. Each function is named
 * coslobe_LAW_OPERATION_TYPE. No call allocates or keeps anything: there is nothing to free.
 *
 * Operations
 *   sample            draws a direction.
 *   sample_around     draws a direction around a normal, a unit vector, in place of +y.
 *   fill              draws n directions, one after the other in directions[]. Where filled is not
 *                     NULL, it is told how many were written: n, unless the generator failed.
 *   warp_direction    the direction at cdf p and azimuth `turn`, in turns.
 *   point             draws the point itself, of the disk, circle, ball or sphere of that radius.
 *   self_test         draws 16384 directions and judges generator and law by chi-squared; says why
 *                     not in *fault unless that is NULL. For power-on.
 *   pdf, ln_pdf       density of theta, and its logarithm: per radian in the plane; in space per
 *                     dtheta dphi, that is with a factor sin(theta). 0 and -infinity elsewhere.
 *   pdf_solid_angle   the same per steradian.
 *   density           per radian or steradian at a direction, from its cosine: no trigonometry.
 *   cdf, sf           P(Theta <= theta) and P(Theta > theta); unwarp, unwarp_sf: at a direction.
 *   quantile, isf     theta where cdf, sf is p; warp, warp_sf: cosine and sine there.
 *   lambert_weight    the weight of a sample of a white Lambert reflector: integers in 2^-16.
 *
 * Types
 *   f32, fast   float. Angles are in radians. A NaN gives a NaN; a probability outside 0 to 1 too.
 *   q31         integers of 32 bits: components in units of 2^-31, probabilities and densities
 *               (cos_power's apart) of 2^-32, angles of 2^-32 of a turn.
 *   q15         integers of 16 bits: the same with 2^-15, 2^-16 and 2^-16 of a turn.
 *               A radius and its point are in a unit of length of yours.
 *               Integers saturate: the probability 1 is 2^32 - 1, the component 1 is 2^31 - 1.
 *
 * Pointers are never NULL, unless it says so; COSLOBE_NULL_POINTER answers one that is, with
 * nothing drawn or written. (A value asked of a law that is NULL is NaN or 0.)
 */

#ifndef COSLOBE_H
#define COSLOBE_H

#include <stddef.h>
#include <stdint.h>

#define COSLOBE_VERSION_MAJOR @MAJOR@
#define COSLOBE_VERSION_MINOR @MINOR@
#define COSLOBE_VERSION_PATCH @PATCH@

#if defined(__GNUC__) || defined(__clang__)
#define COSLOBE_CHECKED __attribute__((warn_unused_result))
#define COSLOBE_CONST __attribute__((const))
#define COSLOBE_NONNULL(arguments) __attribute__((nonnull arguments))
#else
#define COSLOBE_CHECKED
#define COSLOBE_CONST
#define COSLOBE_NONNULL(arguments)
#endif

/* Status of a call. Above 0: what the generator's function returned. */
#define COSLOBE_OK 0
#define COSLOBE_NULL_POINTER (-1)
#define COSLOBE_EXPONENT (-2) /* NaN, negative or infinite: nothing was written. */
#define COSLOBE_RADIUS (-3) /* NaN, below the smallest normal number (integers: not positive), above a
                             * quarter of the largest. */
#define COSLOBE_FAULT (-4) /* The self-test found one. */

/* A generator of random words. */
typedef struct coslobe_rng {
    /* Writes 32 uniform bits to *word and returns 0; or returns a code above 0, which is handed on:
     * then nothing is written to the direction, and the function is not called again. Where 64
     * bits are taken, the low word comes first. */
    int (*next_u32)(void *context, uint32_t *word);
    /* Handed to next_u32; may be NULL. */
    void *context;
} coslobe_rng;

/* What a self-test found. */
typedef struct coslobe_fault {
    /* 1 a direction that the law cannot give, 2 directions that repeat, 3 a count too uneven, 4 too
     * even to be random. */
    uint32_t kind;
    uint32_t sample; /* 1, 2: at which direction, from 1. */
    uint32_t period; /* 2: after how many directions they came again. */
    /* 3, 4: which count. 1 bits of the words, 2 their changes, 3 phi, 4 theta in eighths, 5 theta in
     * finer cells, 6 theta and phi, 7 theta and 8 phi of one direction and the next. */
    uint32_t statistic;
    uint32_t tenths, least, most; /* 3, 4: 10 chi-squared and its limits. */
    uint32_t worst; /* 3, 4: the cell that adds most; a bit's number from the lowest. */
} coslobe_fault;

/* Integers by their units. */
typedef int32_t coslobe_q31; /* component: 2^-31 */
typedef uint32_t coslobe_probability_q32; /* 2^-32 */
typedef int32_t coslobe_turn_q32; /* angle: 2^-32 of a turn */
typedef uint32_t coslobe_density_q32; /* per radian or steradian: 2^-32 */
typedef uint32_t coslobe_density_q16_16; /* cos_power's, per steradian: 2^-16 */
typedef uint32_t coslobe_exponent_q16_16; /* 2^-16 */
typedef uint32_t coslobe_weight_q16_16; /* both formats': 2^-16; a larger one is 2^32 - 1 */
typedef int16_t coslobe_q15; /* component: 2^-15 */
typedef uint16_t coslobe_probability_q16; /* 2^-16 */
typedef int16_t coslobe_turn_q16; /* angle: 2^-16 of a turn */
typedef uint16_t coslobe_density_q16; /* per radian or steradian: 2^-16 */

/* A direction by the cosine and sine of its angle from the axis. */
typedef struct coslobe_cos_sin_f32 {
    float cos, sin;
} coslobe_cos_sin_f32;

typedef struct coslobe_cos_sin_q31 {
    coslobe_q31 cos, sin;
} coslobe_cos_sin_q31;

typedef struct coslobe_cos_sin_q15 {
    coslobe_q15 cos, sin;
} coslobe_cos_sin_q15;

#ifdef __cplusplus
extern "C" {
#endif
