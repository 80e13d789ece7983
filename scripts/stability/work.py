"""Runs rows, whatever happens inside them."""
import tempfile
import time

from .bench import Bench
from .row import Figure, Result


def run_row(row, programs, length):
    """In a folder of its own. A row that cannot be measured fails."""
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        try:
            figures = row.run(Bench(programs, folder), length)
        except Exception as error:  # the report goes on and shows it
            figures = [Figure(f"{type(error).__name__}: {error}", False)]
    return Result(row, figures, time.monotonic() - start)
