"""index.html and the PNGs, from runs.csv, over_time.csv and lean.csv alone."""
import html
import io
import math
import re

import matplotlib.pyplot as plt

from report import compare, diagram, errors, lean, pictures, table
from report.methods import METHODS

STYLE = """body{font:15px/1.5 sans-serif;max-width:1150px;margin:2em auto;padding:0 1em;color:#222}
table{border-collapse:collapse;margin:1em 0;font-size:12px}.wide{overflow-x:auto}
td,th{border-bottom:1px solid #ddd;padding:.25em .5em;text-align:right;vertical-align:top}
td:first-child,th:first-child{text-align:left}th{background:#f5f5f5}svg{max-width:100%;height:auto}
dt{font-weight:bold}dd{margin:0 0 .5em 1.5em}caption{text-align:left;font-weight:bold;padding:.5em 0}"""

INTRODUCTION = """Every error is against the full model on the same mesh at a refined step. Times are of stepping alone:
medians and quartiles of rounds in which all runs take turns, one BLAS thread; reduced models run on one core, the full
model and the precomputation on as many ranks as stands beside the scene. The full model moves once more in all: each
round times one part of its motion, from where the last one stopped, and its steps but the first, which analyses the
matrix besides, stand for the others; its quartiles are over these parts. Compare times at equal error only: the time to reach 1 %. Break-even steps are
those after which a reduced model's precomputation is paid back, against the full model at the same step, of models at
most 5 % off."""


def cell(text):
    return html.escape(str(text))


def number(value, unit=""):
    return "–" if math.isnan(value) else f"{value:,.3g}{unit}".replace(",", " ")


def rows_table(caption, heads, lines):
    body = "".join("<tr>" + "".join(f"<td>{cell(x)}</td>" for x in line) + "</tr>\n" for line in lines)
    return (f"<div class=\"wide\"><table>{caption and f'<caption>{cell(caption)}</caption>'}\n<tr>" +
            "".join(f"<th>{cell(head)}</th>" for head in heads) + f"</tr>\n{body}</table></div>\n")


def svg(name, figure):
    """The element alone, without metadata that names other places; the same figure gives the same text."""
    out = io.StringIO()
    with plt.rc_context({"svg.hashsalt": name}):
        figure.savefig(out, format="svg", metadata={"Date": None})
    text = out.getvalue()
    return re.sub("<metadata>.*?</metadata>", "", text[text.index("<svg"):], flags=re.DOTALL)


def picture(folder, name, figure):
    figure.savefig(folder / f"{name}.png", dpi=110)
    text = svg(name, figure)
    plt.close(figure)
    return text


def reach_table(rows):
    lines = []
    for method in METHODS:
        of_method = [row for row in rows if row["method"] == method.name]
        row = compare.to_reach(of_method, 0.01)
        if row:
            lines.append((method.title, diagram.knobs(row), row["integrator"], row["precision"], number(row["step"]),
                          compare.told(row), number(row["seconds"], " s"), number(row["microseconds"]),
                          number(row["microseconds_p99"]), number(row["precompute_seconds"], " s"),
                          number(compare.break_even(row, rows))))
        elif of_method:
            lines.append((method.title, "", "", "", "", compare.time_to(of_method, 0.01), "", "", "", "", ""))
    return rows_table("Time to reach an error of 1 %", ("method", "knobs", "integrator", "precision", "step", "error",
                      "time of stepping", "µs a step", "p99", "precomputation", "break-even steps"), lines)


def summary_table(rows):
    heads, lines = compare.reach(rows, diagram.TITLES, 0.01)
    return rows_table("", heads, lines)


def cost_tables(rows):
    """What each size of a method costs and gains, at one step: the motion, and the making of its model."""
    chosen = [row for row in compare.done(rows) if row["sweep"] == "basis"]
    name = lambda row: (diagram.TITLES[row["method"]], diagram.knobs(row))  # noqa: E731
    motions = [(*name(row), compare.told(row), compare.percent(row["error_max"]), compare.percent(row["error_frequency"]),
                number(row["error_force"]), number(row["energy_balance"]),
                f"{number(row['microseconds'])} ({number(row['microseconds_q1'])} … {number(row['microseconds_q3'])})",
                number(row["microseconds_p99"]), number(row["iterations"]), number(row["rejected"]),
                number(row["run_memory"] / 1e6)) for row in chosen]
    models = [(*name(row), number(row["columns"]), number(row["precompute_seconds"], " s"), row["precompute_stages"],
               number(row["precompute_memory"] / 1e6), number(row["file_bytes"] / 1e6),
               number(compare.break_even(row, rows))) for row in chosen if row["method"] != "full"]
    return rows_table(f"Motions at a step of {diagram.step(chosen[0])}" if chosen else "Motions",
                      ("method", "knobs", "error", "largest", "frequency", "force", "energy", "µs a step (quartiles)", "p99",
                       "iterations", "rejected", "memory, MB"), motions) + \
        rows_table("What their models cost", ("method", "knobs", "columns", "precomputation", "its stages, s",
                                              "its memory, MB", "file, MB", "break-even steps"), models)


def omissions(rows):
    lines = [(row["scene"], diagram.TITLES[row["method"]], diagram.knobs(row), row["integrator"], row["precision"],
              number(row["step"]), row["reason"]) for row in compare.failed(rows)]
    lines += [(scene, method.title, "", "", "", "", "not planned: it is for other laws, or the scene's row of scenes.py leaves it out, for time")
              for scene in compare.scenes(rows) for method in METHODS
              if not any((row["scene"], row["method"]) == (scene, method.name) for row in rows)]
    if not lines:
        return "<p>No run failed, and none was left out.</p>"
    heads = ("scene", "method", "knobs", "integrator", "precision", "step", "reason")
    return rows_table("", heads, lines)


FORMS = {"quick": "the quick form: fewer and smaller scenes and sizes, timed in three rounds; not for figures that are quoted",
         "full": "the full form"}


def origin(rows):
    """What was run, where and when, in a sentence; what the rows do not say is left out."""
    values = lambda name: sorted({row[name] for row in rows if row.get(name)})  # noqa: E731
    forms = " and ".join(FORMS.get(form, form) for form in values("form"))
    dates = values("date")
    when = "" if not dates else dates[0] if len(dates) == 1 else f"{dates[0]} to {dates[-1]}"
    parts = (f"This is {forms}." if forms else "", f"Measured {when} on {'; '.join(values('machine'))}." if when else "",
             f"{'; '.join(values('versions'))}; build {', '.join(values('program'))}." if rows else "")
    return " ".join(filter(None, parts))


def scene_part(folder, rows, frames):
    name, first = rows[0]["scene"], rows[0]
    text = (f"<p>{first['vertices']:.0f} vertices, {first['cells']:.0f} cells, "
            f"{first['dofs']:.0f} degrees of freedom; ritz-reduce and ritz-full on {first['ranks']:.0f} rank(s). "
            f"Reference: the full model, {'AVF, step' if first['analysis'] == 'time' else 'load step'} "
            f"{number(first['reference_step'])}; its floor {compare.percent(first['floor'])}. "
            f"The mesh's part of the error: {compare.percent(first['error_mesh'])} "
            f"(against {cell(first['mesh_compared'] or 'another')} mesh).</p>\n")
    if not compare.done(rows):
        return text + "<p>No run was finished.</p>"
    keys = {row["key"] for row in rows}
    here = [frame for frame in frames if frame["key"] in keys]
    return text + "\n".join((
        picture(folder, f"{name}_work_precision", pictures.work_precision(rows)), reach_table(rows),
        picture(folder, f"{name}_over_time", pictures.over_time(rows, here)),
        picture(folder, f"{name}_break_even", pictures.break_even(rows)),
        picture(folder, f"{name}_parts", pictures.parts(rows)), cost_tables(rows)))


def by_load(folder, rows):
    """The picture over the load, where scenes of one family were run with several factors."""
    if len({row["load_factor"] for row in rows}) < 2:
        return ""
    family = next(row["scene"] for row in rows if row["load_factor"] != 1).split("_x")[0]
    chosen = [row for row in rows if row["scene"].split("_x")[0] == family]
    return picture(folder, f"{family}_over_load", pictures.over_load(chosen))


def lean_table(folder):
    rows = lean.read(folder / "lean.csv")
    scaled = lambda row, column, scale: number(float(row[column]) / scale) if row[column] else "–"
    lines = [(row["kind"], row["options"], row["stages"], scaled(row, "seconds", 1), scaled(row, "memory_bytes", 1e6),
              scaled(row, "file_bytes", 1e6), scaled(row, "load_seconds", 1e-3), scaled(row, "resident_bytes", 1e6))
             for row in rows]
    heads = ("kind of scene", "options", "stages that ran", "seconds", "memory, MB", "file, MB",
             "ritz-run: load, one step, a frame, ms", "resident, MB")
    return rows_table(f"A beam, {lean.BEAMS[rows[0]['form']]}", heads, lines) if rows else ""


def sections_of(folder, rows, frames):
    """Anchor, title and content of each part of the page."""
    yield "reach", "Time of stepping to an error of 1 %", summary_table(rows)
    if load := by_load(folder, rows):
        yield "load", "Where linear motion stops being enough", load
    for scene in compare.scenes(rows):
        part = [row for row in rows if row["scene"] == scene]
        yield scene, part[0]["title"], scene_part(folder, part, frames)
    if needs := lean_table(folder):
        yield "lean", "Nothing that a scene does not need", needs
    yield "omissions", "What failed or was left out", omissions(rows)
    yield ("definitions", "Definitions", "<dl>" + "".join(
        f"<dt>{cell(name)}</dt><dd>{cell(text)}</dd>\n" for name, text in errors.DEFINITIONS.items()) + "</dl>")


def write(folder):
    """Returns the path of index.html."""
    rows, frames = table.read(folder / "runs.csv"), table.read(folder / "over_time.csv")
    sections = list(sections_of(folder, rows, frames))
    contents = "".join(f"<li><a href=\"#{cell(anchor)}\">{cell(title)}</a></li>\n" for anchor, title, _ in sections)
    parts = "".join(f"<h2 id=\"{cell(anchor)}\">{cell(title)}</h2>\n{text}\n" for anchor, title, text in sections)
    (folder / "index.html").write_text(
        f"<!DOCTYPE html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>Error against run time</title>\n"
        f"<style>{STYLE}</style>\n<h1>Error against run time</h1>\n<p>{cell(origin(rows))}</p>\n<ul>\n{contents}</ul>\n"
        f"<p>{INTRODUCTION}</p>\n{parts}</html>\n")
    return folder / "index.html"
