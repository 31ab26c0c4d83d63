import pathlib
import signal
import subprocess
import sys
import time

import pytest

root = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def taut():
    """The command, to compare with."""
    path = root / "build" / "release" / "taut"
    if not path.exists():
        pytest.skip("the command has not been built")
    return str(path)


@pytest.fixture(scope="session")
def interrupt():
    """A function: what a program prints, and what it says of errors, if Control-C comes half a second after it has printed
    "begun". It has to end within a second."""
    def run(program):
        # A shell that runs the tests in the background has its commands ignore Control-C.
        child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                 preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        try:
            assert child.stdout.readline() == "begun\n"
            time.sleep(0.5)
            assert child.poll() is None, child.stderr.read()
            sent = time.monotonic()
            child.send_signal(signal.SIGINT)
            printed, errors = child.communicate(timeout=30)
            assert time.monotonic() - sent < 1
            return printed, errors
        finally:
            child.kill()
    return run
