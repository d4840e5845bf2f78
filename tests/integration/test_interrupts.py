import contextlib
import os
import signal

import pytest

from integration.interrupts import Interrupts


def test_an_interrupt_that_was_swallowed_is_heeded_later():
    interrupts = Interrupts()
    with interrupts:
        interrupts.heed()
        with contextlib.suppress(BaseException):  # as a compiled module that is being imported does
            os.kill(os.getpid(), signal.SIGINT)
        assert interrupts.seen
        with pytest.raises(KeyboardInterrupt):
            interrupts.heed()


def test_the_handler_of_before_is_put_back():
    before = signal.getsignal(signal.SIGINT)
    with Interrupts():
        assert signal.getsignal(signal.SIGINT) is not before
    assert signal.getsignal(signal.SIGINT) is before
