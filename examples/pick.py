"""Pick up the middle block of a row: ground, plan, execute, check, draw."""

from pathlib import Path

from integration.execute.executor import Executor
from integration.run import load_scene
from integration.show.pictures import save_pictures
from integration.show.report_text import summary

world = load_scene("default")  # or the path of a world file
report = Executor(seed=0).run("pick up the middle block in the row of five blocks on the right", world)
report, _ = save_pictures(report, Path("output"))
print(summary(report))
