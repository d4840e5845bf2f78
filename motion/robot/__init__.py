"""The robot from its description: Baxter's URDF, its numbers, its models, its arms, and where they are.

`recipe` holds the numbers, `description` and `meshes` make the files that `build` writes, `load` gives the robot.
"""
