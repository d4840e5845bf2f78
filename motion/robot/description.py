"""Baxter's URDF as example-robot-data ships it, and the overlay that makes it simulable.

The overlay is made on the URDF itself, before Pinocchio or MuJoCo see it, so that both read the same robot: it stands
on the floor, both hands have paddle fingers, the fingers have inertias that a finger can have and no mimic joint, and
the 1 mm spheres that stand for "no collision shape" are gone.
"""

from __future__ import annotations

import copy
import xml.etree.ElementTree as ET
from importlib import metadata
from pathlib import Path

from motion.errors import RobotUnavailable
from motion.robot.recipe import Recipe

PACKAGE = "example-robot-data"
FOLDER = "share/example-robot-data/robots/baxter_description"
PREFIX = "package://example-robot-data/robots/baxter_description/"
ROOT_LINK = "stand"


def description_folder() -> Path:
    """The folder of Baxter's description inside the installed package.

    Raises:
        RobotUnavailable: the package, or the robot in it, is not there.
    """
    try:
        distribution = metadata.distribution(PACKAGE)
    except metadata.PackageNotFoundError as error:
        raise RobotUnavailable(f"the package {PACKAGE} is not installed; pip install {PACKAGE}") from error
    for parent in ("cmeel.prefix", "."):
        folder = Path(str(distribution.locate_file(f"{parent}/{FOLDER}")))
        if (folder / "urdf" / "baxter.urdf").is_file():
            return folder
    raise RobotUnavailable(f"{PACKAGE} {distribution.version} has no {FOLDER}; version 6 or later has it")


def overlaid_urdf(folder: Path, recipe: Recipe) -> ET.Element:
    """The URDF of `folder` with the overlay applied; mesh names stay relative to `folder`."""
    robot = ET.parse(folder / "urdf" / "baxter.urdf").getroot()
    for kind in ("transmission", "gazebo"):
        _remove_all(robot, kind)
    for joint in robot.findall("joint"):
        _remove_all(joint, "mimic")
    _stand(robot, recipe.base_height)
    links = {link.get("name", ""): link for link in robot.findall("link")}
    for side in ("l", "r"):
        _replace_shapes(links[f"r_gripper_{side}_finger_tip"], links[f"l_gripper_{side}_finger_tip"])
    for name, link in links.items():
        _remove_dummies(link, recipe.dummy_sphere_radius)
        for part, value in recipe.inertia.items():
            if name.endswith((part, f"{part}_link")):
                _set_inertia(link, value)
    for mesh in robot.iter("mesh"):
        mesh.set("filename", mesh.get("filename", "").removeprefix(PREFIX))
    return robot


def disabled_pairs(folder: Path) -> list[tuple[str, str]]:
    """Pairs of links that the SRDF says can never, or may always, touch."""
    root = ET.parse(folder / "srdf" / "baxter_manipulation.srdf").getroot()
    return [(e.get("link1", ""), e.get("link2", "")) for e in root.findall("disable_collisions")]


def _stand(robot: ET.Element, height: float) -> None:
    """Puts a root link on the floor, `height` metres below the link `base`."""
    joint = ET.Element("joint", name="stand_fixed", type="fixed")
    ET.SubElement(joint, "origin", rpy="0 0 0", xyz=f"0 0 {height}")
    ET.SubElement(joint, "parent", link=ROOT_LINK)
    ET.SubElement(joint, "child", link="base")
    robot.insert(0, ET.Element("link", name=ROOT_LINK))
    robot.append(joint)


def _remove_all(element: ET.Element, kind: str) -> None:
    """Removes the direct children of that kind."""
    for child in element.findall(kind):
        element.remove(child)


def _replace_shapes(link: ET.Element, model: ET.Element) -> None:
    """Gives `link` the visual and collision shapes of `model`."""
    for kind in ("visual", "collision"):
        _remove_all(link, kind)
        for element in model.findall(kind):
            link.append(copy.deepcopy(element))


def _remove_dummies(link: ET.Element, radius: float) -> None:
    """Removes the collision spheres of at most `radius` metres, which stand for "no collision shape"."""
    for collision in link.findall("collision"):
        sphere = collision.find("geometry/sphere")
        if sphere is not None and float(sphere.get("radius", "1")) <= radius:
            link.remove(collision)


def _set_inertia(link: ET.Element, value: float) -> None:
    """Gives `link`, if it has an inertia, the same one about every axis, kg m²."""
    inertia = link.find("inertial/inertia")
    if inertia is None:
        return
    for axis in ("ixx", "iyy", "izz"):
        inertia.set(axis, repr(value))
    for product in ("ixy", "ixz", "iyz"):
        inertia.set(product, "0")
