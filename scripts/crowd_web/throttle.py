"""Limits how often something happens."""
import asyncio


class Throttle:
    """Calls a function with what is offered, at most once in a period: the latest counts, and none of the latest is
    left out. For the thread of the event loop."""

    def __init__(self, period, act):
        self.period, self.act = period, act
        self.loop = asyncio.get_running_loop()
        self.next_at = 0.0
        self.offered = None
        self.timer = None

    def offer(self, *offered):
        self.offered = offered
        if self.timer is None:
            self.timer = self.loop.call_at(self.next_at, self.fire)  # at once, if that is past

    def fire(self):
        self.timer, offered, self.offered = None, self.offered, None
        self.next_at = self.loop.time() + self.period
        self.act(*offered)

    def cancel(self):
        """Forgets what is offered."""
        if self.timer is not None:
            self.timer.cancel()
            self.timer = None
