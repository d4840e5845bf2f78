import numpy as np

from grounding.pictures.canvas import Canvas
from grounding.pictures.labels import name_beside, name_on


def square(x, y, edge):
    return np.array([[x, y], [x + edge, y], [x + edge, y + edge], [x, y + edge]], dtype=float)


def drawn(canvas):
    return np.argwhere((np.asarray(canvas.finished()) < 250).any(axis=2))[:, ::-1]


def test_a_name_is_on_its_object_where_there_is_room():
    canvas = Canvas(200, 200)
    assert name_on(canvas, "b1", square(50, 50, 40), (255, 255, 255))
    found = drawn(canvas)
    assert ((found >= 50) & (found <= 90)).all()


def test_a_long_name_has_no_room():
    assert not name_on(Canvas(200, 200), "a name of some length", square(50, 50, 40), (255, 255, 255))


def test_a_name_keeps_off_the_objects_around():
    corners = {"here": square(80, 80, 40), "below": square(80, 122, 40), "above": square(80, 38, 40)}
    canvas = Canvas(300, 200)
    name_beside(canvas, ["here"], corners)
    found = drawn(canvas)
    assert len(found)
    assert (found[:, 0] > 120).all()
