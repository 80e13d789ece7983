#include "read.hpp"

namespace ritz::scene {

std::string_view reference() {
  return R"(# A scene says what is done to a body. It is a TOML file in SI units; this one names every key.

gravity = [0.0, 0.0, -9.81]     # m/s2, on all of the mass; none if left out

[time]                          # a motion; or [static] below
step = 1e-3                     # s
end = 0.5                       # s: the steps go on to the first that reaches it
integrator = "newmark"          # one of:
                                #   exact               linear models alone, and their default
                                #   avf                 average vector field: keeps the energy; the default of all others
                                #   newmark             average acceleration, second order
                                #   generalized-alpha   second order, damps what the step does not resolve
                                #   linearly-implicit   the same for one evaluation a step where it can; its error is said
                                #   bdf2                second order, damps more
                                #   implicit-euler      first order, damps most
                                #   central-difference  explicit: the step has a limit, which is said
                                # ritz-full has avf (its default), newmark and implicit-euler

# [static]                      # equilibrium under loads that grow from nothing
# steps = 10                    # increments; constant loads and gravity are multiplied by 1/10, 2/10, ... 1

[damping]                       # D = alpha M + beta K, and ratios of modes added to it; none if left out
alpha = 0.5                     # 1/s
beta = 1e-4                     # s
ratio = [0.01, 0.02]            # one a flexible mode, the last one for all others; or a single number

[shake]                         # the ground moves, and the motion is relative to it; not in statics
direction = [1.0, 0.0, 0.0]     # multiplied by the table, not normalised
table = [[0.0, 0.0], [0.1, 3.0], [0.2, 0.0]]  # s, m/s2: straight lines between, the ends hold

[initial]                       # how the motion starts; if left out at rest, undeformed; not in statics
z = [0.01, 0.0]                 # sqrt(kg) m: each of the model's reduced coordinates. If left out, zeros
velocity = [0.0, 0.2]           # sqrt(kg) m/s: their velocities. If left out, zeros. Or, in place of both, one of
# static = true                 # at rest, in equilibrium under the loads as they are at t = 0
# motion = "motion.h5"          # a state of a motion of the same model; the path from this file's folder
# time = 0.25                   # s: which state of it; its last if left out
# model = "model.h5"            # in ritz-full alone: the reduced model of the motion, which then starts as u = U z

[[body]]                        # only where a scene has several: each load and probe then says body = "..."
name = "arm"                    # names files: motion.arm.h5
model = "model.h5"              # from this file's folder; if left out, the model on the command line
model_body = "body"             # which body of that file; if left out, its first
initial = { z = [0.02, 0.0] }   # keys as of [initial], which is of all bodies without one of their own

[[load]]                        # any number of them
body = "arm"                    # needed where there are several bodies
set = "xmax"                    # a named set; or vertex = 7, by the number in the mesh file
total = [0.0, 0.0, -5.0]        # N, shared equally by the vertices of the set; or one of
# each = [0.0, 0.0, -1.0]       # N, on every vertex
# pressure = 1000.0             # Pa, pushes into the body; on a set that has faces
# traction = [0.0, 0.0, -1e3]   # Pa, on a set that has faces
table = [[0.0, 0.0], [0.1, 1.0]]  # s (or the load fraction), factor; if left out, 1 (in statics the fraction)

[[probe]]                       # three columns in probes.csv, one an axis, for each of its quantities
name = "tip"
body = "arm"                    # as of loads
set = "xmax"                    # the mean over its vertices; or vertex = 7
quantity = ["displacement", "velocity"]  # NAME_ux (m), NAME_vx (m/s), NAME_ax of "acceleration" (m/s2), one or a list;
                                # displacement if left out. All relative to the ground where it shakes
)";
}

}  // namespace ritz::scene
