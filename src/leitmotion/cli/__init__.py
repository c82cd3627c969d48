"""What a person types at a shell: ``leitmotion VERB INPUT… [-o OUT] [--json]``, one verb a file.

Every verb loads, calls the façade, and saves or prints. What verbs share, in the order in which it is used:

- :mod:`program`, the verbs and the exit statuses; :mod:`options`, what every verb takes;
- :mod:`inputs`, which recordings an argument means; :mod:`batch`, one after another, the failures in their place;
- :mod:`recordings`, what an input holds; :mod:`finding`, what recurs in it; :mod:`progress`, what is going on;
- :mod:`targets`, :mod:`converting`, :mod:`pool`, :mod:`ledger`, what is converted where, several at a time;
- :mod:`documents`, the JSON contract; :mod:`printing`, for a person; :mod:`outputs` and :mod:`pages`, into files;
- :mod:`failures`, what went wrong.
"""

from leitmotion.cli.program import main

__all__ = ["main"]
