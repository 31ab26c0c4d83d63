import pathlib

import pytest

root = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def taut():
    """The command, to compare with."""
    path = root / "build" / "release" / "taut"
    if not path.exists():
        pytest.skip("the command has not been built")
    return str(path)
