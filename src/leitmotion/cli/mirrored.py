"""The postures of a recording beside their mirror images: figures, a row per moment, both matrices, their picture."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from leitmotion.cli.batch import Answer
from leitmotion.cli.documents import SCORE_DIGITS, SECONDS_DIGITS, Document, curve, decimals, stretch
from leitmotion.cli.inputs import Input
from leitmotion.cli.mirror_options import MirrorOptions
from leitmotion.cli.options import Options
from leitmotion.cli.outputs import PICTURES, save_value, write_figure
from leitmotion.cli.printing import print_table
from leitmotion.cli.progress import Progress, compiling_noted
from leitmotion.cli.recordings import Opened, open_one

if TYPE_CHECKING:
    import numpy as np
    from rich.console import Console

    from leitmotion.api import Mirrored, Segmentation
    from leitmotion.features import SideBias
    from leitmotion.similarity import DoubleMetric

COLUMNS = ("path", "frame", "time_s", "lopsidedness_deg", "speed_deg_s", "still")
"""Columns of the table, one row per moment of each input."""
DEGREE_DIGITS = 4


def compare_mirrored(
    given: Input, form: str, asked: MirrorOptions, options: Options, progress: Progress
) -> tuple[Answer, list[Document]]:
    """Answer how alike the moments of an input are to one another's mirror images, and make its rows of the table.

    Parameters
    ----------
    given : Input
        The recording.
    form : str
        Of the picture.
    asked : MirrorOptions
        How it is compared.
    options : Options
        How it is read, and how the joints are weighed.
    progress : Progress
        Told what is being done.
    """
    from leitmotion.api import compare_with_mirror

    opened = open_one(given, options, progress)
    progress.say(f"Mirroring {given.path.name}")
    with compiling_noted(progress):
        made = compare_with_mirror(
            opened.recording,
            metric=asked.metric,
            weights=options.weights,
            bias=asked.bias,
            beta=asked.beta,
            body_map=opened.roles,
        )
        curves = _curves(made)
    result = _result(made, curves, opened)
    kept = []
    if options.output is not None and options.output.suffix.lower() in (".npz", *PICTURES):
        progress.say(f"Writing {options.output.name}")
        kept.append(_write(options.output, made.distances, form))
    answer = Answer(
        source=opened.source,
        result=result,
        show=lambda console: _show(console, result),
        parameters={
            "metric": asked.metric,
            "weights": options.weights,
            "bias": asked.bias,
            "links": made.distances.names,
            **opened.parameters,
        },
        warnings=[*opened.warnings, *bias_remarks(made.bias)],
        written=kept,
    )
    return answer, _rows(given, made, curves, opened)


class _Curves(NamedTuple):
    """What the diagonals of both matrices tell, moment by moment."""

    lopsidedness: np.ndarray
    """(T,) degrees."""

    speed: np.ndarray
    """(T,) degrees a second."""

    still: Segmentation
    """Stretches of moments."""


def _curves(made: Mirrored) -> _Curves:
    import numpy as np

    from leitmotion.similarity import axis_speed, link_angle, still_spans

    found = made.distances
    return _Curves(
        np.degrees(link_angle(found.lopsidedness, found.metric)),
        np.degrees(axis_speed(found)),
        still_spans(found),
    )


def _rows(given: Input, made: Mirrored, curves: _Curves, opened: Opened) -> list[Document]:
    """One row per moment; what is not known is an empty cell."""
    still = {k for start, stop, _, _ in curves.still for k in range(start, stop)}
    return [
        {
            "path": given.shown,
            "frame": k * made.every,
            "time_s": round(k * made.every / opened.recording.rate, SECONDS_DIGITS),
            "lopsidedness_deg": decimals(lopsided, DEGREE_DIGITS),
            "speed_deg_s": decimals(speed, DEGREE_DIGITS),
            "still": int(k in still),
        }
        for k, (lopsided, speed) in enumerate(
            zip(curves.lopsidedness.tolist(), curves.speed.tolist(), strict=True)
        )
    ]


def _result(made: Mirrored, curves: _Curves, opened: Opened) -> Document:
    """Make the result of the verb `similarity` with ``--symmetry``."""
    import numpy as np

    from leitmotion.similarity import symmetry_index

    found, frames, rate = made.distances, len(opened.recording), opened.recording.rate
    still = [(start * made.every, min(stop * made.every, frames)) for start, stop, _, _ in curves.still]
    return {
        "moments": len(found),
        "frames_a_moment": made.every,
        "beta": found.beta,
        "half_alike": found.half,
        "half_alike_deg": float(np.degrees(found.half_angle)),
        "symmetry_index": decimals(symmetry_index(found), SCORE_DIGITS),
        "share_alike": _share(found.own, found.half),
        "share_alike_to_mirror": _share(found.mirror, found.half),
        "lopsidedness_deg": curve(curves.lopsidedness, found.rate),
        "speed_deg_s": curve(curves.speed, found.rate),
        "still_share": round(sum(stop - start for start, stop in still) / frames, SCORE_DIGITS),
        "still": [stretch(start, stop, rate=rate, label="stillness") for start, stop in still],
        "bias": bias_entry(made.bias),
    }


def _share(distances: np.ndarray, half: float) -> float | None:
    """The share of pairs of moments that are half alike or more, of those that are seen."""
    import numpy as np

    known = int(np.isfinite(distances).sum())
    return round(int((distances <= half).sum()) / known, SCORE_DIGITS) if known else None


def bias_entry(bias: SideBias | None) -> Document | None:
    """Tell by which posture the bias of the sides was measured, and how large it is, link by link."""
    if bias is None:
        return None
    import numpy as np

    return {
        "pose": bias.pose,
        "frames": bias.frames,
        "angles_deg": dict(
            zip(bias.names, np.degrees(bias.angles).round(DEGREE_DIGITS).tolist(), strict=True)
        ),
        "left_as_they_are": bias.too_large,
    }


def bias_sentence(bias: Document | None) -> str:
    """Say what was taken out; nothing where that was nothing."""
    if bias is None:
        return ""
    from leitmotion.view.counting import plural

    name, angle = max(bias["angles_deg"].items(), key=lambda one: one[1])
    return (
        f"The bias of the sides in the {bias['pose']} posture ({plural(bias['frames'], 'frame')}) is taken out: up to "
        f"{angle:.1f}°, at the {name.replace('_', ' ')}."
    )


def bias_remarks(bias: SideBias | None) -> list[str]:
    """Say where the sides differ by more than a suit that sits askew."""
    if bias is None or not bias.too_large:
        return []
    return [
        f"The sides differ by more than 20° in the {bias.pose} posture, and are left as they are: "
        f"{', '.join(name.replace('_', ' ') for name in bias.too_large)}."
    ]


def _write(path: Path, found: DoubleMetric, form: str) -> str:
    if path.suffix.lower() == ".npz":
        return save_value(path, found)
    from leitmotion.view import plot_symmetry

    return write_figure(path, plot_symmetry(found, form=form))


def _show(console: Console, result: Document) -> None:
    from leitmotion.view.counting import clock, plural

    console.print(
        f"Two postures are half alike at {result['half_alike_deg']:.2g}° a link, β = {result['beta']:.3g}.",
        style="bold",
    )
    lopsided, speed = result["lopsidedness_deg"], result["speed_deg_s"]
    told = []
    if result["share_alike"] is not None:
        told.append(
            ("like itself", f"{result['share_alike']:.1%}", "of all pairs of moments, half alike or more")
        )
    if result["share_alike_to_mirror"] is not None:
        told.append(("like its mirror image", f"{result['share_alike_to_mirror']:.1%}", "of them"))
    if result["symmetry_index"] is not None:
        told.append(
            ("symmetry index", f"{result['symmetry_index']:.2f}", "the mean of Z* over the mean of Z")
        )
    if lopsided["mean"] is not None:
        ends = f"{lopsided['least']:.1f}° to {lopsided['most']:.1f}°, most at {clock(lopsided['most_at_s'])}"
        told.append(("lopsidedness", f"{lopsided['mean']:.1f}°", f"mean; {ends}"))
    if speed["mean"] is not None:
        most = f"at most {speed['most']:.0f} °/s, at {clock(speed['most_at_s'])}"
        told.append(("speed", f"{speed['mean']:.0f} °/s", f"of a mean link; {most}"))
    stretches = f", in {plural(len(result['still']), 'stretch')}" if result["still"] else ""
    told.append(("still", f"{result['still_share']:.1%}", f"of the time{stretches}"))
    print_table(console, ("", ">", ""), told)
    if sentence := bias_sentence(result["bias"]):
        console.print(sentence)
