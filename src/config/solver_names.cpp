// What is left out on purpose: types that call back into a program or an interpreter (shell, python), hypre's euclid
// and smoothers (a file of the current folder), MUMPS's folder of factors and its Fortran units, viewers that draw,
// connect or write binary files, and whatever asks for a search that ritz does not do.
#include "ritz/config/solver_options.hpp"

#include <array>

namespace ritz::config {
namespace {

constexpr std::string_view ksp =
    "modes_st_ksp_ modes_st_sub_ksp_ modes_st_mg_levels_ksp_ modes_st_mg_coarse_ksp_ solve_ksp_";
constexpr std::string_view pc =
    "modes_st_pc_ modes_st_sub_pc_ modes_st_mg_levels_pc_ modes_st_mg_coarse_pc_ modes_st_mg_coarse_sub_pc_ solve_pc_";
constexpr std::string_view mat = "modes_st_mat_ solve_mat_";
constexpr auto setting = SolverOption::setting, report = SolverOption::report, mark = SolverOption::mark;

constexpr std::array table = std::to_array<SolverNames>({
    {setting, "modes_eps_", "type",
     "krylovschur lanczos arnoldi subspace power gd jd rqcg lobpcg ciss lyapii lapack arpack scalapack"},
    {setting, "modes_eps_",
     "tol max_it ncv mpd nev target target_magnitude target_real target_imaginary largest_magnitude "
     "smallest_magnitude largest_real smallest_real largest_imaginary smallest_imaginary ritz harmonic "
     "harmonic_relative harmonic_right harmonic_largest refined refined_harmonic hermitian non_hermitian gen_hermitian "
     "gen_indefinite gen_non_hermitian pos_gen_non_hermitian true_residual two_sided purify balance balance_its "
     "balance_cutoff conv_abs conv_norm conv_rel stop_basic krylovschur_restart krylovschur_locking "
     "krylovschur_detect_zeros krylovschur_partitions lanczos_reorthog arnoldi_delayed gd_blocksize gd_borth "
     "gd_double_expansion gd_initial_size gd_krylov_start gd_minv gd_plusk jd_blocksize jd_borth "
     "jd_const_correction_tol jd_fix jd_initial_size jd_krylov_start jd_minv jd_plusk lobpcg_blocksize lobpcg_locking "
     "lobpcg_restart power_nonlinear power_shift_type power_update rqcg_reset"},
    {report, "modes_eps_",
     "view view_pre view_values view_vectors converged_reason error_absolute error_relative error_backward monitor "
     "monitor_all monitor_conv"},
    {setting, "modes_bv_", "type definite_tol matmult orthog_type orthog_refine orthog_eta orthog_block"},
    {setting, "modes_ds_", "method block_size parallel"},
    {setting, "modes_st_", "type", "sinvert shift cayley precond filter"},
    {setting, "modes_st_",
     "shift matmode matstructure transform cayley_antishift filter_degree filter_interval filter_range"},
    {report, "modes_st_", "view"},
    {setting, ksp, "type",
     "preonly none cg minres symmlq cr gmres fgmres lgmres pgmres dgmres gcr bcgs bcgsl fbcgs fbcgsr ibcgs qmrcgs cgs "
     "tfqmr tcqmr bicg cgne cgls lsqr richardson chebyshev fcg lcd tsirm groppcg pipecg pipecgrr pipecg2 pipelcg "
     "pipeprcg pipefcg pipebcgs pipecr pipegcr pipefgmres nash stcg gltr qcg"},
    {setting, ksp,
     "rtol atol divtol max_it norm_type pc_side lag_norm check_norm_iteration convergence_test converged_maxits "
     "converged_use_initial_residual_norm converged_use_min_initial_residual_norm constant_null_space diagonal_scale "
     "diagonal_scale_fix error_if_not_converged initial_guess_nonzero knoll guess_type fischer_guess "
     "reuse_preconditioner use_explicittranspose matsolve_batch_size cg_single_reduction gmres_restart gmres_haptol "
     "gmres_breakdown_tolerance gmres_classicalgramschmidt gmres_modifiedgramschmidt gmres_preallocate "
     "gmres_cgs_refinement_type fgmres_modifypcnochange fgmres_modifypcksp lgmres_augment lgmres_constant gcr_restart "
     "bcgsl_ell bcgsl_cxpoly bcgsl_pinv richardson_scale richardson_self_scale chebyshev_eigenvalues chebyshev_esteig "
     "chebyshev_esteig_steps"},
    {report, ksp,
     "view view_pre view_mat view_pmat view_rhs view_solution view_eigenvalues view_singularvalues view_final_residual "
     "converged_reason converged_rate monitor monitor_short monitor_true_residual monitor_max monitor_singular_value"},
    {setting, pc, "type",
     "cholesky lu icc ilu qr svd none jacobi pbjacobi vpbjacobi bjacobi sor eisenstat asm gasm redundant kaczmarz gamg "
     "mg hmg ml hypre tfs bddc lmvm deflation"},
    {setting, "multigrid_pc_", "type", "gamg"},
    {setting, pc,
     "use_amat factor_fill factor_levels factor_diagonal_fill factor_in_place factor_column_pivot "
     "factor_mat_ordering_type factor_nonzeros_along_diagonal factor_pivot_in_blocks factor_reuse_fill "
     "factor_reuse_ordering factor_shift_amount factor_shift_type factor_zeropivot jacobi_type jacobi_abs sor_omega "
     "sor_its sor_lits sor_symmetric sor_forward sor_backward sor_local_symmetric sor_local_forward sor_local_backward "
     "sor_diagonal_shift bjacobi_blocks bjacobi_local_blocks asm_blocks asm_local_blocks asm_overlap asm_type "
     "asm_local_type hypre_boomeramg_strong_threshold hypre_boomeramg_max_levels hypre_boomeramg_max_iter "
     "hypre_boomeramg_tol hypre_boomeramg_coarsen_type hypre_boomeramg_interp_type hypre_boomeramg_relax_type_all "
     "hypre_boomeramg_relax_weight_all hypre_boomeramg_grid_sweeps_all hypre_boomeramg_cycle_type "
     "hypre_boomeramg_agg_nl hypre_boomeramg_agg_num_paths hypre_boomeramg_p_max hypre_boomeramg_truncfactor "
     "hypre_boomeramg_nodal_coarsen hypre_boomeramg_numfunctions hypre_boomeramg_vec_interp_variant "
     "hypre_boomeramg_vec_interp_qmax hypre_boomeramg_no_cf"},
    {setting, pc, "factor_mat_solver_type",
     "mumps petsc superlu superlu_dist umfpack cholmod klu spqr strumpack pastix"},
    {setting, pc, "hypre_type", "boomeramg parasails pilut"},
    {setting, "modes_st_pc_ multigrid_pc_",
     "use_amat mg_levels gamg_type gamg_threshold gamg_threshold_scale gamg_agg_nsmooths gamg_aggressive_coarsening "
     "gamg_square_graph gamg_coarse_eq_limit gamg_process_eq_limit gamg_coarse_grid_layout_type "
     "gamg_rank_reduction_factors gamg_repartition gamg_reuse_interpolation gamg_asm_use_agg gamg_eigenvalues "
     "gamg_use_parallel_coarse_grid_solver gamg_use_sa_esteig"},
    {setting, "modes_st_mat_ multigrid_mat_", "coarsen_type coarsen_misk_distance"},
    {setting, mat,
     "mumps_icntl_4 mumps_icntl_6 mumps_icntl_7 mumps_icntl_8 mumps_icntl_10 mumps_icntl_11 mumps_icntl_12 "
     "mumps_icntl_13 mumps_icntl_14 mumps_icntl_15 mumps_icntl_19 mumps_icntl_20 mumps_icntl_22 mumps_icntl_23 "
     "mumps_icntl_24 mumps_icntl_25 mumps_icntl_26 mumps_icntl_27 mumps_icntl_28 mumps_icntl_29 mumps_icntl_31 "
     "mumps_icntl_33 mumps_icntl_35 mumps_icntl_36 mumps_icntl_38 mumps_cntl_1 mumps_cntl_2 mumps_cntl_3 mumps_cntl_4 "
     "mumps_cntl_5 mumps_cntl_7 superlu_dist_colperm superlu_dist_rowperm superlu_dist_r superlu_dist_c "
     "superlu_dist_equil superlu_dist_iterrefine superlu_dist_parsymbfact superlu_dist_replacetinypivot "
     "superlu_dist_statprint"},
    {setting, mat, "mumps_icntl_1 mumps_icntl_2 mumps_icntl_3", "0 6"},  // Fortran's units: none, stdout
    {setting, "newton_snes_", "type", "newtonls newtontr newtontrdc ksponly nrichardson ngmres qn ncg anderson"},
    {setting, "newton_snes_",
     "max_it max_funcs max_fail max_linear_solve_fail atol rtol stol divergence_tolerance force_iteration "
     "error_if_not_converged lag_jacobian lag_jacobian_persists lag_preconditioner lag_preconditioner_persists "
     "linesearch_order linesearch_damping linesearch_maxstep linesearch_minlambda linesearch_alpha linesearch_max_it "
     "linesearch_rtol linesearch_atol linesearch_ltol linesearch_norms linesearch_keeplambda ksp_ew ksp_ew_version "
     "ksp_ew_rtol0 ksp_ew_rtolmax ksp_ew_gamma ksp_ew_alpha ksp_ew_alpha2 ksp_ew_threshold tr_delta0 tr_delta1 "
     "tr_delta2 tr_delta3 tr_eta tr_mu tr_sigma trtol"},
    {setting, "newton_snes_", "linesearch_type", "basic none bt l2 cp nleqerr ncglinear"},
    {report, "newton_snes_", "view converged_reason monitor monitor_short linesearch_monitor"},
    {mark, "", "log_view_memory memory_view options_view citations"},
});

}  // namespace

std::span<const SolverNames> solver_names() { return table; }

}  // namespace ritz::config
