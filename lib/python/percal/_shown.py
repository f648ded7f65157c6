"""Numbers with their units, for people."""

import math

_PREFIXES = ((1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "u"), (1e-9, "n"))


def with_unit(value, unit, digits=4):
    """ "61.22 kPa" of 61223 and "Pa"; "none" where there is no value."""
    if value is None:
        return "none"
    if value == 0 or not math.isfinite(value):
        return f"{value:g} {unit}"
    size, prefix = next(((s, p) for s, p in _PREFIXES if abs(value) >= s), _PREFIXES[-1])
    return f"{value / size:.{digits}g} {prefix}{unit}"


def between(interval, unit=""):
    """ "[37.1 kPa, 85.4 kPa]"; an open end is marked with the sign of what lies beyond it."""
    ends = [with_unit(end, unit) if unit else f"{end:.4g}" for end in interval[:2]]
    low = ("<= " if interval.low_open else "") + ends[0]
    high = (">= " if interval.high_open else "") + ends[1]
    return f"[{low}, {high}]"
