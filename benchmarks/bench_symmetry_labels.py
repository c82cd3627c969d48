"""Motifs of symmetry, beside labels by eye.

``python benchmarks/bench_symmetry_labels.py`` prints the table and every disagreement; ``--draw FOLDER`` draws each.
Disagreements are those of the development, unless ``--split reported`` or ``--split both`` asks for others.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

import leitmotion as lm
from intervals import of_pooled_share, of_share
from leitmotion.evaluation import SymmetryScores, SymmetryVerdict, evaluate_symmetry
from leitmotion.evaluation.symmetry import SHOWS, SURE
from leitmotion.motion import Segmentation
from leitmotion.similarity import still_spans
from recordings import locate
from symmetry_clips import SPLITS, TABLES, Clip, clips

Row = tuple[str, str, str]
Answer = Callable[[lm.Motion], Segmentation]
CHEAP = ("commonest", "none", "moving")
NAMES = {"drawn": "Clips drawn at random", "found": "Stretches that were looked for"}
WALKS = ("walks", "sneaks", "jogs")
BOTH, ONE = ("raises both",), ("raises the left", "raises the right")


class Judged(NamedTuple):
    """A clip, and how good each answer about it is."""

    clip: Clip
    scores: dict[str, SymmetryScores]

    @property
    def verdicts(self) -> tuple[SymmetryVerdict, ...]:
        """What the detector says of each stretch."""
        return self.scores["default"].verdicts


@cache
def detected(recording: str) -> Segmentation | None:
    """Find motifs as a user does who sets nothing; none where the recording is refused."""
    try:
        found = lm.find_symmetry(lm.read(locate(recording)))
    except lm.LeitmotionError:
        return None
    spans = found.spans
    return Segmentation(
        [span.start for span in spans],
        [span.stop for span in spans],
        tuple(span.motif for span in spans),
        [span.confidence for span in spans],
        rate=found.rate,
    )


@cache
def commonest() -> str:
    """The motif that most stretches of the development accept."""
    seen = Counter(
        motif
        for table in TABLES
        for clip in clips(table)
        if clip.split == "development"
        for label in clip.labels
        for motif in label.motifs
    )
    return max(SHOWS, key=lambda motif: seen[motif])


def cheap(clip: Clip) -> dict[str, Segmentation]:
    """Answer without looking for symmetry."""
    recording = lm.read(locate(clip.recording))
    first, last = clip.window
    still = []
    if detected(clip.recording) is not None:
        compared = lm.compare_with_mirror(recording)
        every = compared.every
        still = [(start * every, stop * every) for start, stop, *_ in still_spans(compared.distances)]
    ends = [0, *(end for span in still for end in span), max(last, *(stop for _, stop in still), 1)]
    between = [(start, stop) for start, stop in zip(ends[::2], ends[1::2], strict=True) if start < stop]
    rate = recording.rate
    return {
        "commonest": _told([(first, last, commonest())], rate),
        "none": _told([], rate),
        "moving": _told(
            [(*span, "stillness") for span in still] + [(*span, "asymmetric_palindrome") for span in between],
            rate,
        ),
    }


def _told(spans: Sequence[tuple[int, int, str]], rate: float) -> Segmentation:
    starts, stops, motifs = zip(*spans, strict=True) if spans else ((), (), ())
    return Segmentation(starts, stops, motifs, [1.0] * len(spans), rate=rate)


@cache
def judged(table: str) -> tuple[Judged, ...]:
    """Judge every answer about the clips of a table."""
    made = []
    for clip in clips(table):
        answers = cheap(clip)
        found = detected(clip.recording)
        answers["default"] = answers["none"] if found is None else found
        made.append(
            Judged(
                clip,
                {
                    which: evaluate_symmetry(clip.labels, told, window=clip.window)
                    for which, told in answers.items()
                },
            )
        )
    return tuple(made)


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line."""
    table = []
    for name in TABLES:
        for split in SPLITS:
            table += figures(name, split, [one for one in judged(name) if one.clip.split == split])
    return table + named()


def figures(name: str, split: str, held: Sequence[Judged]) -> list[Row]:
    """Count what agrees in the clips of one table and split."""
    verdicts = [verdict for one in held for verdict in one.verdicts]
    sure = sum(verdict.label.sure for verdict in verdicts)
    refused = [one.clip.recording for one in held if detected(one.clip.recording) is None]
    table = [
        (
            f"{NAMES[name]}, {split}",
            f"{len(held)} clips, {len(verdicts)} labelled stretches, the labeller sure of {sure}",
            f"labels/symmetry.md; refused by the detector: {', '.join(refused) or 'none'}",
        )
    ]
    questions: dict[str, tuple[Callable[[SymmetryVerdict], bool], Callable[[SymmetryVerdict], bool], str]] = {
        "The motif agrees": (lambda _: True, lambda one: one.agrees, "docs/evaluation.md"),
        "The same, where the labeller is sure": (
            lambda one: one.label.sure,
            lambda one: one.agrees,
            "as above",
        ),
        "The sides agree": (
            lambda one: bool(one.label.motifs),
            lambda one: one.sides_agree,
            "together, alternate or one; stretches with a motif",
        ),
        "The course agrees": (
            lambda one: bool(one.label.motifs),
            lambda one: one.course_agrees,
            "still, one way, out and back or cycle; stretches with a motif",
        ),
        "Nothing told where no motif was seen": (
            lambda one: not one.label.motifs,
            lambda one: one.agrees,
            "no motif of a whole course with a confidence of one half on half of the stretch",
        ),
    }
    how = (
        f"commonest: always {commonest()}, which most stretches of the development accept; none: nothing told; "
        "moving: stillness where all moments are half alike for half a second, else asymmetric_palindrome"
    )
    for what, (asked, right, rule) in questions.items():
        counts = {which: _counts(held, which, asked, right) for which in ("default", *CHEAP)}
        if not sum(of for _, of in counts["default"]):
            continue
        table.append((what, _share(counts["default"]), f"{rule}; 95 % by the bootstrap over clips"))
        said = ", ".join(f"{which} {_plain(counts[which])}" for which in CHEAP)
        table.append(("The same, cheap answers", said, how if what == "The motif agrees" else "as above"))
    return table + _more(held)


def _more(held: Sequence[Judged]) -> list[Row]:
    whole = sum(all(verdict.agrees for verdict in one.verdicts) for one in held)
    low, high = of_share(whole, len(held))
    by_set = {
        name: _counts(
            [one for one in held if one.clip.set == name], "default", lambda _: True, lambda v: v.agrees
        )
        for name in sorted({one.clip.set for one in held})
    }
    scores = [one.scores["default"] for one in held]
    wrong = [(one.wrong_spans, one.spans) for one in scores]
    seconds, open_, told = (
        sum(getattr(one, field) for one in scores)
        for field in ("seconds", "unlabelled_s", "told_unlabelled_s")
    )
    return [
        (
            "Clips of which every stretch agrees",
            f"{whole} of {len(held)}: {whole / len(held):.1%} ({low:.1%} to {high:.1%})",
            "95 % by Wilson's score",
        ),
        (
            "The motif agrees, by data set",
            ", ".join(f"{n} {_plain(c)}" for n, c in by_set.items()),
            "as above",
        ),
        (
            "Wrong spans",
            _plain(wrong),
            f"of confidence {SURE:g} or more, as long as a labelled stretch that accepts nothing they say",
        ),
        (
            "Time without a label, not checked",
            f"{open_:.0f} of {seconds:.0f} s; something is told of {told:.0f} s of it",
            "of what the labeller saw",
        ),
    ]


def named() -> list[Row]:
    """Check what should be so of well-known movements, in both tables."""
    checks: list[tuple[str, Callable[[Clip, int], bool], Callable[[SymmetryVerdict], bool], str]] = [
        *(
            (
                f"{name} walks are anti-phase",
                lambda clip, k, name=name: (  # type: ignore[misc]
                    clip.set == name
                    and clip.says[k].startswith(WALKS)
                    and clip.labels[k].motifs == ("anti_phase",)
                ),
                lambda one: one.told == "anti_phase",
                "walking, sneaking, jogging over ground; anti_phase stands for the stretch",
            )
            for name in ("CMU", "HDM05", "Bandai Namco")
        ),
        (
            "Jumping jacks are symmetric and palindromic",
            lambda clip, k: clip.says[k].startswith("jumping jack"),
            lambda one: one.told == "symmetric_palindrome",
            "symmetric_palindrome stands for the stretch",
        ),
        (
            "A bow is not anti-phase",
            lambda clip, k: "bows" in clip.says[k],
            lambda one: "anti_phase" not in one.all_told,
            "anti_phase is not told of it at all",
        ),
        (
            "Both hands raised are symmetric",
            lambda clip, k: clip.says[k].startswith(BOTH),
            lambda one: one.sides == "together",
            "a symmetric motif stands for the stretch",
        ),
        (
            "One hand raised is not",
            lambda clip, k: clip.says[k].startswith(ONE),
            lambda one: not any(SHOWS[motif][0] == "together" for motif in one.all_told),
            "no symmetric motif is told of it at all",
        ),
    ]
    table = []
    for what, asked, right, rule in checks:
        said = []
        for split in SPLITS:
            held = [
                right(verdict)
                for name in TABLES
                for one in judged(name)
                if one.clip.split == split
                for k, verdict in enumerate(one.verdicts)
                if asked(one.clip, k)
            ]
            said.append(f"{split} {sum(held)} of {len(held)}")
        table.append((what, ", ".join(said), f"{rule}; stretches of both tables"))
    return table


def disagreements(split: str) -> Iterator[tuple[str, Clip, SymmetryVerdict, str]]:
    """Give each stretch of which something else is told than was seen: table, clip, verdict, what is done."""
    for table in TABLES:
        for one in judged(table):
            if split in (one.clip.split, "both"):
                for verdict, says in zip(one.verdicts, one.clip.says, strict=True):
                    if not verdict.agrees:
                        yield table, one.clip, verdict, says


def _counts(
    held: Sequence[Judged],
    which: str,
    asked: Callable[[SymmetryVerdict], bool],
    right: Callable[[SymmetryVerdict], bool],
) -> list[tuple[int, int]]:
    """Of each clip, how many of the stretches that are asked about are right."""
    each = [[right(verdict) for verdict in one.scores[which].verdicts if asked(verdict)] for one in held]
    return [(sum(answers), len(answers)) for answers in each]


def _plain(counts: Sequence[tuple[int, int]]) -> str:
    return f"{sum(right for right, _ in counts)} of {sum(of for _, of in counts)}"


def _share(counts: Sequence[tuple[int, int]]) -> str:
    right, of = (sum(column) for column in zip(*counts, strict=True))
    low, high = of_pooled_share(counts)
    return f"{right} of {of}: {right / of:.1%} ({low:.1%} to {high:.1%})"


def main() -> None:
    """Print the table and the disagreements, and draw them where that is asked for."""
    asked = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    asked.add_argument("--draw", type=Path, metavar="FOLDER", help="draw each disagreement there")
    asked.add_argument("--split", choices=(*SPLITS, "both"), default="development")
    given = asked.parse_args()
    for what, figure, protocol in rows():
        print(f"{what}: {figure} ({protocol})")
    for table, clip, verdict, says in disagreements(given.split):
        label = verdict.label
        print(
            f"{table}: {clip.recording} [{label.start}, {label.stop}) {says}: seen {'|'.join(label.motifs) or 'none'}, "
            f"told {verdict.told} {verdict.confidence:.2f} (fit {verdict.fit:.2f}; all {', '.join(verdict.all_told)})"
        )
        if given.draw:
            from draw_symmetry import draw

            told = detected(clip.recording)
            draw(clip, verdict, told if told is not None else _told([], 1.0), says, given.draw)


if __name__ == "__main__":
    main()
