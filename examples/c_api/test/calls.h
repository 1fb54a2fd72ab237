/* made by tools/c_api.py, not by hand */
#ifdef WRAPPERS
static int cos_power_sample_f32(const coslobe_rng *rng, float direction[3])
{
    return coslobe_cos_power_sample_f32(&lobe_f32, rng, direction);
}
static int cos_power_sample_around_f32(const float normal[3], const coslobe_rng *rng, float direction[3])
{
    return coslobe_cos_power_sample_around_f32(&lobe_f32, normal, rng, direction);
}
static int cos_power_fill_f32(const coslobe_rng *rng, float *directions, size_t n, size_t *filled)
{
    return coslobe_cos_power_fill_f32(&lobe_f32, rng, directions, n, filled);
}
static int cos_power_warp_direction_f32(float p, float turn, float direction[3])
{
    return coslobe_cos_power_warp_direction_f32(&lobe_f32, p, turn, direction);
}
static int cos_power_self_test_f32(const coslobe_rng *rng, coslobe_fault *fault)
{
    return coslobe_cos_power_self_test_f32(&lobe_f32, rng, fault);
}
static float cos_power_pdf_f32(float theta)
{
    return coslobe_cos_power_pdf_f32(&lobe_f32, theta);
}
static float cos_power_ln_pdf_f32(float theta)
{
    return coslobe_cos_power_ln_pdf_f32(&lobe_f32, theta);
}
static float cos_power_pdf_solid_angle_f32(float theta)
{
    return coslobe_cos_power_pdf_solid_angle_f32(&lobe_f32, theta);
}
static float cos_power_cdf_f32(float theta)
{
    return coslobe_cos_power_cdf_f32(&lobe_f32, theta);
}
static float cos_power_sf_f32(float theta)
{
    return coslobe_cos_power_sf_f32(&lobe_f32, theta);
}
static float cos_power_quantile_f32(float p)
{
    return coslobe_cos_power_quantile_f32(&lobe_f32, p);
}
static float cos_power_isf_f32(float p)
{
    return coslobe_cos_power_isf_f32(&lobe_f32, p);
}
static coslobe_cos_sin_f32 cos_power_warp_f32(float p)
{
    return coslobe_cos_power_warp_f32(&lobe_f32, p);
}
static coslobe_cos_sin_f32 cos_power_warp_sf_f32(float p)
{
    return coslobe_cos_power_warp_sf_f32(&lobe_f32, p);
}
static float cos_power_unwarp_f32(coslobe_cos_sin_f32 at)
{
    return coslobe_cos_power_unwarp_f32(&lobe_f32, at);
}
static float cos_power_unwarp_sf_f32(coslobe_cos_sin_f32 at)
{
    return coslobe_cos_power_unwarp_sf_f32(&lobe_f32, at);
}
static float cos_power_density_f32(coslobe_cos_sin_f32 at)
{
    return coslobe_cos_power_density_f32(&lobe_f32, at);
}
static float cos_power_lambert_weight_f32(coslobe_cos_sin_f32 at)
{
    return coslobe_cos_power_lambert_weight_f32(&lobe_f32, at);
}
static int cos_power_sample_fast(const coslobe_rng *rng, float direction[3])
{
    return coslobe_cos_power_sample_fast(&lobe_fast, rng, direction);
}
static int cos_power_sample_around_fast(const float normal[3], const coslobe_rng *rng, float direction[3])
{
    return coslobe_cos_power_sample_around_fast(&lobe_fast, normal, rng, direction);
}
static int cos_power_fill_fast(const coslobe_rng *rng, float *directions, size_t n, size_t *filled)
{
    return coslobe_cos_power_fill_fast(&lobe_fast, rng, directions, n, filled);
}
static int cos_power_warp_direction_fast(float p, float turn, float direction[3])
{
    return coslobe_cos_power_warp_direction_fast(&lobe_fast, p, turn, direction);
}
static int cos_power_self_test_fast(const coslobe_rng *rng, coslobe_fault *fault)
{
    return coslobe_cos_power_self_test_fast(&lobe_fast, rng, fault);
}
static float cos_power_pdf_fast(float theta)
{
    return coslobe_cos_power_pdf_fast(&lobe_fast, theta);
}
static float cos_power_ln_pdf_fast(float theta)
{
    return coslobe_cos_power_ln_pdf_fast(&lobe_fast, theta);
}
static float cos_power_pdf_solid_angle_fast(float theta)
{
    return coslobe_cos_power_pdf_solid_angle_fast(&lobe_fast, theta);
}
static float cos_power_cdf_fast(float theta)
{
    return coslobe_cos_power_cdf_fast(&lobe_fast, theta);
}
static float cos_power_sf_fast(float theta)
{
    return coslobe_cos_power_sf_fast(&lobe_fast, theta);
}
static float cos_power_quantile_fast(float p)
{
    return coslobe_cos_power_quantile_fast(&lobe_fast, p);
}
static float cos_power_isf_fast(float p)
{
    return coslobe_cos_power_isf_fast(&lobe_fast, p);
}
static coslobe_cos_sin_f32 cos_power_warp_fast(float p)
{
    return coslobe_cos_power_warp_fast(&lobe_fast, p);
}
static coslobe_cos_sin_f32 cos_power_warp_sf_fast(float p)
{
    return coslobe_cos_power_warp_sf_fast(&lobe_fast, p);
}
static float cos_power_unwarp_fast(coslobe_cos_sin_f32 at)
{
    return coslobe_cos_power_unwarp_fast(&lobe_fast, at);
}
static float cos_power_unwarp_sf_fast(coslobe_cos_sin_f32 at)
{
    return coslobe_cos_power_unwarp_sf_fast(&lobe_fast, at);
}
static float cos_power_density_fast(coslobe_cos_sin_f32 at)
{
    return coslobe_cos_power_density_fast(&lobe_fast, at);
}
static float cos_power_lambert_weight_fast(coslobe_cos_sin_f32 at)
{
    return coslobe_cos_power_lambert_weight_fast(&lobe_fast, at);
}
static int cos_power_sample_q31(const coslobe_rng *rng, coslobe_q31 direction[3])
{
    return coslobe_cos_power_sample_q31(&lobe_q31, rng, direction);
}
static int cos_power_sample_around_q31(const coslobe_q31 normal[3], const coslobe_rng *rng, coslobe_q31 direction[3])
{
    return coslobe_cos_power_sample_around_q31(&lobe_q31, normal, rng, direction);
}
static int cos_power_fill_q31(const coslobe_rng *rng, coslobe_q31 *directions, size_t n, size_t *filled)
{
    return coslobe_cos_power_fill_q31(&lobe_q31, rng, directions, n, filled);
}
static int cos_power_warp_direction_q31(coslobe_probability_q32 p, coslobe_probability_q32 turn, coslobe_q31 direction[3])
{
    return coslobe_cos_power_warp_direction_q31(&lobe_q31, p, turn, direction);
}
static int cos_power_self_test_q31(const coslobe_rng *rng, coslobe_fault *fault)
{
    return coslobe_cos_power_self_test_q31(&lobe_q31, rng, fault);
}
static coslobe_density_q16_16 cos_power_pdf_q31(coslobe_turn_q32 theta)
{
    return coslobe_cos_power_pdf_q31(&lobe_q31, theta);
}
static coslobe_density_q16_16 cos_power_pdf_solid_angle_q31(coslobe_turn_q32 theta)
{
    return coslobe_cos_power_pdf_solid_angle_q31(&lobe_q31, theta);
}
static coslobe_probability_q32 cos_power_cdf_q31(coslobe_turn_q32 theta)
{
    return coslobe_cos_power_cdf_q31(&lobe_q31, theta);
}
static coslobe_probability_q32 cos_power_sf_q31(coslobe_turn_q32 theta)
{
    return coslobe_cos_power_sf_q31(&lobe_q31, theta);
}
static coslobe_turn_q32 cos_power_quantile_q31(coslobe_probability_q32 p)
{
    return coslobe_cos_power_quantile_q31(&lobe_q31, p);
}
static coslobe_turn_q32 cos_power_isf_q31(coslobe_probability_q32 p)
{
    return coslobe_cos_power_isf_q31(&lobe_q31, p);
}
static coslobe_cos_sin_q31 cos_power_warp_q31(coslobe_probability_q32 p)
{
    return coslobe_cos_power_warp_q31(&lobe_q31, p);
}
static coslobe_cos_sin_q31 cos_power_warp_sf_q31(coslobe_probability_q32 p)
{
    return coslobe_cos_power_warp_sf_q31(&lobe_q31, p);
}
static coslobe_probability_q32 cos_power_unwarp_q31(coslobe_cos_sin_q31 at)
{
    return coslobe_cos_power_unwarp_q31(&lobe_q31, at);
}
static coslobe_probability_q32 cos_power_unwarp_sf_q31(coslobe_cos_sin_q31 at)
{
    return coslobe_cos_power_unwarp_sf_q31(&lobe_q31, at);
}
static coslobe_density_q16_16 cos_power_density_q31(coslobe_cos_sin_q31 at)
{
    return coslobe_cos_power_density_q31(&lobe_q31, at);
}
#else
CALL(sample2_f32, coslobe_disk_sample_f32, "coslobe_disk_sample_f32")
CALL(fill2_f32, coslobe_disk_fill_f32, "coslobe_disk_fill_f32")
CALL(point2_f32, coslobe_disk_point_f32, "coslobe_disk_point_f32")
CALL(self_test, coslobe_disk_self_test_f32, "coslobe_disk_self_test_f32")
CALL(density_of_angle_f32, coslobe_disk_pdf_f32, "coslobe_disk_pdf_f32")
CALL(density_of_angle_f32, coslobe_disk_ln_pdf_f32, "coslobe_disk_ln_pdf_f32")
CALL(probability_of_angle_f32, coslobe_disk_cdf_f32, "coslobe_disk_cdf_f32")
CALL(probability_of_angle_f32, coslobe_disk_sf_f32, "coslobe_disk_sf_f32")
CALL(angle_of_probability_f32, coslobe_disk_quantile_f32, "coslobe_disk_quantile_f32")
CALL(angle_of_probability_f32, coslobe_disk_isf_f32, "coslobe_disk_isf_f32")
CALL(pair_of_probability_f32, coslobe_disk_warp_f32, "coslobe_disk_warp_f32")
CALL(pair_of_probability_f32, coslobe_disk_warp_sf_f32, "coslobe_disk_warp_sf_f32")
CALL(probability_of_pair_f32, coslobe_disk_unwarp_f32, "coslobe_disk_unwarp_f32")
CALL(probability_of_pair_f32, coslobe_disk_unwarp_sf_f32, "coslobe_disk_unwarp_sf_f32")
CALL(density_of_pair_f32, coslobe_disk_density_f32, "coslobe_disk_density_f32")
CALL(weight_of_pair_f32, coslobe_disk_lambert_weight_f32, "coslobe_disk_lambert_weight_f32")
CALL(sample2_f32, coslobe_circle_shell_sample_f32, "coslobe_circle_shell_sample_f32")
CALL(fill2_f32, coslobe_circle_shell_fill_f32, "coslobe_circle_shell_fill_f32")
CALL(point2_f32, coslobe_circle_shell_point_f32, "coslobe_circle_shell_point_f32")
CALL(self_test, coslobe_circle_shell_self_test_f32, "coslobe_circle_shell_self_test_f32")
CALL(density_of_angle_f32, coslobe_circle_shell_pdf_f32, "coslobe_circle_shell_pdf_f32")
CALL(density_of_angle_f32, coslobe_circle_shell_ln_pdf_f32, "coslobe_circle_shell_ln_pdf_f32")
CALL(probability_of_angle_f32, coslobe_circle_shell_cdf_f32, "coslobe_circle_shell_cdf_f32")
CALL(probability_of_angle_f32, coslobe_circle_shell_sf_f32, "coslobe_circle_shell_sf_f32")
CALL(angle_of_probability_f32, coslobe_circle_shell_quantile_f32, "coslobe_circle_shell_quantile_f32")
CALL(angle_of_probability_f32, coslobe_circle_shell_isf_f32, "coslobe_circle_shell_isf_f32")
CALL(pair_of_probability_f32, coslobe_circle_shell_warp_f32, "coslobe_circle_shell_warp_f32")
CALL(pair_of_probability_f32, coslobe_circle_shell_warp_sf_f32, "coslobe_circle_shell_warp_sf_f32")
CALL(probability_of_pair_f32, coslobe_circle_shell_unwarp_f32, "coslobe_circle_shell_unwarp_f32")
CALL(probability_of_pair_f32, coslobe_circle_shell_unwarp_sf_f32, "coslobe_circle_shell_unwarp_sf_f32")
CALL(density_of_pair_f32, coslobe_circle_shell_density_f32, "coslobe_circle_shell_density_f32")
CALL(weight_of_pair_f32, coslobe_circle_shell_lambert_weight_f32, "coslobe_circle_shell_lambert_weight_f32")
CALL(sample2_f32, coslobe_circle_arc_sample_f32, "coslobe_circle_arc_sample_f32")
CALL(fill2_f32, coslobe_circle_arc_fill_f32, "coslobe_circle_arc_fill_f32")
CALL(point2_f32, coslobe_circle_arc_point_f32, "coslobe_circle_arc_point_f32")
CALL(self_test, coslobe_circle_arc_self_test_f32, "coslobe_circle_arc_self_test_f32")
CALL(density_of_angle_f32, coslobe_circle_arc_pdf_f32, "coslobe_circle_arc_pdf_f32")
CALL(density_of_angle_f32, coslobe_circle_arc_ln_pdf_f32, "coslobe_circle_arc_ln_pdf_f32")
CALL(probability_of_angle_f32, coslobe_circle_arc_cdf_f32, "coslobe_circle_arc_cdf_f32")
CALL(probability_of_angle_f32, coslobe_circle_arc_sf_f32, "coslobe_circle_arc_sf_f32")
CALL(angle_of_probability_f32, coslobe_circle_arc_quantile_f32, "coslobe_circle_arc_quantile_f32")
CALL(angle_of_probability_f32, coslobe_circle_arc_isf_f32, "coslobe_circle_arc_isf_f32")
CALL(pair_of_probability_f32, coslobe_circle_arc_warp_f32, "coslobe_circle_arc_warp_f32")
CALL(pair_of_probability_f32, coslobe_circle_arc_warp_sf_f32, "coslobe_circle_arc_warp_sf_f32")
CALL(probability_of_pair_f32, coslobe_circle_arc_unwarp_f32, "coslobe_circle_arc_unwarp_f32")
CALL(probability_of_pair_f32, coslobe_circle_arc_unwarp_sf_f32, "coslobe_circle_arc_unwarp_sf_f32")
CALL(density_of_pair_f32, coslobe_circle_arc_density_f32, "coslobe_circle_arc_density_f32")
CALL(weight_of_pair_f32, coslobe_circle_arc_lambert_weight_f32, "coslobe_circle_arc_lambert_weight_f32")
CALL(sample3_f32, coslobe_ball_sample_f32, "coslobe_ball_sample_f32")
CALL(sample_around3_f32, coslobe_ball_sample_around_f32, "coslobe_ball_sample_around_f32")
CALL(fill3_f32, coslobe_ball_fill_f32, "coslobe_ball_fill_f32")
CALL(warp_direction3_f32, coslobe_ball_warp_direction_f32, "coslobe_ball_warp_direction_f32")
CALL(point3_f32, coslobe_ball_point_f32, "coslobe_ball_point_f32")
CALL(self_test, coslobe_ball_self_test_f32, "coslobe_ball_self_test_f32")
CALL(density_of_angle_f32, coslobe_ball_pdf_f32, "coslobe_ball_pdf_f32")
CALL(density_of_angle_f32, coslobe_ball_ln_pdf_f32, "coslobe_ball_ln_pdf_f32")
CALL(density_of_angle_f32, coslobe_ball_pdf_solid_angle_f32, "coslobe_ball_pdf_solid_angle_f32")
CALL(probability_of_angle_f32, coslobe_ball_cdf_f32, "coslobe_ball_cdf_f32")
CALL(probability_of_angle_f32, coslobe_ball_sf_f32, "coslobe_ball_sf_f32")
CALL(angle_of_probability_f32, coslobe_ball_quantile_f32, "coslobe_ball_quantile_f32")
CALL(angle_of_probability_f32, coslobe_ball_isf_f32, "coslobe_ball_isf_f32")
CALL(pair_of_probability_f32, coslobe_ball_warp_f32, "coslobe_ball_warp_f32")
CALL(pair_of_probability_f32, coslobe_ball_warp_sf_f32, "coslobe_ball_warp_sf_f32")
CALL(probability_of_pair_f32, coslobe_ball_unwarp_f32, "coslobe_ball_unwarp_f32")
CALL(probability_of_pair_f32, coslobe_ball_unwarp_sf_f32, "coslobe_ball_unwarp_sf_f32")
CALL(density_of_pair_f32, coslobe_ball_density_f32, "coslobe_ball_density_f32")
CALL(weight_of_pair_f32, coslobe_ball_lambert_weight_f32, "coslobe_ball_lambert_weight_f32")
CALL(sample3_f32, coslobe_sphere_shell_sample_f32, "coslobe_sphere_shell_sample_f32")
CALL(sample_around3_f32, coslobe_sphere_shell_sample_around_f32, "coslobe_sphere_shell_sample_around_f32")
CALL(fill3_f32, coslobe_sphere_shell_fill_f32, "coslobe_sphere_shell_fill_f32")
CALL(warp_direction3_f32, coslobe_sphere_shell_warp_direction_f32, "coslobe_sphere_shell_warp_direction_f32")
CALL(point3_f32, coslobe_sphere_shell_point_f32, "coslobe_sphere_shell_point_f32")
CALL(self_test, coslobe_sphere_shell_self_test_f32, "coslobe_sphere_shell_self_test_f32")
CALL(density_of_angle_f32, coslobe_sphere_shell_pdf_f32, "coslobe_sphere_shell_pdf_f32")
CALL(density_of_angle_f32, coslobe_sphere_shell_ln_pdf_f32, "coslobe_sphere_shell_ln_pdf_f32")
CALL(density_of_angle_f32, coslobe_sphere_shell_pdf_solid_angle_f32, "coslobe_sphere_shell_pdf_solid_angle_f32")
CALL(probability_of_angle_f32, coslobe_sphere_shell_cdf_f32, "coslobe_sphere_shell_cdf_f32")
CALL(probability_of_angle_f32, coslobe_sphere_shell_sf_f32, "coslobe_sphere_shell_sf_f32")
CALL(angle_of_probability_f32, coslobe_sphere_shell_quantile_f32, "coslobe_sphere_shell_quantile_f32")
CALL(angle_of_probability_f32, coslobe_sphere_shell_isf_f32, "coslobe_sphere_shell_isf_f32")
CALL(pair_of_probability_f32, coslobe_sphere_shell_warp_f32, "coslobe_sphere_shell_warp_f32")
CALL(pair_of_probability_f32, coslobe_sphere_shell_warp_sf_f32, "coslobe_sphere_shell_warp_sf_f32")
CALL(probability_of_pair_f32, coslobe_sphere_shell_unwarp_f32, "coslobe_sphere_shell_unwarp_f32")
CALL(probability_of_pair_f32, coslobe_sphere_shell_unwarp_sf_f32, "coslobe_sphere_shell_unwarp_sf_f32")
CALL(density_of_pair_f32, coslobe_sphere_shell_density_f32, "coslobe_sphere_shell_density_f32")
CALL(weight_of_pair_f32, coslobe_sphere_shell_lambert_weight_f32, "coslobe_sphere_shell_lambert_weight_f32")
CALL(sample3_f32, coslobe_lambert_sample_f32, "coslobe_lambert_sample_f32")
CALL(sample_around3_f32, coslobe_lambert_sample_around_f32, "coslobe_lambert_sample_around_f32")
CALL(fill3_f32, coslobe_lambert_fill_f32, "coslobe_lambert_fill_f32")
CALL(warp_direction3_f32, coslobe_lambert_warp_direction_f32, "coslobe_lambert_warp_direction_f32")
CALL(point3_f32, coslobe_lambert_point_f32, "coslobe_lambert_point_f32")
CALL(self_test, coslobe_lambert_self_test_f32, "coslobe_lambert_self_test_f32")
CALL(density_of_angle_f32, coslobe_lambert_pdf_f32, "coslobe_lambert_pdf_f32")
CALL(density_of_angle_f32, coslobe_lambert_ln_pdf_f32, "coslobe_lambert_ln_pdf_f32")
CALL(density_of_angle_f32, coslobe_lambert_pdf_solid_angle_f32, "coslobe_lambert_pdf_solid_angle_f32")
CALL(probability_of_angle_f32, coslobe_lambert_cdf_f32, "coslobe_lambert_cdf_f32")
CALL(probability_of_angle_f32, coslobe_lambert_sf_f32, "coslobe_lambert_sf_f32")
CALL(angle_of_probability_f32, coslobe_lambert_quantile_f32, "coslobe_lambert_quantile_f32")
CALL(angle_of_probability_f32, coslobe_lambert_isf_f32, "coslobe_lambert_isf_f32")
CALL(pair_of_probability_f32, coslobe_lambert_warp_f32, "coslobe_lambert_warp_f32")
CALL(pair_of_probability_f32, coslobe_lambert_warp_sf_f32, "coslobe_lambert_warp_sf_f32")
CALL(probability_of_pair_f32, coslobe_lambert_unwarp_f32, "coslobe_lambert_unwarp_f32")
CALL(probability_of_pair_f32, coslobe_lambert_unwarp_sf_f32, "coslobe_lambert_unwarp_sf_f32")
CALL(density_of_pair_f32, coslobe_lambert_density_f32, "coslobe_lambert_density_f32")
CALL(weight_of_pair_f32, coslobe_lambert_lambert_weight_f32, "coslobe_lambert_lambert_weight_f32")
CALL(sample3_f32, cos_power_sample_f32, "coslobe_cos_power_sample_f32")
CALL(sample_around3_f32, cos_power_sample_around_f32, "coslobe_cos_power_sample_around_f32")
CALL(fill3_f32, cos_power_fill_f32, "coslobe_cos_power_fill_f32")
CALL(warp_direction3_f32, cos_power_warp_direction_f32, "coslobe_cos_power_warp_direction_f32")
CALL(self_test, cos_power_self_test_f32, "coslobe_cos_power_self_test_f32")
CALL(density_of_angle_f32, cos_power_pdf_f32, "coslobe_cos_power_pdf_f32")
CALL(density_of_angle_f32, cos_power_ln_pdf_f32, "coslobe_cos_power_ln_pdf_f32")
CALL(density_of_angle_f32, cos_power_pdf_solid_angle_f32, "coslobe_cos_power_pdf_solid_angle_f32")
CALL(probability_of_angle_f32, cos_power_cdf_f32, "coslobe_cos_power_cdf_f32")
CALL(probability_of_angle_f32, cos_power_sf_f32, "coslobe_cos_power_sf_f32")
CALL(angle_of_probability_f32, cos_power_quantile_f32, "coslobe_cos_power_quantile_f32")
CALL(angle_of_probability_f32, cos_power_isf_f32, "coslobe_cos_power_isf_f32")
CALL(pair_of_probability_f32, cos_power_warp_f32, "coslobe_cos_power_warp_f32")
CALL(pair_of_probability_f32, cos_power_warp_sf_f32, "coslobe_cos_power_warp_sf_f32")
CALL(probability_of_pair_f32, cos_power_unwarp_f32, "coslobe_cos_power_unwarp_f32")
CALL(probability_of_pair_f32, cos_power_unwarp_sf_f32, "coslobe_cos_power_unwarp_sf_f32")
CALL(density_of_pair_f32, cos_power_density_f32, "coslobe_cos_power_density_f32")
CALL(weight_of_pair_f32, cos_power_lambert_weight_f32, "coslobe_cos_power_lambert_weight_f32")
CALL(sample2_f32, coslobe_disk_sample_fast, "coslobe_disk_sample_fast")
CALL(fill2_f32, coslobe_disk_fill_fast, "coslobe_disk_fill_fast")
CALL(point2_f32, coslobe_disk_point_fast, "coslobe_disk_point_fast")
CALL(self_test, coslobe_disk_self_test_fast, "coslobe_disk_self_test_fast")
CALL(density_of_angle_f32, coslobe_disk_pdf_fast, "coslobe_disk_pdf_fast")
CALL(density_of_angle_f32, coslobe_disk_ln_pdf_fast, "coslobe_disk_ln_pdf_fast")
CALL(probability_of_angle_f32, coslobe_disk_cdf_fast, "coslobe_disk_cdf_fast")
CALL(probability_of_angle_f32, coslobe_disk_sf_fast, "coslobe_disk_sf_fast")
CALL(angle_of_probability_f32, coslobe_disk_quantile_fast, "coslobe_disk_quantile_fast")
CALL(angle_of_probability_f32, coslobe_disk_isf_fast, "coslobe_disk_isf_fast")
CALL(pair_of_probability_f32, coslobe_disk_warp_fast, "coslobe_disk_warp_fast")
CALL(pair_of_probability_f32, coslobe_disk_warp_sf_fast, "coslobe_disk_warp_sf_fast")
CALL(probability_of_pair_f32, coslobe_disk_unwarp_fast, "coslobe_disk_unwarp_fast")
CALL(probability_of_pair_f32, coslobe_disk_unwarp_sf_fast, "coslobe_disk_unwarp_sf_fast")
CALL(density_of_pair_f32, coslobe_disk_density_fast, "coslobe_disk_density_fast")
CALL(weight_of_pair_f32, coslobe_disk_lambert_weight_fast, "coslobe_disk_lambert_weight_fast")
CALL(sample2_f32, coslobe_circle_shell_sample_fast, "coslobe_circle_shell_sample_fast")
CALL(fill2_f32, coslobe_circle_shell_fill_fast, "coslobe_circle_shell_fill_fast")
CALL(point2_f32, coslobe_circle_shell_point_fast, "coslobe_circle_shell_point_fast")
CALL(self_test, coslobe_circle_shell_self_test_fast, "coslobe_circle_shell_self_test_fast")
CALL(density_of_angle_f32, coslobe_circle_shell_pdf_fast, "coslobe_circle_shell_pdf_fast")
CALL(density_of_angle_f32, coslobe_circle_shell_ln_pdf_fast, "coslobe_circle_shell_ln_pdf_fast")
CALL(probability_of_angle_f32, coslobe_circle_shell_cdf_fast, "coslobe_circle_shell_cdf_fast")
CALL(probability_of_angle_f32, coslobe_circle_shell_sf_fast, "coslobe_circle_shell_sf_fast")
CALL(angle_of_probability_f32, coslobe_circle_shell_quantile_fast, "coslobe_circle_shell_quantile_fast")
CALL(angle_of_probability_f32, coslobe_circle_shell_isf_fast, "coslobe_circle_shell_isf_fast")
CALL(pair_of_probability_f32, coslobe_circle_shell_warp_fast, "coslobe_circle_shell_warp_fast")
CALL(pair_of_probability_f32, coslobe_circle_shell_warp_sf_fast, "coslobe_circle_shell_warp_sf_fast")
CALL(probability_of_pair_f32, coslobe_circle_shell_unwarp_fast, "coslobe_circle_shell_unwarp_fast")
CALL(probability_of_pair_f32, coslobe_circle_shell_unwarp_sf_fast, "coslobe_circle_shell_unwarp_sf_fast")
CALL(density_of_pair_f32, coslobe_circle_shell_density_fast, "coslobe_circle_shell_density_fast")
CALL(weight_of_pair_f32, coslobe_circle_shell_lambert_weight_fast, "coslobe_circle_shell_lambert_weight_fast")
CALL(sample2_f32, coslobe_circle_arc_sample_fast, "coslobe_circle_arc_sample_fast")
CALL(fill2_f32, coslobe_circle_arc_fill_fast, "coslobe_circle_arc_fill_fast")
CALL(point2_f32, coslobe_circle_arc_point_fast, "coslobe_circle_arc_point_fast")
CALL(self_test, coslobe_circle_arc_self_test_fast, "coslobe_circle_arc_self_test_fast")
CALL(density_of_angle_f32, coslobe_circle_arc_pdf_fast, "coslobe_circle_arc_pdf_fast")
CALL(density_of_angle_f32, coslobe_circle_arc_ln_pdf_fast, "coslobe_circle_arc_ln_pdf_fast")
CALL(probability_of_angle_f32, coslobe_circle_arc_cdf_fast, "coslobe_circle_arc_cdf_fast")
CALL(probability_of_angle_f32, coslobe_circle_arc_sf_fast, "coslobe_circle_arc_sf_fast")
CALL(angle_of_probability_f32, coslobe_circle_arc_quantile_fast, "coslobe_circle_arc_quantile_fast")
CALL(angle_of_probability_f32, coslobe_circle_arc_isf_fast, "coslobe_circle_arc_isf_fast")
CALL(pair_of_probability_f32, coslobe_circle_arc_warp_fast, "coslobe_circle_arc_warp_fast")
CALL(pair_of_probability_f32, coslobe_circle_arc_warp_sf_fast, "coslobe_circle_arc_warp_sf_fast")
CALL(probability_of_pair_f32, coslobe_circle_arc_unwarp_fast, "coslobe_circle_arc_unwarp_fast")
CALL(probability_of_pair_f32, coslobe_circle_arc_unwarp_sf_fast, "coslobe_circle_arc_unwarp_sf_fast")
CALL(density_of_pair_f32, coslobe_circle_arc_density_fast, "coslobe_circle_arc_density_fast")
CALL(weight_of_pair_f32, coslobe_circle_arc_lambert_weight_fast, "coslobe_circle_arc_lambert_weight_fast")
CALL(sample3_f32, coslobe_ball_sample_fast, "coslobe_ball_sample_fast")
CALL(sample_around3_f32, coslobe_ball_sample_around_fast, "coslobe_ball_sample_around_fast")
CALL(fill3_f32, coslobe_ball_fill_fast, "coslobe_ball_fill_fast")
CALL(warp_direction3_f32, coslobe_ball_warp_direction_fast, "coslobe_ball_warp_direction_fast")
CALL(point3_f32, coslobe_ball_point_fast, "coslobe_ball_point_fast")
CALL(self_test, coslobe_ball_self_test_fast, "coslobe_ball_self_test_fast")
CALL(density_of_angle_f32, coslobe_ball_pdf_fast, "coslobe_ball_pdf_fast")
CALL(density_of_angle_f32, coslobe_ball_ln_pdf_fast, "coslobe_ball_ln_pdf_fast")
CALL(density_of_angle_f32, coslobe_ball_pdf_solid_angle_fast, "coslobe_ball_pdf_solid_angle_fast")
CALL(probability_of_angle_f32, coslobe_ball_cdf_fast, "coslobe_ball_cdf_fast")
CALL(probability_of_angle_f32, coslobe_ball_sf_fast, "coslobe_ball_sf_fast")
CALL(angle_of_probability_f32, coslobe_ball_quantile_fast, "coslobe_ball_quantile_fast")
CALL(angle_of_probability_f32, coslobe_ball_isf_fast, "coslobe_ball_isf_fast")
CALL(pair_of_probability_f32, coslobe_ball_warp_fast, "coslobe_ball_warp_fast")
CALL(pair_of_probability_f32, coslobe_ball_warp_sf_fast, "coslobe_ball_warp_sf_fast")
CALL(probability_of_pair_f32, coslobe_ball_unwarp_fast, "coslobe_ball_unwarp_fast")
CALL(probability_of_pair_f32, coslobe_ball_unwarp_sf_fast, "coslobe_ball_unwarp_sf_fast")
CALL(density_of_pair_f32, coslobe_ball_density_fast, "coslobe_ball_density_fast")
CALL(weight_of_pair_f32, coslobe_ball_lambert_weight_fast, "coslobe_ball_lambert_weight_fast")
CALL(sample3_f32, coslobe_sphere_shell_sample_fast, "coslobe_sphere_shell_sample_fast")
CALL(sample_around3_f32, coslobe_sphere_shell_sample_around_fast, "coslobe_sphere_shell_sample_around_fast")
CALL(fill3_f32, coslobe_sphere_shell_fill_fast, "coslobe_sphere_shell_fill_fast")
CALL(warp_direction3_f32, coslobe_sphere_shell_warp_direction_fast, "coslobe_sphere_shell_warp_direction_fast")
CALL(point3_f32, coslobe_sphere_shell_point_fast, "coslobe_sphere_shell_point_fast")
CALL(self_test, coslobe_sphere_shell_self_test_fast, "coslobe_sphere_shell_self_test_fast")
CALL(density_of_angle_f32, coslobe_sphere_shell_pdf_fast, "coslobe_sphere_shell_pdf_fast")
CALL(density_of_angle_f32, coslobe_sphere_shell_ln_pdf_fast, "coslobe_sphere_shell_ln_pdf_fast")
CALL(density_of_angle_f32, coslobe_sphere_shell_pdf_solid_angle_fast, "coslobe_sphere_shell_pdf_solid_angle_fast")
CALL(probability_of_angle_f32, coslobe_sphere_shell_cdf_fast, "coslobe_sphere_shell_cdf_fast")
CALL(probability_of_angle_f32, coslobe_sphere_shell_sf_fast, "coslobe_sphere_shell_sf_fast")
CALL(angle_of_probability_f32, coslobe_sphere_shell_quantile_fast, "coslobe_sphere_shell_quantile_fast")
CALL(angle_of_probability_f32, coslobe_sphere_shell_isf_fast, "coslobe_sphere_shell_isf_fast")
CALL(pair_of_probability_f32, coslobe_sphere_shell_warp_fast, "coslobe_sphere_shell_warp_fast")
CALL(pair_of_probability_f32, coslobe_sphere_shell_warp_sf_fast, "coslobe_sphere_shell_warp_sf_fast")
CALL(probability_of_pair_f32, coslobe_sphere_shell_unwarp_fast, "coslobe_sphere_shell_unwarp_fast")
CALL(probability_of_pair_f32, coslobe_sphere_shell_unwarp_sf_fast, "coslobe_sphere_shell_unwarp_sf_fast")
CALL(density_of_pair_f32, coslobe_sphere_shell_density_fast, "coslobe_sphere_shell_density_fast")
CALL(weight_of_pair_f32, coslobe_sphere_shell_lambert_weight_fast, "coslobe_sphere_shell_lambert_weight_fast")
CALL(sample3_f32, coslobe_lambert_sample_fast, "coslobe_lambert_sample_fast")
CALL(sample_around3_f32, coslobe_lambert_sample_around_fast, "coslobe_lambert_sample_around_fast")
CALL(fill3_f32, coslobe_lambert_fill_fast, "coslobe_lambert_fill_fast")
CALL(warp_direction3_f32, coslobe_lambert_warp_direction_fast, "coslobe_lambert_warp_direction_fast")
CALL(point3_f32, coslobe_lambert_point_fast, "coslobe_lambert_point_fast")
CALL(self_test, coslobe_lambert_self_test_fast, "coslobe_lambert_self_test_fast")
CALL(density_of_angle_f32, coslobe_lambert_pdf_fast, "coslobe_lambert_pdf_fast")
CALL(density_of_angle_f32, coslobe_lambert_ln_pdf_fast, "coslobe_lambert_ln_pdf_fast")
CALL(density_of_angle_f32, coslobe_lambert_pdf_solid_angle_fast, "coslobe_lambert_pdf_solid_angle_fast")
CALL(probability_of_angle_f32, coslobe_lambert_cdf_fast, "coslobe_lambert_cdf_fast")
CALL(probability_of_angle_f32, coslobe_lambert_sf_fast, "coslobe_lambert_sf_fast")
CALL(angle_of_probability_f32, coslobe_lambert_quantile_fast, "coslobe_lambert_quantile_fast")
CALL(angle_of_probability_f32, coslobe_lambert_isf_fast, "coslobe_lambert_isf_fast")
CALL(pair_of_probability_f32, coslobe_lambert_warp_fast, "coslobe_lambert_warp_fast")
CALL(pair_of_probability_f32, coslobe_lambert_warp_sf_fast, "coslobe_lambert_warp_sf_fast")
CALL(probability_of_pair_f32, coslobe_lambert_unwarp_fast, "coslobe_lambert_unwarp_fast")
CALL(probability_of_pair_f32, coslobe_lambert_unwarp_sf_fast, "coslobe_lambert_unwarp_sf_fast")
CALL(density_of_pair_f32, coslobe_lambert_density_fast, "coslobe_lambert_density_fast")
CALL(weight_of_pair_f32, coslobe_lambert_lambert_weight_fast, "coslobe_lambert_lambert_weight_fast")
CALL(sample3_f32, cos_power_sample_fast, "coslobe_cos_power_sample_fast")
CALL(sample_around3_f32, cos_power_sample_around_fast, "coslobe_cos_power_sample_around_fast")
CALL(fill3_f32, cos_power_fill_fast, "coslobe_cos_power_fill_fast")
CALL(warp_direction3_f32, cos_power_warp_direction_fast, "coslobe_cos_power_warp_direction_fast")
CALL(self_test, cos_power_self_test_fast, "coslobe_cos_power_self_test_fast")
CALL(density_of_angle_f32, cos_power_pdf_fast, "coslobe_cos_power_pdf_fast")
CALL(density_of_angle_f32, cos_power_ln_pdf_fast, "coslobe_cos_power_ln_pdf_fast")
CALL(density_of_angle_f32, cos_power_pdf_solid_angle_fast, "coslobe_cos_power_pdf_solid_angle_fast")
CALL(probability_of_angle_f32, cos_power_cdf_fast, "coslobe_cos_power_cdf_fast")
CALL(probability_of_angle_f32, cos_power_sf_fast, "coslobe_cos_power_sf_fast")
CALL(angle_of_probability_f32, cos_power_quantile_fast, "coslobe_cos_power_quantile_fast")
CALL(angle_of_probability_f32, cos_power_isf_fast, "coslobe_cos_power_isf_fast")
CALL(pair_of_probability_f32, cos_power_warp_fast, "coslobe_cos_power_warp_fast")
CALL(pair_of_probability_f32, cos_power_warp_sf_fast, "coslobe_cos_power_warp_sf_fast")
CALL(probability_of_pair_f32, cos_power_unwarp_fast, "coslobe_cos_power_unwarp_fast")
CALL(probability_of_pair_f32, cos_power_unwarp_sf_fast, "coslobe_cos_power_unwarp_sf_fast")
CALL(density_of_pair_f32, cos_power_density_fast, "coslobe_cos_power_density_fast")
CALL(weight_of_pair_f32, cos_power_lambert_weight_fast, "coslobe_cos_power_lambert_weight_fast")
CALL(sample2_q31, coslobe_disk_sample_q31, "coslobe_disk_sample_q31")
CALL(fill2_q31, coslobe_disk_fill_q31, "coslobe_disk_fill_q31")
CALL(self_test, coslobe_disk_self_test_q31, "coslobe_disk_self_test_q31")
CALL(density_of_angle_q31, coslobe_disk_pdf_q31, "coslobe_disk_pdf_q31")
CALL(probability_of_angle_q31, coslobe_disk_cdf_q31, "coslobe_disk_cdf_q31")
CALL(probability_of_angle_q31, coslobe_disk_sf_q31, "coslobe_disk_sf_q31")
CALL(angle_of_probability_q31, coslobe_disk_quantile_q31, "coslobe_disk_quantile_q31")
CALL(angle_of_probability_q31, coslobe_disk_isf_q31, "coslobe_disk_isf_q31")
CALL(pair_of_probability_q31, coslobe_disk_warp_q31, "coslobe_disk_warp_q31")
CALL(pair_of_probability_q31, coslobe_disk_warp_sf_q31, "coslobe_disk_warp_sf_q31")
CALL(probability_of_pair_q31, coslobe_disk_unwarp_q31, "coslobe_disk_unwarp_q31")
CALL(probability_of_pair_q31, coslobe_disk_unwarp_sf_q31, "coslobe_disk_unwarp_sf_q31")
CALL(density_of_pair_q31, coslobe_disk_density_q31, "coslobe_disk_density_q31")
CALL(sample2_q31, coslobe_circle_shell_sample_q31, "coslobe_circle_shell_sample_q31")
CALL(fill2_q31, coslobe_circle_shell_fill_q31, "coslobe_circle_shell_fill_q31")
CALL(self_test, coslobe_circle_shell_self_test_q31, "coslobe_circle_shell_self_test_q31")
CALL(density_of_angle_q31, coslobe_circle_shell_pdf_q31, "coslobe_circle_shell_pdf_q31")
CALL(probability_of_angle_q31, coslobe_circle_shell_cdf_q31, "coslobe_circle_shell_cdf_q31")
CALL(probability_of_angle_q31, coslobe_circle_shell_sf_q31, "coslobe_circle_shell_sf_q31")
CALL(angle_of_probability_q31, coslobe_circle_shell_quantile_q31, "coslobe_circle_shell_quantile_q31")
CALL(angle_of_probability_q31, coslobe_circle_shell_isf_q31, "coslobe_circle_shell_isf_q31")
CALL(pair_of_probability_q31, coslobe_circle_shell_warp_q31, "coslobe_circle_shell_warp_q31")
CALL(pair_of_probability_q31, coslobe_circle_shell_warp_sf_q31, "coslobe_circle_shell_warp_sf_q31")
CALL(probability_of_pair_q31, coslobe_circle_shell_unwarp_q31, "coslobe_circle_shell_unwarp_q31")
CALL(probability_of_pair_q31, coslobe_circle_shell_unwarp_sf_q31, "coslobe_circle_shell_unwarp_sf_q31")
CALL(density_of_pair_q31, coslobe_circle_shell_density_q31, "coslobe_circle_shell_density_q31")
CALL(sample2_q31, coslobe_circle_arc_sample_q31, "coslobe_circle_arc_sample_q31")
CALL(fill2_q31, coslobe_circle_arc_fill_q31, "coslobe_circle_arc_fill_q31")
CALL(self_test, coslobe_circle_arc_self_test_q31, "coslobe_circle_arc_self_test_q31")
CALL(density_of_angle_q31, coslobe_circle_arc_pdf_q31, "coslobe_circle_arc_pdf_q31")
CALL(probability_of_angle_q31, coslobe_circle_arc_cdf_q31, "coslobe_circle_arc_cdf_q31")
CALL(probability_of_angle_q31, coslobe_circle_arc_sf_q31, "coslobe_circle_arc_sf_q31")
CALL(angle_of_probability_q31, coslobe_circle_arc_quantile_q31, "coslobe_circle_arc_quantile_q31")
CALL(angle_of_probability_q31, coslobe_circle_arc_isf_q31, "coslobe_circle_arc_isf_q31")
CALL(pair_of_probability_q31, coslobe_circle_arc_warp_q31, "coslobe_circle_arc_warp_q31")
CALL(pair_of_probability_q31, coslobe_circle_arc_warp_sf_q31, "coslobe_circle_arc_warp_sf_q31")
CALL(probability_of_pair_q31, coslobe_circle_arc_unwarp_q31, "coslobe_circle_arc_unwarp_q31")
CALL(probability_of_pair_q31, coslobe_circle_arc_unwarp_sf_q31, "coslobe_circle_arc_unwarp_sf_q31")
CALL(density_of_pair_q31, coslobe_circle_arc_density_q31, "coslobe_circle_arc_density_q31")
CALL(sample3_q31, coslobe_ball_sample_q31, "coslobe_ball_sample_q31")
CALL(sample_around3_q31, coslobe_ball_sample_around_q31, "coslobe_ball_sample_around_q31")
CALL(fill3_q31, coslobe_ball_fill_q31, "coslobe_ball_fill_q31")
CALL(warp_direction3_q31, coslobe_ball_warp_direction_q31, "coslobe_ball_warp_direction_q31")
CALL(self_test, coslobe_ball_self_test_q31, "coslobe_ball_self_test_q31")
CALL(density_of_angle_q31, coslobe_ball_pdf_q31, "coslobe_ball_pdf_q31")
CALL(density_of_angle_q31, coslobe_ball_pdf_solid_angle_q31, "coslobe_ball_pdf_solid_angle_q31")
CALL(probability_of_angle_q31, coslobe_ball_cdf_q31, "coslobe_ball_cdf_q31")
CALL(probability_of_angle_q31, coslobe_ball_sf_q31, "coslobe_ball_sf_q31")
CALL(angle_of_probability_q31, coslobe_ball_quantile_q31, "coslobe_ball_quantile_q31")
CALL(angle_of_probability_q31, coslobe_ball_isf_q31, "coslobe_ball_isf_q31")
CALL(pair_of_probability_q31, coslobe_ball_warp_q31, "coslobe_ball_warp_q31")
CALL(pair_of_probability_q31, coslobe_ball_warp_sf_q31, "coslobe_ball_warp_sf_q31")
CALL(probability_of_pair_q31, coslobe_ball_unwarp_q31, "coslobe_ball_unwarp_q31")
CALL(probability_of_pair_q31, coslobe_ball_unwarp_sf_q31, "coslobe_ball_unwarp_sf_q31")
CALL(density_of_pair_q31, coslobe_ball_density_q31, "coslobe_ball_density_q31")
CALL(sample3_q31, coslobe_sphere_shell_sample_q31, "coslobe_sphere_shell_sample_q31")
CALL(sample_around3_q31, coslobe_sphere_shell_sample_around_q31, "coslobe_sphere_shell_sample_around_q31")
CALL(fill3_q31, coslobe_sphere_shell_fill_q31, "coslobe_sphere_shell_fill_q31")
CALL(warp_direction3_q31, coslobe_sphere_shell_warp_direction_q31, "coslobe_sphere_shell_warp_direction_q31")
CALL(self_test, coslobe_sphere_shell_self_test_q31, "coslobe_sphere_shell_self_test_q31")
CALL(density_of_angle_q31, coslobe_sphere_shell_pdf_q31, "coslobe_sphere_shell_pdf_q31")
CALL(density_of_angle_q31, coslobe_sphere_shell_pdf_solid_angle_q31, "coslobe_sphere_shell_pdf_solid_angle_q31")
CALL(probability_of_angle_q31, coslobe_sphere_shell_cdf_q31, "coslobe_sphere_shell_cdf_q31")
CALL(probability_of_angle_q31, coslobe_sphere_shell_sf_q31, "coslobe_sphere_shell_sf_q31")
CALL(angle_of_probability_q31, coslobe_sphere_shell_quantile_q31, "coslobe_sphere_shell_quantile_q31")
CALL(angle_of_probability_q31, coslobe_sphere_shell_isf_q31, "coslobe_sphere_shell_isf_q31")
CALL(pair_of_probability_q31, coslobe_sphere_shell_warp_q31, "coslobe_sphere_shell_warp_q31")
CALL(pair_of_probability_q31, coslobe_sphere_shell_warp_sf_q31, "coslobe_sphere_shell_warp_sf_q31")
CALL(probability_of_pair_q31, coslobe_sphere_shell_unwarp_q31, "coslobe_sphere_shell_unwarp_q31")
CALL(probability_of_pair_q31, coslobe_sphere_shell_unwarp_sf_q31, "coslobe_sphere_shell_unwarp_sf_q31")
CALL(density_of_pair_q31, coslobe_sphere_shell_density_q31, "coslobe_sphere_shell_density_q31")
CALL(sample3_q31, coslobe_lambert_sample_q31, "coslobe_lambert_sample_q31")
CALL(sample_around3_q31, coslobe_lambert_sample_around_q31, "coslobe_lambert_sample_around_q31")
CALL(fill3_q31, coslobe_lambert_fill_q31, "coslobe_lambert_fill_q31")
CALL(warp_direction3_q31, coslobe_lambert_warp_direction_q31, "coslobe_lambert_warp_direction_q31")
CALL(self_test, coslobe_lambert_self_test_q31, "coslobe_lambert_self_test_q31")
CALL(density_of_angle_q31, coslobe_lambert_pdf_q31, "coslobe_lambert_pdf_q31")
CALL(density_of_angle_q31, coslobe_lambert_pdf_solid_angle_q31, "coslobe_lambert_pdf_solid_angle_q31")
CALL(probability_of_angle_q31, coslobe_lambert_cdf_q31, "coslobe_lambert_cdf_q31")
CALL(probability_of_angle_q31, coslobe_lambert_sf_q31, "coslobe_lambert_sf_q31")
CALL(angle_of_probability_q31, coslobe_lambert_quantile_q31, "coslobe_lambert_quantile_q31")
CALL(angle_of_probability_q31, coslobe_lambert_isf_q31, "coslobe_lambert_isf_q31")
CALL(pair_of_probability_q31, coslobe_lambert_warp_q31, "coslobe_lambert_warp_q31")
CALL(pair_of_probability_q31, coslobe_lambert_warp_sf_q31, "coslobe_lambert_warp_sf_q31")
CALL(probability_of_pair_q31, coslobe_lambert_unwarp_q31, "coslobe_lambert_unwarp_q31")
CALL(probability_of_pair_q31, coslobe_lambert_unwarp_sf_q31, "coslobe_lambert_unwarp_sf_q31")
CALL(density_of_pair_q31, coslobe_lambert_density_q31, "coslobe_lambert_density_q31")
CALL(sample3_q31, cos_power_sample_q31, "coslobe_cos_power_sample_q31")
CALL(sample_around3_q31, cos_power_sample_around_q31, "coslobe_cos_power_sample_around_q31")
CALL(fill3_q31, cos_power_fill_q31, "coslobe_cos_power_fill_q31")
CALL(warp_direction3_q31, cos_power_warp_direction_q31, "coslobe_cos_power_warp_direction_q31")
CALL(self_test, cos_power_self_test_q31, "coslobe_cos_power_self_test_q31")
CALL(density_of_angle_q31, cos_power_pdf_q31, "coslobe_cos_power_pdf_q31")
CALL(density_of_angle_q31, cos_power_pdf_solid_angle_q31, "coslobe_cos_power_pdf_solid_angle_q31")
CALL(probability_of_angle_q31, cos_power_cdf_q31, "coslobe_cos_power_cdf_q31")
CALL(probability_of_angle_q31, cos_power_sf_q31, "coslobe_cos_power_sf_q31")
CALL(angle_of_probability_q31, cos_power_quantile_q31, "coslobe_cos_power_quantile_q31")
CALL(angle_of_probability_q31, cos_power_isf_q31, "coslobe_cos_power_isf_q31")
CALL(pair_of_probability_q31, cos_power_warp_q31, "coslobe_cos_power_warp_q31")
CALL(pair_of_probability_q31, cos_power_warp_sf_q31, "coslobe_cos_power_warp_sf_q31")
CALL(probability_of_pair_q31, cos_power_unwarp_q31, "coslobe_cos_power_unwarp_q31")
CALL(probability_of_pair_q31, cos_power_unwarp_sf_q31, "coslobe_cos_power_unwarp_sf_q31")
CALL(density_of_pair_q31, cos_power_density_q31, "coslobe_cos_power_density_q31")
CALL(sample2_q15, coslobe_disk_sample_q15, "coslobe_disk_sample_q15")
CALL(fill2_q15, coslobe_disk_fill_q15, "coslobe_disk_fill_q15")
CALL(self_test, coslobe_disk_self_test_q15, "coslobe_disk_self_test_q15")
CALL(density_of_angle_q15, coslobe_disk_pdf_q15, "coslobe_disk_pdf_q15")
CALL(probability_of_angle_q15, coslobe_disk_cdf_q15, "coslobe_disk_cdf_q15")
CALL(probability_of_angle_q15, coslobe_disk_sf_q15, "coslobe_disk_sf_q15")
CALL(angle_of_probability_q15, coslobe_disk_quantile_q15, "coslobe_disk_quantile_q15")
CALL(angle_of_probability_q15, coslobe_disk_isf_q15, "coslobe_disk_isf_q15")
CALL(pair_of_probability_q15, coslobe_disk_warp_q15, "coslobe_disk_warp_q15")
CALL(pair_of_probability_q15, coslobe_disk_warp_sf_q15, "coslobe_disk_warp_sf_q15")
CALL(probability_of_pair_q15, coslobe_disk_unwarp_q15, "coslobe_disk_unwarp_q15")
CALL(probability_of_pair_q15, coslobe_disk_unwarp_sf_q15, "coslobe_disk_unwarp_sf_q15")
CALL(density_of_pair_q15, coslobe_disk_density_q15, "coslobe_disk_density_q15")
CALL(sample2_q15, coslobe_circle_shell_sample_q15, "coslobe_circle_shell_sample_q15")
CALL(fill2_q15, coslobe_circle_shell_fill_q15, "coslobe_circle_shell_fill_q15")
CALL(self_test, coslobe_circle_shell_self_test_q15, "coslobe_circle_shell_self_test_q15")
CALL(density_of_angle_q15, coslobe_circle_shell_pdf_q15, "coslobe_circle_shell_pdf_q15")
CALL(probability_of_angle_q15, coslobe_circle_shell_cdf_q15, "coslobe_circle_shell_cdf_q15")
CALL(probability_of_angle_q15, coslobe_circle_shell_sf_q15, "coslobe_circle_shell_sf_q15")
CALL(angle_of_probability_q15, coslobe_circle_shell_quantile_q15, "coslobe_circle_shell_quantile_q15")
CALL(angle_of_probability_q15, coslobe_circle_shell_isf_q15, "coslobe_circle_shell_isf_q15")
CALL(pair_of_probability_q15, coslobe_circle_shell_warp_q15, "coslobe_circle_shell_warp_q15")
CALL(pair_of_probability_q15, coslobe_circle_shell_warp_sf_q15, "coslobe_circle_shell_warp_sf_q15")
CALL(probability_of_pair_q15, coslobe_circle_shell_unwarp_q15, "coslobe_circle_shell_unwarp_q15")
CALL(probability_of_pair_q15, coslobe_circle_shell_unwarp_sf_q15, "coslobe_circle_shell_unwarp_sf_q15")
CALL(density_of_pair_q15, coslobe_circle_shell_density_q15, "coslobe_circle_shell_density_q15")
CALL(sample2_q15, coslobe_circle_arc_sample_q15, "coslobe_circle_arc_sample_q15")
CALL(fill2_q15, coslobe_circle_arc_fill_q15, "coslobe_circle_arc_fill_q15")
CALL(self_test, coslobe_circle_arc_self_test_q15, "coslobe_circle_arc_self_test_q15")
CALL(density_of_angle_q15, coslobe_circle_arc_pdf_q15, "coslobe_circle_arc_pdf_q15")
CALL(probability_of_angle_q15, coslobe_circle_arc_cdf_q15, "coslobe_circle_arc_cdf_q15")
CALL(probability_of_angle_q15, coslobe_circle_arc_sf_q15, "coslobe_circle_arc_sf_q15")
CALL(angle_of_probability_q15, coslobe_circle_arc_quantile_q15, "coslobe_circle_arc_quantile_q15")
CALL(angle_of_probability_q15, coslobe_circle_arc_isf_q15, "coslobe_circle_arc_isf_q15")
CALL(pair_of_probability_q15, coslobe_circle_arc_warp_q15, "coslobe_circle_arc_warp_q15")
CALL(pair_of_probability_q15, coslobe_circle_arc_warp_sf_q15, "coslobe_circle_arc_warp_sf_q15")
CALL(probability_of_pair_q15, coslobe_circle_arc_unwarp_q15, "coslobe_circle_arc_unwarp_q15")
CALL(probability_of_pair_q15, coslobe_circle_arc_unwarp_sf_q15, "coslobe_circle_arc_unwarp_sf_q15")
CALL(density_of_pair_q15, coslobe_circle_arc_density_q15, "coslobe_circle_arc_density_q15")
CALL(sample3_q15, coslobe_ball_sample_q15, "coslobe_ball_sample_q15")
CALL(sample_around3_q15, coslobe_ball_sample_around_q15, "coslobe_ball_sample_around_q15")
CALL(fill3_q15, coslobe_ball_fill_q15, "coslobe_ball_fill_q15")
CALL(warp_direction3_q15, coslobe_ball_warp_direction_q15, "coslobe_ball_warp_direction_q15")
CALL(self_test, coslobe_ball_self_test_q15, "coslobe_ball_self_test_q15")
CALL(density_of_angle_q15, coslobe_ball_pdf_q15, "coslobe_ball_pdf_q15")
CALL(density_of_angle_q15, coslobe_ball_pdf_solid_angle_q15, "coslobe_ball_pdf_solid_angle_q15")
CALL(probability_of_angle_q15, coslobe_ball_cdf_q15, "coslobe_ball_cdf_q15")
CALL(probability_of_angle_q15, coslobe_ball_sf_q15, "coslobe_ball_sf_q15")
CALL(angle_of_probability_q15, coslobe_ball_quantile_q15, "coslobe_ball_quantile_q15")
CALL(angle_of_probability_q15, coslobe_ball_isf_q15, "coslobe_ball_isf_q15")
CALL(pair_of_probability_q15, coslobe_ball_warp_q15, "coslobe_ball_warp_q15")
CALL(pair_of_probability_q15, coslobe_ball_warp_sf_q15, "coslobe_ball_warp_sf_q15")
CALL(probability_of_pair_q15, coslobe_ball_unwarp_q15, "coslobe_ball_unwarp_q15")
CALL(probability_of_pair_q15, coslobe_ball_unwarp_sf_q15, "coslobe_ball_unwarp_sf_q15")
CALL(density_of_pair_q15, coslobe_ball_density_q15, "coslobe_ball_density_q15")
CALL(sample3_q15, coslobe_sphere_shell_sample_q15, "coslobe_sphere_shell_sample_q15")
CALL(sample_around3_q15, coslobe_sphere_shell_sample_around_q15, "coslobe_sphere_shell_sample_around_q15")
CALL(fill3_q15, coslobe_sphere_shell_fill_q15, "coslobe_sphere_shell_fill_q15")
CALL(warp_direction3_q15, coslobe_sphere_shell_warp_direction_q15, "coslobe_sphere_shell_warp_direction_q15")
CALL(self_test, coslobe_sphere_shell_self_test_q15, "coslobe_sphere_shell_self_test_q15")
CALL(density_of_angle_q15, coslobe_sphere_shell_pdf_q15, "coslobe_sphere_shell_pdf_q15")
CALL(density_of_angle_q15, coslobe_sphere_shell_pdf_solid_angle_q15, "coslobe_sphere_shell_pdf_solid_angle_q15")
CALL(probability_of_angle_q15, coslobe_sphere_shell_cdf_q15, "coslobe_sphere_shell_cdf_q15")
CALL(probability_of_angle_q15, coslobe_sphere_shell_sf_q15, "coslobe_sphere_shell_sf_q15")
CALL(angle_of_probability_q15, coslobe_sphere_shell_quantile_q15, "coslobe_sphere_shell_quantile_q15")
CALL(angle_of_probability_q15, coslobe_sphere_shell_isf_q15, "coslobe_sphere_shell_isf_q15")
CALL(pair_of_probability_q15, coslobe_sphere_shell_warp_q15, "coslobe_sphere_shell_warp_q15")
CALL(pair_of_probability_q15, coslobe_sphere_shell_warp_sf_q15, "coslobe_sphere_shell_warp_sf_q15")
CALL(probability_of_pair_q15, coslobe_sphere_shell_unwarp_q15, "coslobe_sphere_shell_unwarp_q15")
CALL(probability_of_pair_q15, coslobe_sphere_shell_unwarp_sf_q15, "coslobe_sphere_shell_unwarp_sf_q15")
CALL(density_of_pair_q15, coslobe_sphere_shell_density_q15, "coslobe_sphere_shell_density_q15")
CALL(sample3_q15, coslobe_lambert_sample_q15, "coslobe_lambert_sample_q15")
CALL(sample_around3_q15, coslobe_lambert_sample_around_q15, "coslobe_lambert_sample_around_q15")
CALL(fill3_q15, coslobe_lambert_fill_q15, "coslobe_lambert_fill_q15")
CALL(warp_direction3_q15, coslobe_lambert_warp_direction_q15, "coslobe_lambert_warp_direction_q15")
CALL(self_test, coslobe_lambert_self_test_q15, "coslobe_lambert_self_test_q15")
CALL(density_of_angle_q15, coslobe_lambert_pdf_q15, "coslobe_lambert_pdf_q15")
CALL(density_of_angle_q15, coslobe_lambert_pdf_solid_angle_q15, "coslobe_lambert_pdf_solid_angle_q15")
CALL(probability_of_angle_q15, coslobe_lambert_cdf_q15, "coslobe_lambert_cdf_q15")
CALL(probability_of_angle_q15, coslobe_lambert_sf_q15, "coslobe_lambert_sf_q15")
CALL(angle_of_probability_q15, coslobe_lambert_quantile_q15, "coslobe_lambert_quantile_q15")
CALL(angle_of_probability_q15, coslobe_lambert_isf_q15, "coslobe_lambert_isf_q15")
CALL(pair_of_probability_q15, coslobe_lambert_warp_q15, "coslobe_lambert_warp_q15")
CALL(pair_of_probability_q15, coslobe_lambert_warp_sf_q15, "coslobe_lambert_warp_sf_q15")
CALL(probability_of_pair_q15, coslobe_lambert_unwarp_q15, "coslobe_lambert_unwarp_q15")
CALL(probability_of_pair_q15, coslobe_lambert_unwarp_sf_q15, "coslobe_lambert_unwarp_sf_q15")
CALL(density_of_pair_q15, coslobe_lambert_density_q15, "coslobe_lambert_density_q15")
#endif
