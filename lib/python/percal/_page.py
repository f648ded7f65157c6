"""Results as notebooks show them, and as matplotlib draws them."""

import html
import json

from . import _core


class Paged:
    """Something with a `result`, which a notebook shows as the page of percal report."""

    def _repr_html_(self):
        page = html.escape(_core.html(json.dumps(self.result)), quote=True)
        return f'<iframe srcdoc="{page}" style="width: 100%; height: 40rem; border: 0" title="percal"></iframe>'


def axes(ax):
    """The axes to draw into: those given, else new ones of matplotlib."""
    if ax is not None:
        return ax
    try:
        import matplotlib.pyplot
    except ImportError as missing:
        raise ImportError("plot() draws with matplotlib, which is not installed; or give it axes as ax=") from missing
    return matplotlib.pyplot.subplots()[1]
