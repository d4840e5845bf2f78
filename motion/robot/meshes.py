"""The robot's DAE meshes as files that MuJoCo loads quickly: visuals decimated, collision shapes as convex hulls."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from motion.errors import RobotUnavailable


def load_mesh(path: Path) -> Any:
    """A DAE file as one mesh in metres, with vertices in the same place merged."""
    import trimesh

    try:
        mesh = trimesh.load(path, force="scene").to_geometry()
    except Exception as error:
        raise RobotUnavailable(f"the mesh {path.name} could not be read: {error}") from error
    return trimesh.Trimesh(mesh.vertices, mesh.faces, process=True)


def write_hull(source: Path, target: Path) -> None:
    """Writes the convex hull of a mesh, the shape that MuJoCo collides with in any case, as binary STL."""
    load_mesh(source).convex_hull.export(target, file_type="stl")


def write_visual(source: Path, target: Path, keep: float) -> None:
    """Writes a mesh with about the fraction `keep` of its faces as binary STL; small meshes keep more."""
    import fast_simplification

    mesh = load_mesh(source)
    vertices, faces = np.asarray(mesh.vertices, np.float32), np.asarray(mesh.faces, np.int32)
    aim = max(int(len(faces) * keep), 400)
    if aim < len(faces):
        vertices, faces = fast_simplification.simplify(vertices, faces, target_reduction=1 - aim / len(faces), agg=3)
    type(mesh)(vertices, faces, process=False).export(target, file_type="stl")
