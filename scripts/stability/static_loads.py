"""Static answers of reduced models beside the full model's: what modes miss and residual vectors mend."""
import numpy as np

from bench import SOFT, statics
from .row import Row, at_most, reported

PLATE = ["-mesh", "box:.4,.3,.03/8,6,1/tet10", "-fix", "xmin", *SOFT, "-quiet"]
SMALL, LARGE = 1e-8, 5.  # N: of displacements without a rotation that counts, and of a sixth of the plate
DERIVATIVES = ["-modes", "8", "-derivatives", "8", "-basis", "36", "-polynomial"]
RESIDUAL = ["-residual_vectors", "ymax"]
BASES = {"8 modes": ["-modes", "8"], "40 modes": ["-modes", "40"], "8 modes, 36 columns with derivatives": DERIVATIVES,
         "8 modes and residual vectors": ["-modes", "8", *RESIDUAL],
         "8 modes, 36 columns with derivatives, residual vectors": [*DERIVATIVES, *RESIDUAL]}


def displacements(bench, name):
    ids, u = bench.read(name, "vertex_ids", "displacement")
    return u[-1][np.argsort(ids)].astype(float)


def answers(bench, length):
    """Of a load on one side, whose answer twists the plate and stretches it; u over all vertices."""
    scenes = {force: bench.write(f"{force}.toml", statics('set = "ymax"', f"total = [{force}, {force}, {-force}]", steps))
              for force, steps in ((SMALL, 1), (LARGE, 4))}
    full = {}
    for force, scene in scenes.items():
        bench.full(*PLATE, "-scene", scene)
        full[force] = displacements(bench, "full.h5")
    figures = [reported(f"{LARGE} N move the full model by {np.abs(full[LARGE]).max():.2g} m")]
    for what, words in BASES.items():
        bench.reduce(*PLATE, *words)
        for force, scene in scenes.items():
            if force == LARGE and "-polynomial" not in words:
                continue
            bench.move("model.h5", "--scene", scene, "--double-frames", "--quiet")
            off = np.linalg.norm(displacements(bench, "motion.h5") - full[force]) / np.linalg.norm(full[force])
            if force == SMALL and "-residual_vectors" in words:
                figures.append(at_most(f"{what}: a small load's answer off by", off, 1e-7))
            else:
                figures.append(reported(f"{what}: {'a small' if force == SMALL else 'a large'} load's off by {off:.2%}"))
    return figures


ROWS = [Row("static_answers", "a plate pulled askew on one side, statics, beside the full model",
            "with residual vectors a small load's answer to 1e-7; the others' errors are printed", answers, seconds=20)]
