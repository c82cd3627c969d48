"""Run the command line: ``python -m leitmotion``."""

from leitmotion.cli import main

if __name__ == "__main__":
    main(prog_name="python -m leitmotion")
