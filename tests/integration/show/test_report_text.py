from by_hand import grounded, middle_of_the_row, scene

from grounding import GroundedAction, Grounding
from integration.execute.checks import Check
from integration.execute.executor import Executor
from integration.show.report_text import Style, limit, measured, phrase_tree, summary


def test_every_phrase_is_a_line_of_the_tree():
    lines = phrase_tree(middle_of_the_row(), Style(width=110, unicode=False))
    assert "the row of five blocks on the right  " in lines[4]
    assert lines[4].split("->")[1].split() == ["row", "of", "b1", "b2", "b3", "b4", "b5", "0.95"]
    indents = [len(line) - len(line.lstrip()) for line in lines]
    assert indents == [0, 2, 4, 4, 6, 8, 10]


def test_lines_keep_their_width():
    for width in (72, 90, 128):
        for line in phrase_tree(middle_of_the_row(), Style(width=width)):
            assert len(line) <= width


def test_ascii_where_nothing_else_can_be_shown():
    report = Executor().execute(middle_of_the_row(), scene("default"))
    assert summary(report, Style(unicode=False)).isascii()


def test_the_summary_tells_outcome_arm_steps_and_checks():
    text = summary(Executor().execute(middle_of_the_row(), scene("default")), Style())
    for part in ("pick b3", "right", "plan the pick of b3", "lift", "no other block moved", "(at most 5 mm)", "Done"):
        assert part in text


def test_a_question_and_the_readings_are_told():
    actions = (GroundedAction("pick", ("b1",), 0.5), GroundedAction("pick", ("b4",), 0.45))
    grounding = Grounding("x", "ambiguous", alternatives=actions, question="the left one or the right one?")
    text = summary(Executor().execute(grounding, scene("four")))
    assert "the left one or the right one?" in text
    assert "pick b4" in text


def test_measurements_have_their_units():
    check = Check("at_goal", "a", True, 0.00123, 0.005, "m", "a is at its goal")
    assert (measured(check), limit(check)) == ("1.2 mm", "(at most 5 mm)")
    check = Check("held", "a", True, 2.0, 2.0, "s", "a is held", at_least=True)
    assert (measured(check), limit(check, 2)) == ("2.0 s", "(at least 2 s, the worst of 2)")
    assert measured(Check("supported", "a", False, float("inf"), 0.002, "m", "")) == "nowhere"


def test_many_objects_do_not_make_many_lines():
    report = Executor().execute(grounded("clear", "b6", "b7", "b8"), scene("groups"))
    assert len(summary(report).splitlines()) < 30
