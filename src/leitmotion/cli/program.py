"""The program: its verbs, brought when they are asked for, and what each ending tells the shell.

Conventions
-----------
Exit 0: done, and finding nothing is done. 1: the data says no, in one sentence. 2: wrong usage. 130: stopped by
Ctrl-C. No traceback is shown unless asked for.
"""

from __future__ import annotations

import difflib
import importlib
import io
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NoReturn

import click

from leitmotion import __version__
from leitmotion.cli.failures import STOPPED, explain

VERBS = {
    "demo": "Show what Leitmotion does, on a practice session or a recording.",
    "info": "Tell what a recording holds, and what is wrong with it.",
    "convert": "Write recordings in another format, whole folders at once.",
    "repair": "Mend a recording by remedies that have a name.",
    "calibrate": "Tell from labelled pairs how near alike postures are.",
    "similarity": "Compare every moment of a recording with every other.",
    "patterns": "Find what recurs in a recording.",
    "symmetry": "Tell how a movement treats the two sides, and how it returns.",
    "dynamics": "Compute momentum and energy of a body in motion.",
    "graph": "Draw the states that movements pass through, and the paths between them.",
    "evaluate": "Judge an answer by what a person saw.",
    "report": "Write the page that shows what recurs.",
}
"""Each verb and what it does; ``cli/VERB.py`` holds the command of that name."""


class Program(click.Group):
    """A group whose commands are imported on demand, so that ``--help`` is instant."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Name the verbs, in the order of the street."""
        return list(VERBS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Bring a verb's command."""
        if cmd_name not in VERBS:
            return None
        module = importlib.import_module(f"leitmotion.cli.{cmd_name}")
        command: click.Command = getattr(module, cmd_name)
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Find the verb that was typed, or say which one is near."""
        verb = args[0]
        if verb not in VERBS and not verb.startswith("-") and not ctx.resilient_parsing:
            raise click.UsageError(_no_such_verb(verb), ctx)
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the verbs without importing them."""
        with formatter.section("Verbs"):
            formatter.write_dl(list(VERBS.items()))

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Take no argument at all as a request for help."""
        return super().parse_args(ctx, args or ["--help"])

    def main(
        self,
        args: Sequence[str] | None = None,
        prog_name: str | None = None,
        complete_var: str | None = None,
        standalone_mode: bool = True,
        **extra: Any,
    ) -> Any:
        """Run, and end with the exit status of the house."""
        if not standalone_mode:
            return super().main(args, prog_name, complete_var, standalone_mode=False, **extra)
        return self._run_and_exit(args, prog_name, complete_var, **extra)

    def _run_and_exit(
        self, args: Any, prog_name: str | None, complete_var: str | None, **extra: Any
    ) -> NoReturn:
        if isinstance(
            sys.stdout, io.TextIOWrapper
        ):  # a file's name may be no text in the terminal's encoding
            sys.stdout.reconfigure(errors="backslashreplace")
        try:
            status = super().main(args, prog_name, complete_var, standalone_mode=False, **extra)
            if sys.stdout is not None:  # it is where the shell has closed it
                sys.stdout.flush()
        except click.ClickException as error:
            error.show()
            status = error.exit_code
        except (KeyboardInterrupt, click.Abort):
            click.echo("Stopped.", err=True)
            status = STOPPED
        except BrokenPipeError:
            # The reader of our output has gone; nothing more can be said to it, at exit either.
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            status = 1
        except Exception as error:
            click.echo(explain(error).sentence, err=True)
            status = 1
        sys.exit(status if isinstance(status, int) else 0)


def _no_such_verb(verb: str) -> str:
    if Path(verb).exists():
        return f"{verb!r} is a file, not a verb. To see what recurs in it: leitmotion report {verb}"
    near = difflib.get_close_matches(verb.lower(), VERBS, n=1, cutoff=0.5)
    hint = f"Did you mean {near[0]!r}?" if near else f"The verbs are {', '.join(VERBS)}."
    return f"There is no verb {verb!r}. {hint}"


@click.command(
    cls=Program,
    subcommand_metavar="VERB INPUT...",
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog="An INPUT is a file, a folder (searched through), a window of a file as in dance.bvh[12s:45s], "
    "or - for standard input. Nothing leaves this machine.",
)
@click.version_option(__version__, prog_name="leitmotion", message="%(prog)s %(version)s")
def main() -> None:
    """Find what recurs in human motion."""
