"""Results as notebooks show them, and as matplotlib draws them."""

import html
import json
from collections.abc import Mapping

from . import _core


class Paged:
    """Something with a `result`, which a notebook shows as the page of percal report."""

    def _repr_html_(self):
        page = html.escape(_core.html(json.dumps(self.result)), quote=True)
        return f'<iframe srcdoc="{page}" style="width: 100%; height: 40rem; border: 0" title="percal"></iframe>'


class _Result(Paged, Mapping):
    """A result.json as a read-only dict."""

    def __init__(self, result):
        self._result = result

    @property
    def result(self):
        """The dict itself."""
        return self._result

    def __getitem__(self, key):
        return self._result[key]

    def __iter__(self):
        return iter(self._result)

    def __len__(self):
        return len(self._result)


def axes(ax):
    """The axes to draw into: those given, else new ones of matplotlib."""
    if ax is not None:
        return ax
    try:
        import matplotlib.pyplot
    except ImportError as missing:
        raise ImportError("plot() draws with matplotlib, which is not installed; or give it axes as ax=") from missing
    return matplotlib.pyplot.subplots()[1]
