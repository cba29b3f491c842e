import os
import random
from fractions import Fraction

import pytest

import minksum


@pytest.fixture(scope="session")
def program():
    """The native program, with which results are compared; make test-python names it."""
    path = os.environ.get("MINKSUM_PROGRAM")
    if not path:
        pytest.skip("MINKSUM_PROGRAM does not name the program")
    return path


def random_ring(rng, vertices, size=20, numbers=Fraction):
    """A ring that may cross itself, with small exact coordinates."""
    denominator = rng.choice([1, 1, 3, 10])
    return [
        (
            numbers(rng.randrange(-size, size)) / denominator,
            numbers(rng.randrange(-size, size)) / denominator,
        )
        for _ in range(vertices)
    ]


def random_geometry(rng, vertices=8):
    return minksum.resolve([random_ring(rng, rng.randrange(3, vertices))])[0]


@pytest.fixture
def rng():
    return random.Random(20261124)
