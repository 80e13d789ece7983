"""A rubber cantilever twisted past 270 degrees by forces that turn: five coordinates beside the full model."""
import tomllib
from pathlib import Path

import numpy as np
from plot_rubber import Motion, angles, inside_out, mass_product

from .row import Figure, Length, Row, finite, reported

CONFIG = Path(__file__).resolve().parents[2] / "config"


def prescribed(scene, t):
    """By how much the couple has turned, degrees: the first corner's two loads go with its cosine and its sine."""
    cosine, sine = (np.array(load["table"]) for load in scene["load"][:2])
    held = cosine[:, 1] ** 2 + sine[:, 1] ** 2 > 0
    return np.interp(t, cosine[held, 0], np.degrees(np.unwrap(np.arctan2(sine[held, 1], cosine[held, 1]))))


def twist(bench, length):
    text = (CONFIG / "rubber_twist.toml").read_text()
    scene = tomllib.loads(text)
    if length is Length.short:
        text = text.replace(f"end = {scene['time']['end']}", "end = 0.276")  # the full model is past 270 degrees
    bench.write("twist.toml", text)
    options = ["-options_file", CONFIG / "rubber_twist.opts", "-output"]
    bench.reduce(*options, "model.h5", "-quiet")
    bench.move("model.h5", "--scene", "twist.toml", "--every", "1", "--quiet")
    bench.full(*options, "full.h5", "-scene", "twist.toml", "-every", "1", "-quiet")
    reduced, full = Motion(bench.folder / "motion.h5"), Motion(bench.folder / "full.h5")
    product = mass_product(full)
    norm = lambda v: np.sqrt(np.vdot(v, product(v)))  # noqa: E731
    turned, load = (angles(full), angles(reduced)), prescribed(scene, full.times)
    figures = [finite("reduced", reduced.u), finite("full", full.u),
               Figure(f"at most: load {load.max():.0f}, full {turned[0].max():.0f}, "
                      f"reduced {turned[1].max():.0f} degrees", bool(turned[0].max() >= 270))]
    for angle in (90, 180, 270):
        for what, of in (("the full model", turned[0]), ("the load", load)):
            if of.max() < angle:
                figures.append(reported(f"{what} does not reach {angle} degrees"))
                continue
            i = int(np.argmax(of >= angle))
            error = norm(reduced.u[i] - full.u[i]) / norm(full.u[i])
            figures.append(reported(
                f"{what} at {angle} degrees, t = {full.times[i]:.3f} s: load {load[i]:.0f}, full {turned[0][i]:.0f}, "
                f"reduced {turned[1][i]:.0f} degrees; error {error:.1%} in the M-norm; cells inside out: "
                f"{inside_out(full, full.u[i])} full, {inside_out(reduced, reduced.u[i])} reduced"))
    most = [max(inside_out(m, u) for u in m.u[::5]) for m in (full, reduced)]
    return [*figures, reported(f"cells inside out at worst: {most[0]} full, {most[1]} reduced, of {len(full.cells)}")]


ROWS = [Row("twist", "270 degree twist with r = 5 (modes 4 and 9 and their derivatives)",
            "no NaN; error against the full model at 90, 180 and 270 degrees and the count of inverted cells printed",
            twist, seconds=45)]
