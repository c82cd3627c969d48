"""What can go wrong, said in one sentence.

::

    LeitmotionError
    ├── ParameterError   an argument is not what the function takes
    ├── FormatError      a file is not what its format says it is
    └── DataError        the file is fine, but it cannot answer this question

The message tells what was expected, what was found and where; `remedy` tells what to do.
"""


class LeitmotionError(Exception):
    """Root of every error that Leitmotion raises on purpose.

    Parameters
    ----------
    message : str
        What was expected, what was found, where.
    remedy : str, optional
        What the person can do about it.
    """

    def __init__(self, message: str, *, remedy: str = "") -> None:
        super().__init__(message)
        self.message = message
        self.remedy = remedy

    def __str__(self) -> str:
        return f"{self.message} {self.remedy}".strip()


class ParameterError(LeitmotionError, ValueError):
    """An argument is not what the function takes."""


class FormatError(LeitmotionError, ValueError):
    """A file is not what its format says it is."""


class DataError(LeitmotionError):
    """The recording is readable but cannot answer this question."""
