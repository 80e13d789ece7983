"""How far the work is, and how long it may still take."""
import sys
import time


class Progress:
    """A line that is written over on a terminal; elsewhere a line now and then."""

    def __init__(self, stream=sys.stderr):
        self.stream, self.terminal = stream, stream.isatty()
        self.total = self.done = 0.0
        self.began = time.monotonic()
        self.next = self.began

    def expect(self, seconds):
        """Of work in all, as it was estimated."""
        self.total = seconds

    def add(self, seconds):
        """Of the estimate is done."""
        self.done += seconds

    def skip(self, seconds):
        """Of the estimate need not be done: an earlier start has done it, or a failure ends it."""
        self.total -= seconds

    def left(self):
        """Seconds, by how the estimate has done so far; None at the beginning."""
        elapsed = time.monotonic() - self.began
        if self.done < 0.02 * self.total or self.done <= 0:
            return None
        return elapsed * max(0.0, self.total - self.done) / self.done

    def say(self, what):
        now = time.monotonic()
        if not self.terminal and now < self.next:
            return
        self.next = now + 15
        left = self.left()
        part = 100 * self.done / self.total if self.total else 0
        line = f"{min(part, 99):3.0f} %  {what}"
        if left is not None:
            line += f"; about {left / 60:.0f} min left" if left > 90 else f"; about {left:.0f} s left"
        self.stream.write(f"\r\033[K{line}" if self.terminal else f"{line}\n")
        self.stream.flush()

    def end(self):
        if self.terminal:
            print("\r\033[K", end="", file=self.stream, flush=True)
