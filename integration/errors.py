"""Errors of integration, as one family: each message names what was wrong and what would be right."""

from __future__ import annotations


class IntegrationError(Exception):
    """Root of every error that integration raises on purpose."""


class UsageError(IntegrationError):
    """The command line, or a file that it names, is not right."""


class NoPlan(IntegrationError):
    """A grounded action cannot be turned into a verified plan.

    Attributes:
        objects: ids of the objects that it is about.
        reason: a word for programs: the name of motion's error, or "hands", "destination", "room", "unstable".
    """

    def __init__(self, message: str, objects: tuple[str, ...], reason: str) -> None:
        self.objects = objects
        self.reason = reason
        super().__init__(message)


class VideoUnavailable(IntegrationError):
    """No encoder for the kind of video that was asked for is installed."""


class ViewerUnavailable(IntegrationError):
    """There is no screen to show the simulation on."""
