/* coslobe for C: made by cbindgen from examples/firmware/c_api/src, not by hand.
 *
 * θ is the angle from the axis +y. NaN in, NaN out; no call allocates, keeps state or fails but by its status. */

#ifndef COSLOBE_H
#define COSLOBE_H

#include <stdint.h>

/*
 What became of a call that writes through a pointer.
 */
enum coslobe_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /*
   The result was written.
   */
  COSLOBE_STATUS_OK = 0,
  /*
   The generator, its function or the result is a null pointer: nothing was drawn or written.
   */
  COSLOBE_STATUS_NULL_POINTER = 1,
  /*
   The exponent is NaN, negative or infinite: nothing was drawn or written.
   */
  COSLOBE_STATUS_EXPONENT = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum coslobe_status coslobe_status;
#else
typedef int32_t coslobe_status;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/*
 A generator of random words.
 */
typedef struct coslobe_rng {
  /*
   Returns 32 uniform bits; called with `context`. Where 64 bits are taken, the low word comes first.
   */
  uint32_t (*next_u32)(void *context);
  /*
   Handed to `next_u32`; may be null.
   */
  void *context;
} coslobe_rng;

/*
 A direction by the cosine and sine of its angle from the axis.
 */
typedef struct coslobe_cos_sin_f32 {
  float cos;
  float sin;
} coslobe_cos_sin_f32;

/*
 A direction by the cosine and sine of its angle from the axis, in units of 2⁻³¹: 1 is 2³¹ − 1.
 */
typedef struct coslobe_cos_sin_q31 {
  int32_t cos;
  int32_t sin;
} coslobe_cos_sin_q31;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/*
 Draws a direction [sin θ cos φ, cos θ, sin θ sin φ] of `Ball`, uniform by volume in a ball: 3 words of `rng`.

 # Safety
 Each pointer is null, which is answered by its status, or valid.
 */
coslobe_status coslobe_ball_sample_f32(const struct coslobe_rng *rng,
                                       float (*direction)[3]);

/*
 (cos θ, sin θ) of `Ball` at cdf = `u` from 0 to 1; NaN elsewhere.
 */
struct coslobe_cos_sin_f32 coslobe_ball_warp_f32(float u);

/*
 Density of `Ball` at a direction: 2 cos³θ / π per steradian, θ from 0 to π/2; 0 elsewhere.
 */
float coslobe_ball_density_f32(struct coslobe_cos_sin_f32 at);

/*
 P(Θ ≤ `theta`) of `Ball`; `theta` in radians from 0 to π/2, 0 below and 1 above.
 */
float coslobe_ball_cdf_f32(float theta);

/*
 θ in radians of `Ball` at cdf = `p` from 0 to 1; NaN elsewhere.
 */
float coslobe_ball_quantile_f32(float p);

/*
 Draws a direction [sin θ, cos θ] of `CircleArc`, uniform by arc length on a circle: 2 words of `rng`.

 # Safety
 Each pointer is null, which is answered by its status, or valid.
 */
coslobe_status coslobe_circle_arc_sample_f32(const struct coslobe_rng *rng,
                                             float (*direction)[2]);

/*
 (cos θ, sin θ) of `CircleArc` at cdf = `u` from 0 to 1; NaN elsewhere.
 */
struct coslobe_cos_sin_f32 coslobe_circle_arc_warp_f32(float u);

/*
 Density of `CircleArc` at a direction: 1/π per radian, θ from −π/2 to π/2; 0 elsewhere.
 */
float coslobe_circle_arc_density_f32(struct coslobe_cos_sin_f32 at);

/*
 P(Θ ≤ `theta`) of `CircleArc`; `theta` in radians from −π/2 to π/2, 0 below and 1 above.
 */
float coslobe_circle_arc_cdf_f32(float theta);

/*
 θ in radians of `CircleArc` at cdf = `p` from 0 to 1; NaN elsewhere.
 */
float coslobe_circle_arc_quantile_f32(float p);

/*
 Draws a direction [sin θ, cos θ] of `CircleShell`, uniform by radial shell on a circle: the flat Lambert law: 2 words of `rng`.

 # Safety
 Each pointer is null, which is answered by its status, or valid.
 */
coslobe_status coslobe_circle_shell_sample_f32(const struct coslobe_rng *rng,
                                               float (*direction)[2]);

/*
 (cos θ, sin θ) of `CircleShell` at cdf = `u` from 0 to 1; NaN elsewhere.
 */
struct coslobe_cos_sin_f32 coslobe_circle_shell_warp_f32(float u);

/*
 Density of `CircleShell` at a direction: cos θ / 2 per radian, θ from −π/2 to π/2; 0 elsewhere.
 */
float coslobe_circle_shell_density_f32(struct coslobe_cos_sin_f32 at);

/*
 P(Θ ≤ `theta`) of `CircleShell`; `theta` in radians from −π/2 to π/2, 0 below and 1 above.
 */
float coslobe_circle_shell_cdf_f32(float theta);

/*
 θ in radians of `CircleShell` at cdf = `p` from 0 to 1; NaN elsewhere.
 */
float coslobe_circle_shell_quantile_f32(float p);

/*
 Draws a direction [sin θ cos φ, cos θ, sin θ sin φ] of the law ∝ cosᵏθ, k = `exponent` ≥ 0 and finite:
 3 words of `rng`.

 # Safety
 Each pointer is null, which is answered by its status, or valid.
 */
coslobe_status coslobe_cos_power_sample_f32(float exponent,
                                            const struct coslobe_rng *rng,
                                            float (*direction)[3]);

/*
 (cos θ, sin θ) of the law ∝ cosᵏθ at cdf = `u` from 0 to 1; NaN elsewhere, and for a bad `exponent`.
 */
struct coslobe_cos_sin_f32 coslobe_cos_power_warp_f32(float exponent,
                                                      float u);

/*
 Density of the law ∝ cosᵏθ at a direction: (k+1) cosᵏθ / 2π per steradian, θ from 0 to π/2; 0 elsewhere,
 NaN for a bad `exponent`.
 */
float coslobe_cos_power_density_f32(float exponent,
                                    struct coslobe_cos_sin_f32 at);

/*
 P(Θ ≤ `theta`) of the law ∝ cosᵏθ; `theta` in radians from 0 to π/2, 0 below and 1 above. NaN for a bad
 `exponent`.
 */
float coslobe_cos_power_cdf_f32(float exponent,
                                float theta);

/*
 θ in radians of the law ∝ cosᵏθ at cdf = `p` from 0 to 1; NaN elsewhere, and for a bad `exponent`.
 */
float coslobe_cos_power_quantile_f32(float exponent,
                                     float p);

/*
 Draws a direction [sin θ, cos θ] of `Disk`, uniform by area in a disk: 2 words of `rng`.

 # Safety
 Each pointer is null, which is answered by its status, or valid.
 */
coslobe_status coslobe_disk_sample_f32(const struct coslobe_rng *rng, float (*direction)[2]);

/*
 (cos θ, sin θ) of `Disk` at cdf = `u` from 0 to 1; NaN elsewhere.
 */
struct coslobe_cos_sin_f32 coslobe_disk_warp_f32(float u);

/*
 Density of `Disk` at a direction: 2 cos²θ / π per radian, θ from −π/2 to π/2; 0 elsewhere.
 */
float coslobe_disk_density_f32(struct coslobe_cos_sin_f32 at);

/*
 P(Θ ≤ `theta`) of `Disk`; `theta` in radians from −π/2 to π/2, 0 below and 1 above.
 */
float coslobe_disk_cdf_f32(float theta);

/*
 θ in radians of `Disk` at cdf = `p` from 0 to 1; NaN elsewhere.
 */
float coslobe_disk_quantile_f32(float p);

/*
 Draws a direction [sin θ cos φ, cos θ, sin θ sin φ] of `Lambert`, uniform by area on a sphere: 3 words of `rng`.

 # Safety
 Each pointer is null, which is answered by its status, or valid.
 */
coslobe_status coslobe_lambert_sample_f32(const struct coslobe_rng *rng,
                                          float (*direction)[3]);

/*
 (cos θ, sin θ) of `Lambert` at cdf = `u` from 0 to 1; NaN elsewhere.
 */
struct coslobe_cos_sin_f32 coslobe_lambert_warp_f32(float u);

/*
 Density of `Lambert` at a direction: cos θ / π per steradian, θ from 0 to π/2; 0 elsewhere.
 */
float coslobe_lambert_density_f32(struct coslobe_cos_sin_f32 at);

/*
 P(Θ ≤ `theta`) of `Lambert`; `theta` in radians from 0 to π/2, 0 below and 1 above.
 */
float coslobe_lambert_cdf_f32(float theta);

/*
 θ in radians of `Lambert` at cdf = `p` from 0 to 1; NaN elsewhere.
 */
float coslobe_lambert_quantile_f32(float p);

/*
 Draws a direction [sin θ cos φ, cos θ, sin θ sin φ] of `SphereShell`, uniform by radial shell on a sphere: 3 words of `rng`.

 # Safety
 Each pointer is null, which is answered by its status, or valid.
 */
coslobe_status coslobe_sphere_shell_sample_f32(const struct coslobe_rng *rng,
                                               float (*direction)[3]);

/*
 (cos θ, sin θ) of `SphereShell` at cdf = `u` from 0 to 1; NaN elsewhere.
 */
struct coslobe_cos_sin_f32 coslobe_sphere_shell_warp_f32(float u);

/*
 Density of `SphereShell` at a direction: 3 cos²θ / 2π per steradian, θ from 0 to π/2; 0 elsewhere.
 */
float coslobe_sphere_shell_density_f32(struct coslobe_cos_sin_f32 at);

/*
 P(Θ ≤ `theta`) of `SphereShell`; `theta` in radians from 0 to π/2, 0 below and 1 above.
 */
float coslobe_sphere_shell_cdf_f32(float theta);

/*
 θ in radians of `SphereShell` at cdf = `p` from 0 to 1; NaN elsewhere.
 */
float coslobe_sphere_shell_quantile_f32(float p);

/*
 Draws a direction [sin θ cos φ, cos θ, sin θ sin φ] of `Ball`, uniform by volume in a ball; components in units of 2⁻³¹.

 # Safety
 Each pointer is null, which is answered by its status, or valid.
 */
coslobe_status coslobe_ball_sample_q31(const struct coslobe_rng *rng,
                                       int32_t (*direction)[3]);

/*
 (cos θ, sin θ) of `Ball` at cdf = `u`, in units of 2⁻³².
 */
struct coslobe_cos_sin_q31 coslobe_ball_warp_q31(uint32_t u);

/*
 Density of `Ball` at a direction, in units of 2⁻³²: 2 cos³θ / π per steradian above the horizon, 0 elsewhere.
 */
uint32_t coslobe_ball_density_q31(struct coslobe_cos_sin_q31 at);

/*
 P(Θ ≤ `theta`) of `Ball` in units of 2⁻³², saturated; `theta` in units of 2⁻³² turns, from 0 to ¼ turn: 0 below
 and 2³² − 1 above.
 */
uint32_t coslobe_ball_cdf_q31(int32_t theta);

/*
 θ of `Ball` at cdf = `p`·2⁻³², in units of 2⁻³² turns.
 */
int32_t coslobe_ball_quantile_q31(uint32_t p);

/*
 Draws a direction [sin θ, cos θ] of `CircleArc`, uniform by arc length on a circle; components in units of 2⁻³¹.

 # Safety
 Each pointer is null, which is answered by its status, or valid.
 */
coslobe_status coslobe_circle_arc_sample_q31(const struct coslobe_rng *rng,
                                             int32_t (*direction)[2]);

/*
 (cos θ, sin θ) of `CircleArc` at cdf = `u`, in units of 2⁻³².
 */
struct coslobe_cos_sin_q31 coslobe_circle_arc_warp_q31(uint32_t u);

/*
 Density of `CircleArc` at a direction, in units of 2⁻³²: 1/π per radian above the horizon, 0 elsewhere.
 */
uint32_t coslobe_circle_arc_density_q31(struct coslobe_cos_sin_q31 at);

/*
 P(Θ ≤ `theta`) of `CircleArc` in units of 2⁻³², saturated; `theta` in units of 2⁻³² turns, from −¼ to ¼ turn: 0 below
 and 2³² − 1 above.
 */
uint32_t coslobe_circle_arc_cdf_q31(int32_t theta);

/*
 θ of `CircleArc` at cdf = `p`·2⁻³², in units of 2⁻³² turns.
 */
int32_t coslobe_circle_arc_quantile_q31(uint32_t p);

/*
 Draws a direction [sin θ, cos θ] of `CircleShell`, uniform by radial shell on a circle: the flat Lambert law; components in units of 2⁻³¹.

 # Safety
 Each pointer is null, which is answered by its status, or valid.
 */
coslobe_status coslobe_circle_shell_sample_q31(const struct coslobe_rng *rng,
                                               int32_t (*direction)[2]);

/*
 (cos θ, sin θ) of `CircleShell` at cdf = `u`, in units of 2⁻³².
 */
struct coslobe_cos_sin_q31 coslobe_circle_shell_warp_q31(uint32_t u);

/*
 Density of `CircleShell` at a direction, in units of 2⁻³²: cos θ / 2 per radian above the horizon, 0 elsewhere.
 */
uint32_t coslobe_circle_shell_density_q31(struct coslobe_cos_sin_q31 at);

/*
 P(Θ ≤ `theta`) of `CircleShell` in units of 2⁻³², saturated; `theta` in units of 2⁻³² turns, from −¼ to ¼ turn: 0 below
 and 2³² − 1 above.
 */
uint32_t coslobe_circle_shell_cdf_q31(int32_t theta);

/*
 θ of `CircleShell` at cdf = `p`·2⁻³², in units of 2⁻³² turns.
 */
int32_t coslobe_circle_shell_quantile_q31(uint32_t p);

/*
 Draws a direction [sin θ cos φ, cos θ, sin θ sin φ] of the law ∝ cosᵏθ, k = `exponent`·2⁻¹⁶; components in units of 2⁻³¹.

 # Safety
 Each pointer is null, which is answered by its status, or valid.
 */
coslobe_status coslobe_cos_power_sample_q31(uint32_t exponent,
                                            const struct coslobe_rng *rng,
                                            int32_t (*direction)[3]);

/*
 (cos θ, sin θ) of the law ∝ cosᵏθ, k = `exponent`·2⁻¹⁶ at cdf = `u`, in units of 2⁻³².
 */
struct coslobe_cos_sin_q31 coslobe_cos_power_warp_q31(uint32_t exponent,
                                                      uint32_t u);

/*
 Density of the law ∝ cosᵏθ, k = `exponent`·2⁻¹⁶ at a direction, in units of 2⁻¹⁶: (k+1) cosᵏθ / 2π per steradian above the horizon, 0 elsewhere.
 */
uint32_t coslobe_cos_power_density_q31(uint32_t exponent,
                                       struct coslobe_cos_sin_q31 at);

/*
 P(Θ ≤ `theta`) of the law ∝ cosᵏθ, k = `exponent`·2⁻¹⁶ in units of 2⁻³², saturated; `theta` in units of 2⁻³² turns, from 0 to ¼ turn: 0 below
 and 2³² − 1 above.
 */
uint32_t coslobe_cos_power_cdf_q31(uint32_t exponent,
                                   int32_t theta);

/*
 θ of the law ∝ cosᵏθ, k = `exponent`·2⁻¹⁶ at cdf = `p`·2⁻³², in units of 2⁻³² turns.
 */
int32_t coslobe_cos_power_quantile_q31(uint32_t exponent,
                                       uint32_t p);

/*
 Draws a direction [sin θ, cos θ] of `Disk`, uniform by area in a disk; components in units of 2⁻³¹.

 # Safety
 Each pointer is null, which is answered by its status, or valid.
 */
coslobe_status coslobe_disk_sample_q31(const struct coslobe_rng *rng,
                                       int32_t (*direction)[2]);

/*
 (cos θ, sin θ) of `Disk` at cdf = `u`, in units of 2⁻³².
 */
struct coslobe_cos_sin_q31 coslobe_disk_warp_q31(uint32_t u);

/*
 Density of `Disk` at a direction, in units of 2⁻³²: 2 cos²θ / π per radian above the horizon, 0 elsewhere.
 */
uint32_t coslobe_disk_density_q31(struct coslobe_cos_sin_q31 at);

/*
 P(Θ ≤ `theta`) of `Disk` in units of 2⁻³², saturated; `theta` in units of 2⁻³² turns, from −¼ to ¼ turn: 0 below
 and 2³² − 1 above.
 */
uint32_t coslobe_disk_cdf_q31(int32_t theta);

/*
 θ of `Disk` at cdf = `p`·2⁻³², in units of 2⁻³² turns.
 */
int32_t coslobe_disk_quantile_q31(uint32_t p);

/*
 Draws a direction [sin θ cos φ, cos θ, sin θ sin φ] of `Lambert`, uniform by area on a sphere; components in units of 2⁻³¹.

 # Safety
 Each pointer is null, which is answered by its status, or valid.
 */
coslobe_status coslobe_lambert_sample_q31(const struct coslobe_rng *rng,
                                          int32_t (*direction)[3]);

/*
 (cos θ, sin θ) of `Lambert` at cdf = `u`, in units of 2⁻³².
 */
struct coslobe_cos_sin_q31 coslobe_lambert_warp_q31(uint32_t u);

/*
 Density of `Lambert` at a direction, in units of 2⁻³²: cos θ / π per steradian above the horizon, 0 elsewhere.
 */
uint32_t coslobe_lambert_density_q31(struct coslobe_cos_sin_q31 at);

/*
 P(Θ ≤ `theta`) of `Lambert` in units of 2⁻³², saturated; `theta` in units of 2⁻³² turns, from 0 to ¼ turn: 0 below
 and 2³² − 1 above.
 */
uint32_t coslobe_lambert_cdf_q31(int32_t theta);

/*
 θ of `Lambert` at cdf = `p`·2⁻³², in units of 2⁻³² turns.
 */
int32_t coslobe_lambert_quantile_q31(uint32_t p);

/*
 Draws a direction [sin θ cos φ, cos θ, sin θ sin φ] of `SphereShell`, uniform by radial shell on a sphere; components in units of 2⁻³¹.

 # Safety
 Each pointer is null, which is answered by its status, or valid.
 */
coslobe_status coslobe_sphere_shell_sample_q31(const struct coslobe_rng *rng,
                                               int32_t (*direction)[3]);

/*
 (cos θ, sin θ) of `SphereShell` at cdf = `u`, in units of 2⁻³².
 */
struct coslobe_cos_sin_q31 coslobe_sphere_shell_warp_q31(uint32_t u);

/*
 Density of `SphereShell` at a direction, in units of 2⁻³²: 3 cos²θ / 2π per steradian above the horizon, 0 elsewhere.
 */
uint32_t coslobe_sphere_shell_density_q31(struct coslobe_cos_sin_q31 at);

/*
 P(Θ ≤ `theta`) of `SphereShell` in units of 2⁻³², saturated; `theta` in units of 2⁻³² turns, from 0 to ¼ turn: 0 below
 and 2³² − 1 above.
 */
uint32_t coslobe_sphere_shell_cdf_q31(int32_t theta);

/*
 θ of `SphereShell` at cdf = `p`·2⁻³², in units of 2⁻³² turns.
 */
int32_t coslobe_sphere_shell_quantile_q31(uint32_t p);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* COSLOBE_H */
