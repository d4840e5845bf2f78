"""Pick up the middle block of a row: ground, plan, execute, check, draw."""

from pathlib import Path

from integration.executor import Executor
from integration.pictures import save_pictures
from integration.run import load_scene
from integration.summary import summary

world = load_scene("default")  # or the path of a world file
report = Executor(seed=0).run("pick up the middle block in the row of five blocks on the right", world)
report, _ = save_pictures(report, Path("output"))
print(summary(report))
