"""The frequency weighting W_h of vibration that goes into the hands, ISO 5349-1:2001, annex A.

A band limit of second order at each end, and the weighting proper, with s = 2 pi i f:

    H_b = s^2 w2^2 / ((s^2 + s w1/Q1 + w1^2) (s^2 + s w2/Q1 + w2^2))
    H_w = (s + w3) w4^2 / (w3 (s^2 + s w4/Q2 + w4^2))
    W_h = |H_b H_w|        w_i = 2 pi f_i

f1 = 10^0.8 Hz and f2 = 10^3.1 Hz, Q1 = 1/sqrt(2), w3 = w4 = 100 rad/s, Q2 = 0.64. What is weighted
is acceleration; the squares of its three axes add up to the vibration total value.

Source: the coefficients as in hand_arm_fil of E. L. Zechmann's programs for MATLAB (2008), where
they are rounded (6.31 Hz, 1258.9 Hz, 0.71, 15.915 Hz); unrounded they give the weights of all
third-octave bands from 6.3 to 1250 Hz to the digits of annex 3 of the notice of the Japanese
Ministry of Health, Labour and Welfare on vibrating tools, an extract from ISO 5349-1.
"""

from __future__ import annotations

import numpy as np

from crankstar.spectra import Real

LOWEST, HIGHEST = 2 * np.pi * 10**0.8, 2 * np.pi * 10**3.1
"""rad/s: the ends of the band."""
CORNER = 100.0
"""rad/s: up to about here acceleration counts, beyond it velocity."""
BAND_QUALITY, WEIGHTING_QUALITY = 2**-0.5, 0.64


def hand_arm_weighting(frequencies: Real) -> Real:
    """W_h at angular frequencies (rad/s), of any shape; nought at rest.

    >>> bands = 10.0 ** np.array([0.9, 1.2, 2.0])  # of 8, 16 and 100 Hz, exactly
    >>> hand_arm_weighting(2 * np.pi * bands).round(3).tolist()
    [0.873, 0.896, 0.16]
    """
    s = 1j * np.asarray(frequencies, float)
    low = s**2 + s * LOWEST / BAND_QUALITY + LOWEST**2
    high = s**2 + s * HIGHEST / BAND_QUALITY + HIGHEST**2
    band = s**2 * HIGHEST**2 / (low * high)
    weighting = (s + CORNER) * CORNER / (s**2 + s * CORNER / WEIGHTING_QUALITY + CORNER**2)
    return np.abs(band * weighting)
