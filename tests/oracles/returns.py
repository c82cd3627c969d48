"""Where a stretch comes back, by numpy's interpolation and a list of what is known."""

import numpy as np

from leitmotion.discovery.families import overlap


def come_back(stripes, first, last, holds):
    """Spans, the numbers of the stripes that show them, what these hold of the stretch, and the time explained."""
    spans, shown, covered = [(first, last)], [], []
    for k, stripe in enumerate(stripes):
        for here, side in enumerate((stripe.a, stripe.b)):
            start, stop = max(side[0], first), min(side[1], last)
            if stop - start >= holds * (last - first):
                carry = (stripe.forward, stripe.backward)[here]
                span = (carry(start), carry(stop - 1) + 1)
                if all(overlap(span, known) == 0 for known in spans):
                    spans.append(span)
                    shown.append(k)
                    covered.append((start, stop))
    clear = np.mean([stripes[k].contrast for k in shown]) if shown else 0.0
    return spans, shown, covered, clear * sum(stop - start for start, stop in spans)
