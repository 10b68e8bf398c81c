"""Says what is being done, a line a piece of work, to whoever waits."""
import sys
import threading
import time


class Progress:
    def __init__(self, total):
        self.total, self.done = total, 0
        self.start, self.lock = time.monotonic(), threading.Lock()

    def tell(self, work):
        """One more piece is done."""
        with self.lock:
            self.done += 1
            seconds = time.monotonic() - self.start
            print(f"[{self.done:3}/{self.total}] {seconds:5.0f} s  {work}", file=sys.stderr, flush=True)
