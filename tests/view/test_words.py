"""The sentences: counts as words, singulars, what is true of this file and nothing else."""

import itertools

import numpy as np
import pytest

from leitmotion.body import Body
from leitmotion.discovery import Pattern, Patterns
from leitmotion.motion import Segmentation
from leitmotion.view import lengths, words
from leitmotion.view.words import Chip


def pattern(
    letter: str, stretches: int, cycles: int, *, kind: str = "cyclic", period: float = 1.5
) -> Pattern:
    """A pattern of `stretches` stretches of 10 s with `cycles` cycles in all, 20 s apart, at 10 Hz."""
    held = [(200 * k, 200 * k + 100) for k in range(stretches)]
    share = [cycles // stretches + (k < cycles % stretches) for k in range(stretches)]
    ones = [(a + 15 * n, a + 15 * n + 15) for (a, _), count in zip(held, share) for n in range(count)]
    spans = ones if kind == "cyclic" else held
    return Pattern(
        letter,
        kind,
        Segmentation([a for a, _ in spans], [b for _, b in spans], rate=10.0),
        Segmentation([a for a, _ in held], [b for _, b in held], rate=10.0),
        period,
        0.02,
        0.82,
        "cycles are alike.",
    )


def found(*patterns: Pattern, miss: str = "", **parameters: object) -> Patterns:
    return Patterns(patterns, (), 10.0, dict(parameters), miss)


def plain(lead: words.Lead) -> str:
    return "".join(piece if isinstance(piece, str) else f"[{piece.id}]" for piece in lead)


@pytest.mark.parametrize(
    ("patterns", "title"),
    [
        (found(), "Nothing repeats here"),
        (found(pattern("A", 1, 12)), "One movement recurs, twelve times"),
        (found(pattern("A", 1, 2)), "One movement recurs, twice"),
        (found(pattern("A", 3, 14)), "One movement recurs, 14 times"),
        (found(*(pattern(c, 1, 2) for c in "ABCD")), "Four movements recur"),
        (found(*(pattern(f"A{k}", 1, 2) for k in range(13))), "13 movements recur"),
    ],
)
def test_the_title_is_what_was_found(patterns: Patterns, title: str) -> None:
    assert words.title(patterns) == title


@pytest.mark.parametrize(
    ("patterns", "lead"),
    [
        (
            found(pattern("A", 3, 4), pattern("B", 1, 2), pattern("C", 2, 2), pattern("D", 1, 2)),
            "[A] comes back three times and [C] twice. [B] and [D] repeat within one stretch.",
        ),
        (found(pattern("A", 1, 2), pattern("B", 1, 2)), "[A] and [B] repeat within one stretch."),
        (found(pattern("A", 2, 4), pattern("B", 2, 4)), "[A] and [B] come back twice."),
        (
            found(pattern("A", 2, 4), pattern("B", 1, 4)),
            "[A] comes back twice. [B] repeats within one stretch.",
        ),
        (found(pattern("A", 1, 3)), "[A] repeats within one stretch: 3 cycles of 1.50 s."),
        (found(pattern("A", 2, 3)), "[A] comes back in two stretches: 3 cycles of 1.50 s."),
        (found(pattern("A", 2, 2, kind="acyclic", period=10)), "[A] comes back twice, 10.00 s each."),
        (
            found(*(pattern(c, 1, 2) for c in "ABCDEFGHI")),
            "[A], [B], [C], [D], [E], [F], [G] and [H] repeat within one stretch each. One more recurs.",
        ),
        (found(), "Nothing in these 38 seconds was near and clear enough to count as a repeat."),
    ],
)
def test_the_lead_is_one_line_of_chips_and_counts(patterns: Patterns, lead: str) -> None:
    pieces = words.lead(patterns, 38.2)
    assert plain(pieces) == lead
    assert not any(isinstance(a, str) and isinstance(b, str) for a, b in itertools.pairwise(pieces))
    assert all(isinstance(piece, str | Chip) for piece in pieces)


def test_a_lane_minds_the_singular() -> None:
    assert words.lane_head(pattern("A", 3, 4)) == ("3 stretches", "4 cycles of 1.50 s")
    assert words.lane_head(pattern("A", 1, 2)) == ("1 stretch", "2 cycles of 1.50 s")
    assert words.lane_head(pattern("A", 2, 2, kind="acyclic", period=10)) == ("2 stretches", "of 10.00 s")


def test_a_bar_says_all_there_is() -> None:
    both = pattern("C", 2, 3)
    assert words.stretch_name(both, 1) == "Pattern C, stretch 2 of 2, 20.0 to 30.0 seconds"
    tip = "C, 2 of 2 · 0:20.0 to 0:30.0 · 1 cycle of 1.50 s · confidence 0.82: cycles are alike"
    assert words.stretch_tip(both, 1) == tip
    assert "cycle of" not in words.stretch_tip(pattern("A", 2, 2, kind="acyclic"), 0)


def test_cycles_stand_in_their_stretch() -> None:
    both = pattern("C", 2, 3)
    assert words.cycles_in(both, 0) == [(0.0, 1.5), (1.5, 3.0)]
    assert words.cycles_in(both, 1) == [(20.0, 21.5)]
    assert words.cycles_in(pattern("A", 2, 2, kind="acyclic"), 0) == []


def test_an_empty_result_says_only_what_is_true() -> None:
    text = words.empty_text(found(miss="The nearest comes within 9 cm", min_duration_s=0.5), still=False)
    assert text == (
        "No stretch of half a second or longer comes back. The nearest comes within 9 cm. "
        "You can still play it and compare any two moments."
    )
    assert "stillness does not count" in words.empty_text(found(), still=True)
    held = found()
    held = held.replace(parameters=held.parameters | {"stillness": True})
    assert "stillness" not in words.empty_text(held, still=True)
    assert words.empty_text(found(min_duration_s=2.0), still=False).startswith("No stretch of 2 s or longer")
    assert words.empty_text(found(), still=False).startswith("No stretch comes back.")


def test_what_was_looked_for_names_the_shortest_length() -> None:
    assert words.looked_for(found(min_duration_s=0.5)).startswith(
        "Stretches of at least 0.5 s whose postures"
    )
    assert words.looked_for(found()).startswith("Stretches whose postures")


@pytest.mark.parametrize(
    ("seconds", "said"), [(0.4, "this second"), (5.8, "these 6 seconds"), (600, "these 10 minutes")]
)
def test_the_empty_lead_says_how_long(seconds: float, said: str) -> None:
    assert plain(words.lead(found(), seconds)).startswith(f"Nothing in {said} was near")


def test_points_that_could_not_be_turned_are_not_called_made_once() -> None:
    unnamed = Body(("C1", "C2"), np.zeros((2, 2, 3)), np.zeros(2), rate=30, size=1.0, facing_told=False)
    flat = unnamed.replace(positions=np.zeros((2, 2, 2)), unit="px")
    ahead = unnamed.replace(facing_told=True)
    assert words.as_they_stand(found(), ahead) == ""
    assert words.as_they_stand(found(invariant_to=["place", "yaw"]), unnamed) == ""
    told = words.as_they_stand(found(), unnamed)
    assert "compared as they stand" in told
    assert told.endswith("--map FILE.")
    assert "--map" not in words.as_they_stand(found(invariant_to=["place"]), flat)
    assert told in words.empty_text(found(), still=False, remark=told)


def test_an_empty_lead_claims_no_more_than_was_seen() -> None:
    swing = np.sin(np.arange(90) / 9)[:, None, None] * np.ones((1, 10, 3))
    body = Body(tuple(f"C{k}" for k in range(10)), swing, np.zeros(90), rate=30, size=1.0)
    near = "Nothing in these 3 seconds was near and clear enough to count as a repeat"
    holes = swing.copy()
    holes[:45, :8] = np.nan
    for positions, said in (
        (swing, f"{near}."),
        (holes, f"{near}; 40% of the positions are unseen, which may be why."),
        (swing / 1000, "Nothing moves here."),
        (swing[:1], "One frame: nothing can come back in it."),
        (np.full_like(swing, np.nan), "No point is ever seen."),
    ):
        person = body.replace(positions=positions, facing=np.zeros(len(positions)))
        assert plain(words.lead(found(), 3.0, person)) == said


def test_no_sentence_shouts_or_boasts() -> None:
    said = [
        words.title(found()),
        words.empty_text(found(), still=True),
        words.looked_for(found()),
        words.stretch_tip(pattern("A", 1, 3), 0),
    ]
    for word in ("!", "insight", "powerful", "oops", "sorry"):
        assert not any(word in sentence.lower() for sentence in said)


def test_times_that_differ_are_told_from_the_shortest_to_the_longest() -> None:
    uneven = pattern("A", 2, 2, kind="acyclic", period=8.0).replace(
        occurrences=Segmentation([0, 200], [100, 260], rate=10.0)
    )
    assert lengths.lasts(uneven) == "6.0–10.0 s"
    assert plain(words.lead(found(uneven), 60)) == "[A] comes back twice, 6.0–10.0 s each."
    assert words.lane_head(uneven) == ("2 stretches", "of 6.0–10.0 s")
    assert lengths.lasts(pattern("A", 1, 4)) == "1.50 s"


def test_the_page_tells_one_length_of_a_cycle() -> None:
    """The median in the head of a lane and in the line of its one stretch, also where one cycle is longer."""
    one = pattern("A", 1, 3)
    longer = one.replace(occurrences=Segmentation([0, 15, 30], [15, 30, 48], rate=10.0))
    assert words.lane_head(longer)[1] == "3 cycles of 1.50 s"
    assert " · 3 cycles of 1.50 s · " in words.stretch_tip(longer, 0)


def test_patterns_that_overlap_say_so() -> None:
    assert lengths.overlap(found(pattern("A", 2, 4))) == ""
    assert lengths.overlap(found(pattern("A", 2, 4), pattern("B", 1, 2))).startswith("These patterns overlap")
