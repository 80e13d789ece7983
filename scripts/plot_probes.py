#!/usr/bin/env python3
"""Draws the motion of a run's probes, each along the axis on which it moves most, each quantity in its unit, and the
spectrum of the liveliest; prints its strongest tone.

    plot_probes.py probes.csv picture.png
"""
import argparse
import csv
import re

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of backend)

QUANTITIES = {"u": ("displacement", "mm", 1e3), "v": ("velocity", "m/s", 1), "a": ("acceleration", "m/s²", 1)}
CLOSE_UP = 12  # periods of the strongest tone
PADDING = 8  # the spectrum is drawn this many times finer than the record's own resolution


def read(path):
    """Times, and signals by column name: NAME_ux of a displacement (m), NAME_vx of a velocity (m/s), NAME_ax (m/s²); of
    each probe and quantity the component that varies most."""
    with open(path, newline="") as file:
        rows = csv.reader(file)
        names = next(rows, [])
        if names[:1] != ["t"] or len(names) < 2 or not all(re.search("_[uva][xyz]$", name) for name in names[1:]):
            raise SystemExit(f"{path} is not a table of probes, as ritz-run and ritz-full write it")
        table = np.array([[float(word) for word in row] for row in rows])
    if table.ndim != 2 or len(table) < 8:
        raise SystemExit(f"{path}: a spectrum wants at least 8 rows")
    spans = np.ptp(table, axis=0)
    liveliest = [int(np.argmax(spans[first:first + 3])) + first for first in range(1, len(names), 3)]
    if not max(spans[liveliest]) > 0:
        raise SystemExit(f"{path}: nothing moves")
    return table[:, 0], {names[i]: table[:, i] for i in liveliest}


def spectrum(times, signal):
    """Frequencies (Hz) and amplitudes of the signal under a Hann window, in the signal's own unit."""
    window = np.hanning(len(signal))
    amplitudes = abs(np.fft.rfft((signal - signal.mean()) * window, PADDING * len(signal))) * 2 / window.sum()
    return np.fft.rfftfreq(PADDING * len(signal), times[1] - times[0]), amplitudes


def strongest(frequencies, amplitudes):
    """The frequency of the highest peak, by a parabola through the logarithms about it."""
    top = int(np.argmax(amplitudes[1:-1])) + 1
    left, middle, right = np.log(amplitudes[top - 1:top + 2])
    shift = (left - right) / (2 * (left - 2 * middle + right))
    return frequencies[top] + shift * (frequencies[1] - frequencies[0])


def liveliest(columns):
    """The column that varies most, of displacements if there are any, else of velocities, else of accelerations."""
    measured = next(letter for letter in QUANTITIES if any(label[-2] == letter for label in columns))
    return max((label for label in columns if label[-2] == measured), key=lambda label: columns[label].std())


def draw(times, columns, name, path):
    frequencies, amplitudes = spectrum(times, columns[name])
    tone = strongest(frequencies, amplitudes)
    start, end = 1e3 * times[0], 1e3 * times[-1]
    shown = [letter for letter in QUANTITIES if any(label[-2] == letter for label in columns)]
    near = start + 1e3 * CLOSE_UP / tone
    if near < end:
        shown.append(name[-2])
    figure, panels = plt.subplots(len(shown) + 1, 1, figsize=(9, 3 * len(shown) + 3), layout="constrained")
    *motions, tones = panels
    for axes, letter in zip(motions, shown):
        quantity, unit, scale = QUANTITIES[letter]
        for label, signal in columns.items():
            if label[-2] == letter:
                axes.plot(1e3 * times, scale * signal, linewidth=0.8, label=label)
        axes.set(xlabel="time, ms", ylabel=f"{quantity}, {unit}", xlim=(start, end))
        axes.legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=3, frameon=False)  # where no curve is
    motions[0].set_title("Motion of the probes", loc="left")
    if near < end:
        motions[-1].set_title("Its beginning", loc="left")
        motions[-1].set_xlim(start, near)
    _, unit, scale = QUANTITIES[name[-2]]
    tones.semilogy(frequencies, scale * amplitudes, linewidth=0.9)
    tones.set_title(f"Spectrum of {name}", loc="left")
    tones.set(xlabel="frequency, Hz", ylabel=f"amplitude, {unit}",
              xlim=(0, min(frequencies[-1], 12 * tone)), ylim=scale * amplitudes.max() * np.array([1e-6, 4]))
    tones.annotate(f"{tone:.1f} Hz", (tone, scale * amplitudes.max()), xytext=(8, 0), textcoords="offset points")
    for axes in panels:
        axes.grid(alpha=0.3)
    figure.savefig(path, dpi=110)
    return tone


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("probes")
    parser.add_argument("picture")
    options = parser.parse_args()
    times, columns = read(options.probes)
    name = liveliest(columns)
    print(f"strongest tone of {name}: {draw(times, columns, name, options.picture):.1f} Hz")


if __name__ == "__main__":
    main()
