#!/usr/bin/env python3
"""Draws the motion of a run's probes and the spectrum of the liveliest, and prints its strongest tone.

    plot_probes.py probes.csv picture.png
"""
import argparse
import csv

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of backend)

CLOSE_UP = 12  # periods of the strongest tone
PADDING = 8  # the spectrum is drawn this many times finer than the record's own resolution


def read(path):
    """Times, and displacements by column name."""
    with open(path, newline="") as file:
        rows = csv.reader(file)
        names = next(rows)
        table = np.array([[float(word) for word in row] for row in rows])
    if table.ndim != 2 or len(table) < 8:
        raise SystemExit(f"{path}: a spectrum wants at least 8 rows")
    return table[:, 0], dict(zip(names[1:], table.T[1:]))


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


def draw(times, columns, name, path):
    frequencies, amplitudes = spectrum(times, columns[name])
    tone = strongest(frequencies, amplitudes)
    component = name[-3:]
    figure, (whole, close, tones) = plt.subplots(3, 1, figsize=(9, 9), layout="constrained")
    for axes in (whole, close):
        for label, signal in columns.items():
            if label.endswith(component):
                axes.plot(1e3 * times, 1e3 * signal, linewidth=0.8, label=label)
        axes.set(xlabel="time, ms", ylabel="displacement, mm")
    whole.legend(loc="upper right")
    whole.set(title="Motion of the probes", xlim=(0, 1e3 * times[-1]))
    close.set(title="Its beginning", xlim=(0, min(1e3 * times[-1], 1e3 * CLOSE_UP / tone)))
    tones.semilogy(frequencies, 1e3 * amplitudes, linewidth=0.9)
    tones.set(title=f"Spectrum of {name}", xlabel="frequency, Hz", ylabel="amplitude, mm",
              xlim=(0, min(frequencies[-1], 12 * tone)), ylim=(1e3 * amplitudes.max() * 1e-6, 4e3 * amplitudes.max()))
    tones.annotate(f"{tone:.1f} Hz", (tone, 1e3 * amplitudes.max()), xytext=(8, 0), textcoords="offset points")
    for axes in (whole, close, tones):
        axes.grid(alpha=0.3)
    figure.savefig(path, dpi=110)
    return tone


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("probes")
    parser.add_argument("picture")
    options = parser.parse_args()
    times, columns = read(options.probes)
    name = max(columns, key=lambda label: columns[label].std())
    print(f"strongest tone of {name}: {draw(times, columns, name, options.picture):.1f} Hz")


if __name__ == "__main__":
    main()
