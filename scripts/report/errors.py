"""The errors, each beside the sentence that the page prints. u, v: displacements, frames x degrees of freedom; M: the
mass matrix of the mesh; the reference is the second argument."""
import numpy as np

TRAPEZOID = np.trapezoid if hasattr(np, "trapezoid") else np.trapz

DEFINITIONS = {
    "M-norm": "‖u‖_M = √(uᵀ M u), M the consistent mass matrix of the mesh.",
    "error_integrated":
        "Time-integrated relative displacement error: √(∫‖u − v‖²_M dt / ∫‖v‖²_M dt) by the trapezoidal rule over the "
        "frames, v being the reference. Of statics: over the load fraction.",
    "error_max": "Its maximum: max ‖u − v‖_M / max ‖v‖_M over the frames.",
    "error_basis":
        "Basis part: the time-integrated error of the same reduced model run at the reference's step. Of linear runs "
        "it holds what linearisation leaves out.",
    "error_time":
        "Time part: the time-integrated difference from the same reduced model at the reference's step, relative to "
        "the reference. It is floored by the reference's step itself.",
    "error_mesh":
        "Mesh part: √(∫|p − q|² dt / ∫|q|² dt) of the probe, the full model on this mesh against one on another mesh "
        "at the same step.",
    "floor":
        "The reference's floor: the time-integrated difference between the reference and the same at twice its step. "
        "What is below it is not told apart.",
    "error_frequency":
        "Frequency error: |f − f_ref| / f_ref of the probe's strongest tone after the release, under a Hann window.",
    "error_force":
        "Reduced-force error: the largest ‖f̃(z) − Uᵀf(Uz)‖ relative to ‖Uᵀf(Uz)‖ over the poses that ritz-reduce "
        "tries; of a cubature in the energy norm, ‖Λ^(−½)·‖, over poses that it was not trained on.",
    "energy_balance":
        "Energy balance: max |E − E₀ − W + Q| over the largest energy that there was, W being the work of the loads and Q "
        "what damping took. Of nonlinear models, full and reduced; these look at it 200 times in a motion.",
}


def norms(u, mass):
    """‖u‖_M of every frame."""
    return np.sqrt(np.maximum(0.0, np.einsum("fi,fi->f", u, (mass @ u.T).T)))


def integrated(error, size, times):
    """√(∫error² dt / ∫size² dt) of norms over the frames."""
    return float(np.sqrt(TRAPEZOID(error**2, times) / TRAPEZOID(size**2, times)))


def largest(error, size):
    return float(np.max(error) / np.max(size))


def probes(p, q, times):
    """Of probes, frames x 3."""
    return integrated(np.linalg.norm(p - q, axis=1), np.linalg.norm(q, axis=1), times)


PERIODS = 1.5  # that a signal must hold for its tone to be told


def tone(times, signal):
    """The strongest frequency, Hz, by a parabola through the logarithms about the highest peak of the spectrum; NaN
    where the signal is too short to tell."""
    padded = 16 * len(signal)
    amplitudes = np.abs(np.fft.rfft((signal - signal.mean()) * np.hanning(len(signal)), padded))
    top = int(np.argmax(amplitudes[1:-1])) + 1
    left, middle, right = np.log(amplitudes[top - 1:top + 2])
    shift = (left - right) / (2 * (left - 2 * middle + right))
    frequency = float((top + shift) / (padded * (times[1] - times[0])))
    return frequency if frequency * (times[-1] - times[0]) >= PERIODS else float("nan")


def relative(value, reference):
    return abs(value - reference) / abs(reference)
