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

#define COSLOBE_VERSION_MAJOR 0
#define COSLOBE_VERSION_MINOR 1
#define COSLOBE_VERSION_PATCH 0

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

/* ---- f32: float: at most 4 units in the last place off ---- */

/* The law cos_power with its constants: coslobe_cos_power_init_f32 fills it in. */
typedef struct coslobe_cos_power_f32 {
    uint32_t state[24];
} coslobe_cos_power_f32;

/* disk, uniform by area in a disk: 2 cos^2(theta) / pi per radian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_disk_sample_f32(
    const coslobe_rng *rng, float direction[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_disk_fill_f32(
    const coslobe_rng *rng, float *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_disk_point_f32(
    float radius, const coslobe_rng *rng, float point[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_disk_self_test_f32(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST float coslobe_disk_pdf_f32(float theta);
COSLOBE_CONST float coslobe_disk_ln_pdf_f32(float theta);
COSLOBE_CONST float coslobe_disk_cdf_f32(float theta);
COSLOBE_CONST float coslobe_disk_sf_f32(float theta);
COSLOBE_CONST float coslobe_disk_quantile_f32(float p);
COSLOBE_CONST float coslobe_disk_isf_f32(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_disk_warp_f32(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_disk_warp_sf_f32(float p);
COSLOBE_CONST float coslobe_disk_unwarp_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_disk_unwarp_sf_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_disk_density_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_disk_lambert_weight_f32(coslobe_cos_sin_f32 at);

/* circle_shell, radial shell on a circle: cos(theta) / 2 per radian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_circle_shell_sample_f32(
    const coslobe_rng *rng, float direction[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_circle_shell_fill_f32(
    const coslobe_rng *rng, float *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_circle_shell_point_f32(
    float radius, const coslobe_rng *rng, float point[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_circle_shell_self_test_f32(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST float coslobe_circle_shell_pdf_f32(float theta);
COSLOBE_CONST float coslobe_circle_shell_ln_pdf_f32(float theta);
COSLOBE_CONST float coslobe_circle_shell_cdf_f32(float theta);
COSLOBE_CONST float coslobe_circle_shell_sf_f32(float theta);
COSLOBE_CONST float coslobe_circle_shell_quantile_f32(float p);
COSLOBE_CONST float coslobe_circle_shell_isf_f32(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_circle_shell_warp_f32(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_circle_shell_warp_sf_f32(float p);
COSLOBE_CONST float coslobe_circle_shell_unwarp_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_circle_shell_unwarp_sf_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_circle_shell_density_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_circle_shell_lambert_weight_f32(coslobe_cos_sin_f32 at);

/* circle_arc, uniform by arc length on a circle: 1 / pi per radian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_circle_arc_sample_f32(
    const coslobe_rng *rng, float direction[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_circle_arc_fill_f32(
    const coslobe_rng *rng, float *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_circle_arc_point_f32(
    float radius, const coslobe_rng *rng, float point[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_circle_arc_self_test_f32(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST float coslobe_circle_arc_pdf_f32(float theta);
COSLOBE_CONST float coslobe_circle_arc_ln_pdf_f32(float theta);
COSLOBE_CONST float coslobe_circle_arc_cdf_f32(float theta);
COSLOBE_CONST float coslobe_circle_arc_sf_f32(float theta);
COSLOBE_CONST float coslobe_circle_arc_quantile_f32(float p);
COSLOBE_CONST float coslobe_circle_arc_isf_f32(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_circle_arc_warp_f32(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_circle_arc_warp_sf_f32(float p);
COSLOBE_CONST float coslobe_circle_arc_unwarp_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_circle_arc_unwarp_sf_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_circle_arc_density_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_circle_arc_lambert_weight_f32(coslobe_cos_sin_f32 at);

/* ball, uniform by volume in a ball: 2 cos^3(theta) / pi per steradian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_ball_sample_f32(
    const coslobe_rng *rng, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_ball_sample_around_f32(
    const float normal[3], const coslobe_rng *rng, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_ball_fill_f32(
    const coslobe_rng *rng, float *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((3)) int coslobe_ball_warp_direction_f32(
    float p, float turn, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_ball_point_f32(
    float radius, const coslobe_rng *rng, float point[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_ball_self_test_f32(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST float coslobe_ball_pdf_f32(float theta);
COSLOBE_CONST float coslobe_ball_ln_pdf_f32(float theta);
COSLOBE_CONST float coslobe_ball_pdf_solid_angle_f32(float theta);
COSLOBE_CONST float coslobe_ball_cdf_f32(float theta);
COSLOBE_CONST float coslobe_ball_sf_f32(float theta);
COSLOBE_CONST float coslobe_ball_quantile_f32(float p);
COSLOBE_CONST float coslobe_ball_isf_f32(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_ball_warp_f32(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_ball_warp_sf_f32(float p);
COSLOBE_CONST float coslobe_ball_unwarp_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_ball_unwarp_sf_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_ball_density_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_ball_lambert_weight_f32(coslobe_cos_sin_f32 at);

/* sphere_shell, radial shell on a sphere: 3 cos^2(theta) / (2 pi) per steradian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_sphere_shell_sample_f32(
    const coslobe_rng *rng, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_sphere_shell_sample_around_f32(
    const float normal[3], const coslobe_rng *rng, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_sphere_shell_fill_f32(
    const coslobe_rng *rng, float *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((3)) int coslobe_sphere_shell_warp_direction_f32(
    float p, float turn, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_sphere_shell_point_f32(
    float radius, const coslobe_rng *rng, float point[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_sphere_shell_self_test_f32(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST float coslobe_sphere_shell_pdf_f32(float theta);
COSLOBE_CONST float coslobe_sphere_shell_ln_pdf_f32(float theta);
COSLOBE_CONST float coslobe_sphere_shell_pdf_solid_angle_f32(float theta);
COSLOBE_CONST float coslobe_sphere_shell_cdf_f32(float theta);
COSLOBE_CONST float coslobe_sphere_shell_sf_f32(float theta);
COSLOBE_CONST float coslobe_sphere_shell_quantile_f32(float p);
COSLOBE_CONST float coslobe_sphere_shell_isf_f32(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_sphere_shell_warp_f32(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_sphere_shell_warp_sf_f32(float p);
COSLOBE_CONST float coslobe_sphere_shell_unwarp_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_sphere_shell_unwarp_sf_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_sphere_shell_density_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_sphere_shell_lambert_weight_f32(coslobe_cos_sin_f32 at);

/* lambert, uniform by area on a sphere: cos(theta) / pi per steradian, Lambert's law. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_lambert_sample_f32(
    const coslobe_rng *rng, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_lambert_sample_around_f32(
    const float normal[3], const coslobe_rng *rng, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_lambert_fill_f32(
    const coslobe_rng *rng, float *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((3)) int coslobe_lambert_warp_direction_f32(
    float p, float turn, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_lambert_point_f32(
    float radius, const coslobe_rng *rng, float point[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_lambert_self_test_f32(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST float coslobe_lambert_pdf_f32(float theta);
COSLOBE_CONST float coslobe_lambert_ln_pdf_f32(float theta);
COSLOBE_CONST float coslobe_lambert_pdf_solid_angle_f32(float theta);
COSLOBE_CONST float coslobe_lambert_cdf_f32(float theta);
COSLOBE_CONST float coslobe_lambert_sf_f32(float theta);
COSLOBE_CONST float coslobe_lambert_quantile_f32(float p);
COSLOBE_CONST float coslobe_lambert_isf_f32(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_lambert_warp_f32(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_lambert_warp_sf_f32(float p);
COSLOBE_CONST float coslobe_lambert_unwarp_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_lambert_unwarp_sf_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_lambert_density_f32(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_lambert_lambert_weight_f32(coslobe_cos_sin_f32 at);

/* cos_power, the Phong lobe: (k + 1) cos^k(theta) / (2 pi) per steradian, k >= 0. */
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_cos_power_init_f32(
    coslobe_cos_power_f32 *law, float exponent);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_cos_power_sample_f32(
    const coslobe_cos_power_f32 *law, const coslobe_rng *rng, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3, 4)) int coslobe_cos_power_sample_around_f32(
    const coslobe_cos_power_f32 *law, const float normal[3], const coslobe_rng *rng,
    float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_cos_power_fill_f32(
    const coslobe_cos_power_f32 *law, const coslobe_rng *rng, float *directions, size_t n,
    size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 4)) int coslobe_cos_power_warp_direction_f32(
    const coslobe_cos_power_f32 *law, float p, float turn, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_cos_power_self_test_f32(
    const coslobe_cos_power_f32 *law, const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_NONNULL((1)) float coslobe_cos_power_pdf_f32(
    const coslobe_cos_power_f32 *law, float theta);
COSLOBE_NONNULL((1)) float coslobe_cos_power_ln_pdf_f32(
    const coslobe_cos_power_f32 *law, float theta);
COSLOBE_NONNULL((1)) float coslobe_cos_power_pdf_solid_angle_f32(
    const coslobe_cos_power_f32 *law, float theta);
COSLOBE_NONNULL((1)) float coslobe_cos_power_cdf_f32(
    const coslobe_cos_power_f32 *law, float theta);
COSLOBE_NONNULL((1)) float coslobe_cos_power_sf_f32(
    const coslobe_cos_power_f32 *law, float theta);
COSLOBE_NONNULL((1)) float coslobe_cos_power_quantile_f32(
    const coslobe_cos_power_f32 *law, float p);
COSLOBE_NONNULL((1)) float coslobe_cos_power_isf_f32(const coslobe_cos_power_f32 *law, float p);
COSLOBE_NONNULL((1)) coslobe_cos_sin_f32 coslobe_cos_power_warp_f32(
    const coslobe_cos_power_f32 *law, float p);
COSLOBE_NONNULL((1)) coslobe_cos_sin_f32 coslobe_cos_power_warp_sf_f32(
    const coslobe_cos_power_f32 *law, float p);
COSLOBE_NONNULL((1)) float coslobe_cos_power_unwarp_f32(
    const coslobe_cos_power_f32 *law, coslobe_cos_sin_f32 at);
COSLOBE_NONNULL((1)) float coslobe_cos_power_unwarp_sf_f32(
    const coslobe_cos_power_f32 *law, coslobe_cos_sin_f32 at);
COSLOBE_NONNULL((1)) float coslobe_cos_power_density_f32(
    const coslobe_cos_power_f32 *law, coslobe_cos_sin_f32 at);
COSLOBE_NONNULL((1)) float coslobe_cos_power_lambert_weight_f32(
    const coslobe_cos_power_f32 *law, coslobe_cos_sin_f32 at);

/* ---- fast: float to half its digits (relative error 2^-12): cheaper without an FPU ---- */

/* The law cos_power with its constants: coslobe_cos_power_init_fast fills it in. */
typedef struct coslobe_cos_power_fast {
    uint32_t state[24];
} coslobe_cos_power_fast;

/* disk, uniform by area in a disk: 2 cos^2(theta) / pi per radian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_disk_sample_fast(
    const coslobe_rng *rng, float direction[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_disk_fill_fast(
    const coslobe_rng *rng, float *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_disk_point_fast(
    float radius, const coslobe_rng *rng, float point[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_disk_self_test_fast(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST float coslobe_disk_pdf_fast(float theta);
COSLOBE_CONST float coslobe_disk_ln_pdf_fast(float theta);
COSLOBE_CONST float coslobe_disk_cdf_fast(float theta);
COSLOBE_CONST float coslobe_disk_sf_fast(float theta);
COSLOBE_CONST float coslobe_disk_quantile_fast(float p);
COSLOBE_CONST float coslobe_disk_isf_fast(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_disk_warp_fast(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_disk_warp_sf_fast(float p);
COSLOBE_CONST float coslobe_disk_unwarp_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_disk_unwarp_sf_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_disk_density_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_disk_lambert_weight_fast(coslobe_cos_sin_f32 at);

/* circle_shell, radial shell on a circle: cos(theta) / 2 per radian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_circle_shell_sample_fast(
    const coslobe_rng *rng, float direction[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_circle_shell_fill_fast(
    const coslobe_rng *rng, float *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_circle_shell_point_fast(
    float radius, const coslobe_rng *rng, float point[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_circle_shell_self_test_fast(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST float coslobe_circle_shell_pdf_fast(float theta);
COSLOBE_CONST float coslobe_circle_shell_ln_pdf_fast(float theta);
COSLOBE_CONST float coslobe_circle_shell_cdf_fast(float theta);
COSLOBE_CONST float coslobe_circle_shell_sf_fast(float theta);
COSLOBE_CONST float coslobe_circle_shell_quantile_fast(float p);
COSLOBE_CONST float coslobe_circle_shell_isf_fast(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_circle_shell_warp_fast(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_circle_shell_warp_sf_fast(float p);
COSLOBE_CONST float coslobe_circle_shell_unwarp_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_circle_shell_unwarp_sf_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_circle_shell_density_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_circle_shell_lambert_weight_fast(coslobe_cos_sin_f32 at);

/* circle_arc, uniform by arc length on a circle: 1 / pi per radian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_circle_arc_sample_fast(
    const coslobe_rng *rng, float direction[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_circle_arc_fill_fast(
    const coslobe_rng *rng, float *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_circle_arc_point_fast(
    float radius, const coslobe_rng *rng, float point[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_circle_arc_self_test_fast(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST float coslobe_circle_arc_pdf_fast(float theta);
COSLOBE_CONST float coslobe_circle_arc_ln_pdf_fast(float theta);
COSLOBE_CONST float coslobe_circle_arc_cdf_fast(float theta);
COSLOBE_CONST float coslobe_circle_arc_sf_fast(float theta);
COSLOBE_CONST float coslobe_circle_arc_quantile_fast(float p);
COSLOBE_CONST float coslobe_circle_arc_isf_fast(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_circle_arc_warp_fast(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_circle_arc_warp_sf_fast(float p);
COSLOBE_CONST float coslobe_circle_arc_unwarp_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_circle_arc_unwarp_sf_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_circle_arc_density_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_circle_arc_lambert_weight_fast(coslobe_cos_sin_f32 at);

/* ball, uniform by volume in a ball: 2 cos^3(theta) / pi per steradian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_ball_sample_fast(
    const coslobe_rng *rng, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_ball_sample_around_fast(
    const float normal[3], const coslobe_rng *rng, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_ball_fill_fast(
    const coslobe_rng *rng, float *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((3)) int coslobe_ball_warp_direction_fast(
    float p, float turn, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_ball_point_fast(
    float radius, const coslobe_rng *rng, float point[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_ball_self_test_fast(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST float coslobe_ball_pdf_fast(float theta);
COSLOBE_CONST float coslobe_ball_ln_pdf_fast(float theta);
COSLOBE_CONST float coslobe_ball_pdf_solid_angle_fast(float theta);
COSLOBE_CONST float coslobe_ball_cdf_fast(float theta);
COSLOBE_CONST float coslobe_ball_sf_fast(float theta);
COSLOBE_CONST float coslobe_ball_quantile_fast(float p);
COSLOBE_CONST float coslobe_ball_isf_fast(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_ball_warp_fast(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_ball_warp_sf_fast(float p);
COSLOBE_CONST float coslobe_ball_unwarp_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_ball_unwarp_sf_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_ball_density_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_ball_lambert_weight_fast(coslobe_cos_sin_f32 at);

/* sphere_shell, radial shell on a sphere: 3 cos^2(theta) / (2 pi) per steradian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_sphere_shell_sample_fast(
    const coslobe_rng *rng, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_sphere_shell_sample_around_fast(
    const float normal[3], const coslobe_rng *rng, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_sphere_shell_fill_fast(
    const coslobe_rng *rng, float *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((3)) int coslobe_sphere_shell_warp_direction_fast(
    float p, float turn, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_sphere_shell_point_fast(
    float radius, const coslobe_rng *rng, float point[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_sphere_shell_self_test_fast(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST float coslobe_sphere_shell_pdf_fast(float theta);
COSLOBE_CONST float coslobe_sphere_shell_ln_pdf_fast(float theta);
COSLOBE_CONST float coslobe_sphere_shell_pdf_solid_angle_fast(float theta);
COSLOBE_CONST float coslobe_sphere_shell_cdf_fast(float theta);
COSLOBE_CONST float coslobe_sphere_shell_sf_fast(float theta);
COSLOBE_CONST float coslobe_sphere_shell_quantile_fast(float p);
COSLOBE_CONST float coslobe_sphere_shell_isf_fast(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_sphere_shell_warp_fast(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_sphere_shell_warp_sf_fast(float p);
COSLOBE_CONST float coslobe_sphere_shell_unwarp_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_sphere_shell_unwarp_sf_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_sphere_shell_density_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_sphere_shell_lambert_weight_fast(coslobe_cos_sin_f32 at);

/* lambert, uniform by area on a sphere: cos(theta) / pi per steradian, Lambert's law. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_lambert_sample_fast(
    const coslobe_rng *rng, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_lambert_sample_around_fast(
    const float normal[3], const coslobe_rng *rng, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_lambert_fill_fast(
    const coslobe_rng *rng, float *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((3)) int coslobe_lambert_warp_direction_fast(
    float p, float turn, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_lambert_point_fast(
    float radius, const coslobe_rng *rng, float point[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_lambert_self_test_fast(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST float coslobe_lambert_pdf_fast(float theta);
COSLOBE_CONST float coslobe_lambert_ln_pdf_fast(float theta);
COSLOBE_CONST float coslobe_lambert_pdf_solid_angle_fast(float theta);
COSLOBE_CONST float coslobe_lambert_cdf_fast(float theta);
COSLOBE_CONST float coslobe_lambert_sf_fast(float theta);
COSLOBE_CONST float coslobe_lambert_quantile_fast(float p);
COSLOBE_CONST float coslobe_lambert_isf_fast(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_lambert_warp_fast(float p);
COSLOBE_CONST coslobe_cos_sin_f32 coslobe_lambert_warp_sf_fast(float p);
COSLOBE_CONST float coslobe_lambert_unwarp_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_lambert_unwarp_sf_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_lambert_density_fast(coslobe_cos_sin_f32 at);
COSLOBE_CONST float coslobe_lambert_lambert_weight_fast(coslobe_cos_sin_f32 at);

/* cos_power, the Phong lobe: (k + 1) cos^k(theta) / (2 pi) per steradian, k >= 0. */
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_cos_power_init_fast(
    coslobe_cos_power_fast *law, float exponent);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_cos_power_sample_fast(
    const coslobe_cos_power_fast *law, const coslobe_rng *rng, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3, 4)) int coslobe_cos_power_sample_around_fast(
    const coslobe_cos_power_fast *law, const float normal[3], const coslobe_rng *rng,
    float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_cos_power_fill_fast(
    const coslobe_cos_power_fast *law, const coslobe_rng *rng, float *directions, size_t n,
    size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 4)) int coslobe_cos_power_warp_direction_fast(
    const coslobe_cos_power_fast *law, float p, float turn, float direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_cos_power_self_test_fast(
    const coslobe_cos_power_fast *law, const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_NONNULL((1)) float coslobe_cos_power_pdf_fast(
    const coslobe_cos_power_fast *law, float theta);
COSLOBE_NONNULL((1)) float coslobe_cos_power_ln_pdf_fast(
    const coslobe_cos_power_fast *law, float theta);
COSLOBE_NONNULL((1)) float coslobe_cos_power_pdf_solid_angle_fast(
    const coslobe_cos_power_fast *law, float theta);
COSLOBE_NONNULL((1)) float coslobe_cos_power_cdf_fast(
    const coslobe_cos_power_fast *law, float theta);
COSLOBE_NONNULL((1)) float coslobe_cos_power_sf_fast(
    const coslobe_cos_power_fast *law, float theta);
COSLOBE_NONNULL((1)) float coslobe_cos_power_quantile_fast(
    const coslobe_cos_power_fast *law, float p);
COSLOBE_NONNULL((1)) float coslobe_cos_power_isf_fast(
    const coslobe_cos_power_fast *law, float p);
COSLOBE_NONNULL((1)) coslobe_cos_sin_f32 coslobe_cos_power_warp_fast(
    const coslobe_cos_power_fast *law, float p);
COSLOBE_NONNULL((1)) coslobe_cos_sin_f32 coslobe_cos_power_warp_sf_fast(
    const coslobe_cos_power_fast *law, float p);
COSLOBE_NONNULL((1)) float coslobe_cos_power_unwarp_fast(
    const coslobe_cos_power_fast *law, coslobe_cos_sin_f32 at);
COSLOBE_NONNULL((1)) float coslobe_cos_power_unwarp_sf_fast(
    const coslobe_cos_power_fast *law, coslobe_cos_sin_f32 at);
COSLOBE_NONNULL((1)) float coslobe_cos_power_density_fast(
    const coslobe_cos_power_fast *law, coslobe_cos_sin_f32 at);
COSLOBE_NONNULL((1)) float coslobe_cos_power_lambert_weight_fast(
    const coslobe_cos_power_fast *law, coslobe_cos_sin_f32 at);

/* ---- q31: 32-bit integers: no floating-point instruction or routine is linked ---- */

/* The law cos_power with its constants: coslobe_cos_power_init_q31 fills it in. */
typedef struct coslobe_cos_power_q31 {
    uint32_t state[10];
} coslobe_cos_power_q31;

/* disk, uniform by area in a disk: 2 cos^2(theta) / pi per radian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_disk_sample_q31(
    const coslobe_rng *rng, coslobe_q31 direction[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_disk_fill_q31(
    const coslobe_rng *rng, coslobe_q31 *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_disk_point_q31(
    int32_t radius, const coslobe_rng *rng, int32_t point[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_disk_self_test_q31(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST coslobe_density_q32 coslobe_disk_pdf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_probability_q32 coslobe_disk_cdf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_probability_q32 coslobe_disk_sf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_turn_q32 coslobe_disk_quantile_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_turn_q32 coslobe_disk_isf_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_cos_sin_q31 coslobe_disk_warp_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_cos_sin_q31 coslobe_disk_warp_sf_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_probability_q32 coslobe_disk_unwarp_q31(coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_probability_q32 coslobe_disk_unwarp_sf_q31(coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_density_q32 coslobe_disk_density_q31(coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_weight_q16_16 coslobe_disk_lambert_weight_q31(coslobe_cos_sin_q31 at);

/* circle_shell, radial shell on a circle: cos(theta) / 2 per radian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_circle_shell_sample_q31(
    const coslobe_rng *rng, coslobe_q31 direction[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_circle_shell_fill_q31(
    const coslobe_rng *rng, coslobe_q31 *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_circle_shell_point_q31(
    int32_t radius, const coslobe_rng *rng, int32_t point[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_circle_shell_self_test_q31(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST coslobe_density_q32 coslobe_circle_shell_pdf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_probability_q32 coslobe_circle_shell_cdf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_probability_q32 coslobe_circle_shell_sf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_turn_q32 coslobe_circle_shell_quantile_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_turn_q32 coslobe_circle_shell_isf_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_cos_sin_q31 coslobe_circle_shell_warp_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_cos_sin_q31 coslobe_circle_shell_warp_sf_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_probability_q32 coslobe_circle_shell_unwarp_q31(coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_probability_q32 coslobe_circle_shell_unwarp_sf_q31(
    coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_density_q32 coslobe_circle_shell_density_q31(coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_weight_q16_16 coslobe_circle_shell_lambert_weight_q31(
    coslobe_cos_sin_q31 at);

/* circle_arc, uniform by arc length on a circle: 1 / pi per radian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_circle_arc_sample_q31(
    const coslobe_rng *rng, coslobe_q31 direction[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_circle_arc_fill_q31(
    const coslobe_rng *rng, coslobe_q31 *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_circle_arc_point_q31(
    int32_t radius, const coslobe_rng *rng, int32_t point[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_circle_arc_self_test_q31(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST coslobe_density_q32 coslobe_circle_arc_pdf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_probability_q32 coslobe_circle_arc_cdf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_probability_q32 coslobe_circle_arc_sf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_turn_q32 coslobe_circle_arc_quantile_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_turn_q32 coslobe_circle_arc_isf_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_cos_sin_q31 coslobe_circle_arc_warp_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_cos_sin_q31 coslobe_circle_arc_warp_sf_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_probability_q32 coslobe_circle_arc_unwarp_q31(coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_probability_q32 coslobe_circle_arc_unwarp_sf_q31(coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_density_q32 coslobe_circle_arc_density_q31(coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_weight_q16_16 coslobe_circle_arc_lambert_weight_q31(
    coslobe_cos_sin_q31 at);

/* ball, uniform by volume in a ball: 2 cos^3(theta) / pi per steradian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_ball_sample_q31(
    const coslobe_rng *rng, coslobe_q31 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_ball_sample_around_q31(
    const coslobe_q31 normal[3], const coslobe_rng *rng, coslobe_q31 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_ball_fill_q31(
    const coslobe_rng *rng, coslobe_q31 *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((3)) int coslobe_ball_warp_direction_q31(
    coslobe_probability_q32 p, coslobe_probability_q32 turn, coslobe_q31 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_ball_point_q31(
    int32_t radius, const coslobe_rng *rng, int32_t point[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_ball_self_test_q31(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST coslobe_density_q32 coslobe_ball_pdf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_density_q32 coslobe_ball_pdf_solid_angle_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_probability_q32 coslobe_ball_cdf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_probability_q32 coslobe_ball_sf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_turn_q32 coslobe_ball_quantile_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_turn_q32 coslobe_ball_isf_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_cos_sin_q31 coslobe_ball_warp_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_cos_sin_q31 coslobe_ball_warp_sf_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_probability_q32 coslobe_ball_unwarp_q31(coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_probability_q32 coslobe_ball_unwarp_sf_q31(coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_density_q32 coslobe_ball_density_q31(coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_weight_q16_16 coslobe_ball_lambert_weight_q31(coslobe_cos_sin_q31 at);

/* sphere_shell, radial shell on a sphere: 3 cos^2(theta) / (2 pi) per steradian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_sphere_shell_sample_q31(
    const coslobe_rng *rng, coslobe_q31 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_sphere_shell_sample_around_q31(
    const coslobe_q31 normal[3], const coslobe_rng *rng, coslobe_q31 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_sphere_shell_fill_q31(
    const coslobe_rng *rng, coslobe_q31 *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((3)) int coslobe_sphere_shell_warp_direction_q31(
    coslobe_probability_q32 p, coslobe_probability_q32 turn, coslobe_q31 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_sphere_shell_point_q31(
    int32_t radius, const coslobe_rng *rng, int32_t point[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_sphere_shell_self_test_q31(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST coslobe_density_q32 coslobe_sphere_shell_pdf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_density_q32 coslobe_sphere_shell_pdf_solid_angle_q31(
    coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_probability_q32 coslobe_sphere_shell_cdf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_probability_q32 coslobe_sphere_shell_sf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_turn_q32 coslobe_sphere_shell_quantile_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_turn_q32 coslobe_sphere_shell_isf_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_cos_sin_q31 coslobe_sphere_shell_warp_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_cos_sin_q31 coslobe_sphere_shell_warp_sf_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_probability_q32 coslobe_sphere_shell_unwarp_q31(coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_probability_q32 coslobe_sphere_shell_unwarp_sf_q31(
    coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_density_q32 coslobe_sphere_shell_density_q31(coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_weight_q16_16 coslobe_sphere_shell_lambert_weight_q31(
    coslobe_cos_sin_q31 at);

/* lambert, uniform by area on a sphere: cos(theta) / pi per steradian, Lambert's law. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_lambert_sample_q31(
    const coslobe_rng *rng, coslobe_q31 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_lambert_sample_around_q31(
    const coslobe_q31 normal[3], const coslobe_rng *rng, coslobe_q31 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_lambert_fill_q31(
    const coslobe_rng *rng, coslobe_q31 *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((3)) int coslobe_lambert_warp_direction_q31(
    coslobe_probability_q32 p, coslobe_probability_q32 turn, coslobe_q31 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_lambert_point_q31(
    int32_t radius, const coslobe_rng *rng, int32_t point[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_lambert_self_test_q31(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST coslobe_density_q32 coslobe_lambert_pdf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_density_q32 coslobe_lambert_pdf_solid_angle_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_probability_q32 coslobe_lambert_cdf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_probability_q32 coslobe_lambert_sf_q31(coslobe_turn_q32 theta);
COSLOBE_CONST coslobe_turn_q32 coslobe_lambert_quantile_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_turn_q32 coslobe_lambert_isf_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_cos_sin_q31 coslobe_lambert_warp_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_cos_sin_q31 coslobe_lambert_warp_sf_q31(coslobe_probability_q32 p);
COSLOBE_CONST coslobe_probability_q32 coslobe_lambert_unwarp_q31(coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_probability_q32 coslobe_lambert_unwarp_sf_q31(coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_density_q32 coslobe_lambert_density_q31(coslobe_cos_sin_q31 at);
COSLOBE_CONST coslobe_weight_q16_16 coslobe_lambert_lambert_weight_q31(coslobe_cos_sin_q31 at);

/* cos_power, the Phong lobe: (k + 1) cos^k(theta) / (2 pi) per steradian, k >= 0. */
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_cos_power_init_q31(
    coslobe_cos_power_q31 *law, coslobe_exponent_q16_16 exponent);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_cos_power_sample_q31(
    const coslobe_cos_power_q31 *law, const coslobe_rng *rng, coslobe_q31 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3, 4)) int coslobe_cos_power_sample_around_q31(
    const coslobe_cos_power_q31 *law, const coslobe_q31 normal[3], const coslobe_rng *rng,
    coslobe_q31 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_cos_power_fill_q31(
    const coslobe_cos_power_q31 *law, const coslobe_rng *rng, coslobe_q31 *directions,
    size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 4)) int coslobe_cos_power_warp_direction_q31(
    const coslobe_cos_power_q31 *law, coslobe_probability_q32 p,
    coslobe_probability_q32 turn, coslobe_q31 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_cos_power_self_test_q31(
    const coslobe_cos_power_q31 *law, const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_NONNULL((1)) coslobe_density_q16_16 coslobe_cos_power_pdf_q31(
    const coslobe_cos_power_q31 *law, coslobe_turn_q32 theta);
COSLOBE_NONNULL((1)) coslobe_density_q16_16 coslobe_cos_power_pdf_solid_angle_q31(
    const coslobe_cos_power_q31 *law, coslobe_turn_q32 theta);
COSLOBE_NONNULL((1)) coslobe_probability_q32 coslobe_cos_power_cdf_q31(
    const coslobe_cos_power_q31 *law, coslobe_turn_q32 theta);
COSLOBE_NONNULL((1)) coslobe_probability_q32 coslobe_cos_power_sf_q31(
    const coslobe_cos_power_q31 *law, coslobe_turn_q32 theta);
COSLOBE_NONNULL((1)) coslobe_turn_q32 coslobe_cos_power_quantile_q31(
    const coslobe_cos_power_q31 *law, coslobe_probability_q32 p);
COSLOBE_NONNULL((1)) coslobe_turn_q32 coslobe_cos_power_isf_q31(
    const coslobe_cos_power_q31 *law, coslobe_probability_q32 p);
COSLOBE_NONNULL((1)) coslobe_cos_sin_q31 coslobe_cos_power_warp_q31(
    const coslobe_cos_power_q31 *law, coslobe_probability_q32 p);
COSLOBE_NONNULL((1)) coslobe_cos_sin_q31 coslobe_cos_power_warp_sf_q31(
    const coslobe_cos_power_q31 *law, coslobe_probability_q32 p);
COSLOBE_NONNULL((1)) coslobe_probability_q32 coslobe_cos_power_unwarp_q31(
    const coslobe_cos_power_q31 *law, coslobe_cos_sin_q31 at);
COSLOBE_NONNULL((1)) coslobe_probability_q32 coslobe_cos_power_unwarp_sf_q31(
    const coslobe_cos_power_q31 *law, coslobe_cos_sin_q31 at);
COSLOBE_NONNULL((1)) coslobe_density_q16_16 coslobe_cos_power_density_q31(
    const coslobe_cos_power_q31 *law, coslobe_cos_sin_q31 at);
COSLOBE_NONNULL((1)) coslobe_weight_q16_16 coslobe_cos_power_lambert_weight_q31(
    const coslobe_cos_power_q31 *law, coslobe_cos_sin_q31 at);

/* ---- q15: 16-bit integers: a third of the instructions on a Cortex-M0 ---- */

/* disk, uniform by area in a disk: 2 cos^2(theta) / pi per radian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_disk_sample_q15(
    const coslobe_rng *rng, coslobe_q15 direction[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_disk_fill_q15(
    const coslobe_rng *rng, coslobe_q15 *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_disk_point_q15(
    int16_t radius, const coslobe_rng *rng, int16_t point[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_disk_self_test_q15(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST coslobe_density_q16 coslobe_disk_pdf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_probability_q16 coslobe_disk_cdf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_probability_q16 coslobe_disk_sf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_turn_q16 coslobe_disk_quantile_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_turn_q16 coslobe_disk_isf_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_cos_sin_q15 coslobe_disk_warp_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_cos_sin_q15 coslobe_disk_warp_sf_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_probability_q16 coslobe_disk_unwarp_q15(coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_probability_q16 coslobe_disk_unwarp_sf_q15(coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_density_q16 coslobe_disk_density_q15(coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_weight_q16_16 coslobe_disk_lambert_weight_q15(coslobe_cos_sin_q15 at);

/* circle_shell, radial shell on a circle: cos(theta) / 2 per radian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_circle_shell_sample_q15(
    const coslobe_rng *rng, coslobe_q15 direction[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_circle_shell_fill_q15(
    const coslobe_rng *rng, coslobe_q15 *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_circle_shell_point_q15(
    int16_t radius, const coslobe_rng *rng, int16_t point[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_circle_shell_self_test_q15(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST coslobe_density_q16 coslobe_circle_shell_pdf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_probability_q16 coslobe_circle_shell_cdf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_probability_q16 coslobe_circle_shell_sf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_turn_q16 coslobe_circle_shell_quantile_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_turn_q16 coslobe_circle_shell_isf_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_cos_sin_q15 coslobe_circle_shell_warp_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_cos_sin_q15 coslobe_circle_shell_warp_sf_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_probability_q16 coslobe_circle_shell_unwarp_q15(coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_probability_q16 coslobe_circle_shell_unwarp_sf_q15(
    coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_density_q16 coslobe_circle_shell_density_q15(coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_weight_q16_16 coslobe_circle_shell_lambert_weight_q15(
    coslobe_cos_sin_q15 at);

/* circle_arc, uniform by arc length on a circle: 1 / pi per radian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_circle_arc_sample_q15(
    const coslobe_rng *rng, coslobe_q15 direction[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_circle_arc_fill_q15(
    const coslobe_rng *rng, coslobe_q15 *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_circle_arc_point_q15(
    int16_t radius, const coslobe_rng *rng, int16_t point[2]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_circle_arc_self_test_q15(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST coslobe_density_q16 coslobe_circle_arc_pdf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_probability_q16 coslobe_circle_arc_cdf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_probability_q16 coslobe_circle_arc_sf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_turn_q16 coslobe_circle_arc_quantile_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_turn_q16 coslobe_circle_arc_isf_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_cos_sin_q15 coslobe_circle_arc_warp_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_cos_sin_q15 coslobe_circle_arc_warp_sf_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_probability_q16 coslobe_circle_arc_unwarp_q15(coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_probability_q16 coslobe_circle_arc_unwarp_sf_q15(coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_density_q16 coslobe_circle_arc_density_q15(coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_weight_q16_16 coslobe_circle_arc_lambert_weight_q15(
    coslobe_cos_sin_q15 at);

/* ball, uniform by volume in a ball: 2 cos^3(theta) / pi per steradian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_ball_sample_q15(
    const coslobe_rng *rng, coslobe_q15 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_ball_sample_around_q15(
    const coslobe_q15 normal[3], const coslobe_rng *rng, coslobe_q15 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_ball_fill_q15(
    const coslobe_rng *rng, coslobe_q15 *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((3)) int coslobe_ball_warp_direction_q15(
    coslobe_probability_q16 p, coslobe_probability_q16 turn, coslobe_q15 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_ball_point_q15(
    int16_t radius, const coslobe_rng *rng, int16_t point[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_ball_self_test_q15(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST coslobe_density_q16 coslobe_ball_pdf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_density_q16 coslobe_ball_pdf_solid_angle_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_probability_q16 coslobe_ball_cdf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_probability_q16 coslobe_ball_sf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_turn_q16 coslobe_ball_quantile_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_turn_q16 coslobe_ball_isf_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_cos_sin_q15 coslobe_ball_warp_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_cos_sin_q15 coslobe_ball_warp_sf_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_probability_q16 coslobe_ball_unwarp_q15(coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_probability_q16 coslobe_ball_unwarp_sf_q15(coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_density_q16 coslobe_ball_density_q15(coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_weight_q16_16 coslobe_ball_lambert_weight_q15(coslobe_cos_sin_q15 at);

/* sphere_shell, radial shell on a sphere: 3 cos^2(theta) / (2 pi) per steradian. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_sphere_shell_sample_q15(
    const coslobe_rng *rng, coslobe_q15 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_sphere_shell_sample_around_q15(
    const coslobe_q15 normal[3], const coslobe_rng *rng, coslobe_q15 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_sphere_shell_fill_q15(
    const coslobe_rng *rng, coslobe_q15 *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((3)) int coslobe_sphere_shell_warp_direction_q15(
    coslobe_probability_q16 p, coslobe_probability_q16 turn, coslobe_q15 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_sphere_shell_point_q15(
    int16_t radius, const coslobe_rng *rng, int16_t point[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_sphere_shell_self_test_q15(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST coslobe_density_q16 coslobe_sphere_shell_pdf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_density_q16 coslobe_sphere_shell_pdf_solid_angle_q15(
    coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_probability_q16 coslobe_sphere_shell_cdf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_probability_q16 coslobe_sphere_shell_sf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_turn_q16 coslobe_sphere_shell_quantile_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_turn_q16 coslobe_sphere_shell_isf_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_cos_sin_q15 coslobe_sphere_shell_warp_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_cos_sin_q15 coslobe_sphere_shell_warp_sf_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_probability_q16 coslobe_sphere_shell_unwarp_q15(coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_probability_q16 coslobe_sphere_shell_unwarp_sf_q15(
    coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_density_q16 coslobe_sphere_shell_density_q15(coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_weight_q16_16 coslobe_sphere_shell_lambert_weight_q15(
    coslobe_cos_sin_q15 at);

/* lambert, uniform by area on a sphere: cos(theta) / pi per steradian, Lambert's law. */
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_lambert_sample_q15(
    const coslobe_rng *rng, coslobe_q15 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2, 3)) int coslobe_lambert_sample_around_q15(
    const coslobe_q15 normal[3], const coslobe_rng *rng, coslobe_q15 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1, 2)) int coslobe_lambert_fill_q15(
    const coslobe_rng *rng, coslobe_q15 *directions, size_t n, size_t *filled);
COSLOBE_CHECKED COSLOBE_NONNULL((3)) int coslobe_lambert_warp_direction_q15(
    coslobe_probability_q16 p, coslobe_probability_q16 turn, coslobe_q15 direction[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((2, 3)) int coslobe_lambert_point_q15(
    int16_t radius, const coslobe_rng *rng, int16_t point[3]);
COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_lambert_self_test_q15(
    const coslobe_rng *rng, coslobe_fault *fault);
COSLOBE_CONST coslobe_density_q16 coslobe_lambert_pdf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_density_q16 coslobe_lambert_pdf_solid_angle_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_probability_q16 coslobe_lambert_cdf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_probability_q16 coslobe_lambert_sf_q15(coslobe_turn_q16 theta);
COSLOBE_CONST coslobe_turn_q16 coslobe_lambert_quantile_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_turn_q16 coslobe_lambert_isf_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_cos_sin_q15 coslobe_lambert_warp_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_cos_sin_q15 coslobe_lambert_warp_sf_q15(coslobe_probability_q16 p);
COSLOBE_CONST coslobe_probability_q16 coslobe_lambert_unwarp_q15(coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_probability_q16 coslobe_lambert_unwarp_sf_q15(coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_density_q16 coslobe_lambert_density_q15(coslobe_cos_sin_q15 at);
COSLOBE_CONST coslobe_weight_q16_16 coslobe_lambert_lambert_weight_q15(coslobe_cos_sin_q15 at);

#ifdef __cplusplus
}
#endif

#endif
