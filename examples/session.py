"""One robot, many goals: what is held stays held, and everything can be undone."""

import threading

from integration import Place, Progress, Session, load_scene

stop = threading.Event()  # set from any thread, it makes the arm brake


def show(progress: Progress) -> None:
    """Called while the robot works."""
    if progress.fraction > 0.9 and progress.step == "home":
        print(f"  {progress.step}: {progress.fraction:.0%} after {progress.simulated:.1f} s")


with Session(load_scene("four")) as session:
    print(session.do("pick up the nearest block", cancel=stop).message)
    print(", ".join(str(fact) for fact in session.facts if fact.name == "holding"))
    print(session.do("put it behind the red block", on_progress=show).message)
    print(session.do(Place("b2", (0.55, 0.3, 0.736))).message)
    while session.can_undo:
        print("undone:", session.undo().message)
