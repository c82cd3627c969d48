"""What a person types at a shell: ``leitmotion VERB INPUT… [-o OUT] [--json]``, one verb a file.

Every verb loads, calls the façade once, and saves or prints. What verbs share: :mod:`inputs` (which recordings an
argument means), :mod:`options` (the options that every verb takes), :mod:`documents` (the JSON contract),
:mod:`batch` (one input after another, the failures in their place), :mod:`progress` and :mod:`outputs`.
"""

from leitmotion.cli.program import main

__all__ = ["main"]
