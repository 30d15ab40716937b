import pytest

from mpsolve.vehicles.loads import exact_forces
from mpsolve.vibration.balls.image import BallImage
from mpsolve.vibration.image import Image
from mpsolve.vibration.vibrate import checked_places


@pytest.fixture(scope="session")
def balls():
    """The image in balls of a problem under its weights, with 25 digits."""

    def image(problem, places=None):
        own = Image(problem, checked_places(problem, places))
        return BallImage(own, exact_forces(problem.pencil, None), 25)

    return image
