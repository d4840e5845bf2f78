"""Put the nearest block on top of a tower, and look at what was checked."""

from integration.execute.executor import Executor
from integration.run import load_scene

report = Executor().run("put the nearest block on top of the tower on the left", load_scene("tower"))

print(report.outcome, "-", report.message)
for check in report.checks:
    print("passed" if check.passed else "failed", check.name, check.object, f"{check.measured:.4f} {check.unit}")
for name in {item.object for item in report.handled}:
    print(name, "is at", report.final_world[name].position.round(3))
