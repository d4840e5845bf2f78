"""Plots of accuracy and of run times, as PNG and PDF; they need matplotlib, the extra `plots`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from grounding.experiments.engines import ADAPTIVE
from grounding.experiments.errors import ExperimentError
from grounding.experiments.paper import TABLE_I
from grounding.experiments.summary import ALL, Record

COLORS = {"adcg": "#0b6e99", "dcg": "#c8502d", "exact": "#3f8f4f", "g3": "#7a5195",
          "hadcg": "#2bb3c0", "hdcg": "#e0a030"}  # told apart without colour vision
NAMES = {"adcg": "ADCG", "dcg": "DCG", "exact": "exact ADCG", "g3": "G3", "hadcg": "HADCG", "hdcg": "HDCG"}
_SIZES = ("#9ecae1", "#4f9bcb", "#2171b5", "#c8502d", "#7f2704", "#7a5195", "#3f8f4f", "#555555")
_GREY = "#666666"
_STYLE: Any = {
    "font.family": "serif",
    "font.serif": ["STIXGeneral", "DejaVu Serif"],
    "mathtext.fontset": "stix",
    "font.size": 10,
    "axes.titlesize": 10.5,
    "axes.labelsize": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.linewidth": 0.8,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.6,
    "legend.frameon": False,
    "legend.fontsize": 9,
    "lines.linewidth": 1.6,
    "lines.markersize": 4.5,
    "figure.dpi": 100,
    "savefig.dpi": 220,
    "pdf.fonttype": 42,
}


def require_matplotlib(written: Path) -> None:
    """Refuse to plot where matplotlib is not installed.

    Args:
        written: where the tables are, which need no plots.

    Raises:
        ExperimentError: naming the extra that brings it.
    """
    try:
        import matplotlib  # noqa: F401
    except ImportError:
        raise ExperimentError(
            f"the plots need matplotlib, which is not installed: pip install 'adcg-baxter[plots]'; the tables are in "
            f"{written}, --no-plots leaves the plots out"
        ) from None


def plot_accuracy(records: Sequence[Record], paper: Mapping[str, Any] | None, by: str, path: Path) -> Path:
    """Root and complete-tree accuracy over the holdout, one line a method (Figure 5); bands are standard errors.

    Args:
        records: of a run.
        paper: what the paper reports, by measure, or None.
        by: which splits.
        path: of the picture.
    """
    chosen = [r for r in records if r.by == by and r.slice == ALL]
    with _figure(1, 2, (7.2, 3.0), path) as axes:
        for axis, measure, title in zip(axes, ("root", "complete"), ("Root", "Complete tree"), strict=True):
            for parse, name in dict.fromkeys((r.parse, r.inference) for r in chosen):
                line = [r for r in chosen if (r.parse, r.inference, r.measure) == (parse, name, measure)]
                own = parse == "own"
                label = NAMES.get(name, name) + (", own parse" if own else "")
                _curve(axis, line, name, label, own)
            if paper and by == "random":
                places = [point[0] for point in paper[measure]]
                shares = [point[1] for point in paper[measure]]
                axis.plot(places, shares, "D", mfc="white", mec=_GREY, mew=1.1, ms=5, label="ADCG, best and worst\nin "
                          "the paper")  # fmt: skip
            _holdout_axis(axis, chosen, title, by)
        axes[0].set_ylabel("accuracy")
        axes[1].tick_params(labelleft=False)
        _legend_below(axes)
    return path


def plot_by_blocks(records: Sequence[Record], by: str, parse: str, inference: str, path: Path) -> Path:
    """Root and complete-tree accuracy over the holdout, one line a number of blocks."""
    chosen = [r for r in records if (r.by, r.parse, r.inference) == (by, parse, inference)]
    sizes = sorted({int(r.slice.split()[0]) for r in chosen if r.slice.endswith(" blocks")})
    with _figure(1, 2, (7.2, 3.0), path) as axes:
        for axis, measure, title in zip(axes, ("root", "complete"), ("Root", "Complete tree"), strict=True):
            for i, size in enumerate(sizes):
                line = [r for r in chosen if r.slice == f"{size} blocks" and r.measure == measure]
                axis.plot([r.holdout for r in line], [r.mean for r in line], "o-", color=_SIZES[i % len(_SIZES)],
                          label=f"{size} blocks", clip_on=False)  # fmt: skip
            line = [r for r in chosen if r.slice == ALL and r.measure == measure]
            axis.plot([r.holdout for r in line], [r.mean for r in line], "--", color="#111111", label="all")
            _holdout_axis(axis, chosen, title, by)
        axes[0].set_ylabel("accuracy")
        axes[1].tick_params(labelleft=False)
        _legend_below(axes)
    return path


def plot_efficiency(rows: Sequence[Any], fits: Mapping[str, Any], paper: bool, path: Path) -> Path:
    """Seconds a phrase and evaluated factors a phrase over the number of blocks, both axes logarithmic.

    Args:
        rows: `grounding.experiments.efficiency.Cost` of every engine and size.
        fits: growth by engine, told in the legend.
        paper: whether Table I is drawn beside.
        path: of the picture.
    """
    with _figure(1, 2, (7.2, 3.3), path) as axes:
        left, right = axes
        for name in dict.fromkeys(row.inference for row in rows):
            line = [row for row in rows if row.inference == name]
            blocks = [row.blocks for row in line]
            color, label = COLORS.get(name, _GREY), NAMES.get(name, name)
            exponent = (fits.get(name) or {}).get("exponent")
            told = f"{label}, $n^{{{exponent:.1f}}}$" if exponent is not None else label
            left.plot(blocks, [row.median for row in line], "o-", color=color, label=told)
            left.fill_between(blocks, [row.median for row in line], [row.p95 for row in line], color=color, alpha=0.15,
                              lw=0)  # fmt: skip
            right.plot(blocks, [row.evaluations for row in line], "o-", color=color, label=told)
        if paper:
            for name in ("dcg", "adcg"):
                seconds = [getattr(line, name) for line in TABLE_I.values()]
                left.plot(list(TABLE_I), seconds, "D:", color=COLORS[name], mfc="white", lw=1, ms=4.5,
                          label=f"{NAMES[name]} in the paper")  # fmt: skip
        for axis, title in ((left, "Seconds a phrase"), (right, "Factor evaluations a phrase")):
            axis.set_title(title)
            axis.set_xscale("log")
            axis.set_yscale("log")
            axis.set_xlabel("blocks in the world")
            ticks = sorted({row.blocks for row in rows})
            axis.set_xticks(_apart(ticks), [str(tick) for tick in _apart(ticks)])
            axis.minorticks_off()
        _legend_below(axes)
    return path


def _curve(axis: Any, line: Sequence[Record], name: str, label: str, own: bool) -> None:
    """One method; ADCG lies on top with small full marks, so that others show around it where they are as good."""
    color, first = COLORS.get(name, _GREY), name == ADAPTIVE
    places, means = [r.holdout for r in line], [r.mean for r in line]
    axis.plot(places, means, "--" if own else "-", marker="s" if own else "o", color=color, label=label,
              ms=4.5 if first else 7.5, mfc=color if first else "white", mew=1.2, lw=1.6 if first else 2.4,
              zorder=3 if first else 2)  # fmt: skip
    low = [r.mean - r.standard_error for r in line]
    high = [r.mean + r.standard_error for r in line]
    axis.fill_between(places, low, high, color=color, alpha=0.15, lw=0)


def _holdout_axis(axis: Any, records: Sequence[Record], title: str, by: str) -> None:
    places = sorted({r.holdout for r in records})
    axis.set_title(title)
    axis.set_xlabel("share of worlds held out" if by == "worlds" else "share of instructions held out")
    axis.set_ylim(-0.02, 1.02)
    if len(places) > 1:
        margin = 0.04 * (places[-1] - places[0])
        axis.set_xlim(places[0] - margin, places[-1] + margin)


def _apart(ticks: Sequence[int]) -> list[int]:
    """Ticks that are not too near to each other on a logarithmic axis."""
    kept: list[int] = []
    for tick in ticks:
        if not kept or tick >= 1.3 * kept[-1]:
            kept.append(tick)
    return kept


def _legend_below(axes: Sequence[Any]) -> None:
    """One legend for all panels, under them."""
    found: dict[str, Any] = {}
    for axis in axes:
        for handle, label in zip(*axis.get_legend_handles_labels(), strict=True):
            found.setdefault(label, handle)
    axes[0].figure.legend(found.values(), found.keys(), loc="outside lower center", ncols=min(4, max(len(found), 1)))


@contextmanager
def _figure(rows: int, columns: int, size: tuple[float, float], path: Path) -> Iterator[Any]:
    """A figure in the style of all plots, written as `path` and, beside it, as PDF."""
    import matplotlib
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    with matplotlib.rc_context(_STYLE):
        figure = Figure(figsize=size, layout="constrained")
        FigureCanvasAgg(figure)
        yield figure.subplots(rows, columns, squeeze=False).ravel()
        figure.savefig(path)
        figure.savefig(path.with_suffix(".pdf"), metadata={"CreationDate": None})
