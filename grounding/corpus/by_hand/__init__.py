"""Scenes as people's hands lay them, each with a block to pick up and a placing, for people to write about."""

from grounding.corpus.by_hand.kinds import KINDS, Scene, lay_scene
from grounding.corpus.by_hand.tasks import Task, choose_tasks
from grounding.corpus.by_hand.writing import make_scenes, write_scenes

__all__ = ["KINDS", "Scene", "Task", "choose_tasks", "lay_scene", "make_scenes", "write_scenes"]
