"""The protocol of patterns, spelled frame by frame: slow and obviously right."""


def label_of(frame, runs, unlabelled):
    """The label that one frame carries, or None; and the run in which it lies."""
    if any(start <= frame < stop for start, stop in unlabelled):
        return None, None
    for k, (start, stop, label) in enumerate(runs):
        if start <= frame < stop and label:
            return label, k
    return None, None


def owner(start, stop, runs, unlabelled):
    """The action to which a stretch belongs, or None."""
    labels = [label_of(frame, runs, unlabelled)[0] for frame in range(start, stop)]
    for label in sorted({label for _, _, label in runs if label}):
        if 10 * labels.count(label) >= 8 * len(labels):
            return label
    return None


def wrong(pairs, runs, unlabelled):
    """How many pairs are wrong."""
    count = 0
    for a0, a1, b0, b1 in pairs:
        a, b = owner(a0, a1, runs, unlabelled), owner(b0, b1, runs, unlabelled)
        count += a is None or b is None or a != b
    return count


def found(action, occurrences, runs, unlabelled, frames):
    """Whether at least half of an action's frames lie in occurrences that belong to it."""
    mine = [span for span in occurrences if owner(*span, runs, unlabelled) == action]
    own = [frame for frame in range(frames) if label_of(frame, runs, unlabelled)[0] == action]
    covered = [frame for frame in own if any(start <= frame < stop for start, stop in mine)]
    return 2 * len(covered) >= len(own)


def link(one, other, pairs, runs, unlabelled):
    """Whether right pairs show one run in another, over at least half of the shorter."""
    lengths = {
        k: sum(label_of(frame, runs, unlabelled)[1] == k for frame in range(*runs[k][:2]))
        for k in (one, other)
    }
    shorter, longer = (one, other) if lengths[one] <= lengths[other] else (other, one)
    shown = set()
    for a0, a1, b0, b1 in pairs:
        if wrong([(a0, a1, b0, b1)], runs, unlabelled):
            continue
        moments = max(a1 - a0, b1 - b0)
        for k in range(moments):
            # the middle of the k-th of equal parts of both stretches
            a = a0 + (2 * k + 1) * (a1 - a0) // (2 * moments)
            b = b0 + (2 * k + 1) * (b1 - b0) // (2 * moments)
            for here, there in ((a, b), (b, a)):
                if (
                    label_of(here, runs, unlabelled)[1] == shorter
                    and label_of(there, runs, unlabelled)[1] == longer
                ):
                    shown.add(here)
    return 2 * len(shown) >= lengths[shorter]
