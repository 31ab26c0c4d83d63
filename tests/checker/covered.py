"""What these programs say nothing about."""


class NotCovered(Exception):
    """A scene that is not covered, and why."""
