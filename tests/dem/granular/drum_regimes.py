#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""The regimes of a drum by its Froude number w^2 R / g: drum_regimes.py HGRID [FOLDER]. A drum whose wall is a mesh with
teeth, 25 radii of a sphere in radius and 6 deep, turns with 510 rough spheres in it; its ends are smooth. FOLDER keeps
the runs.

What is seen is told by numbers, each the mean over the second half of the run:
  flight   share of spheres that touch nothing for as long as a fall from rest by a diameter takes: gravity alone has
           changed their velocity
  speed    angular momentum of the spheres about the axis over that of going round with the drum
  height   of their centre over the axis, over the radius of the drum
  slope    of the surface of those that are not in flight, in degrees
  bend     by how much its upper half is steeper than its lower half, in degrees

Centrifuging is a speed above 0.9; else cataracting a flight above 0.01; else cascading a slope above 32 degrees, 5 more
than the angle of friction of the spheres; else rolling. Mellmann (Powder Technol. 118 (2001) 251) has rolling at Froude
numbers from 1e-4 to 1e-2, cascading from 1e-3 to 1e-1, cataracting from 0.1 to 1, centrifuging from 1 on. Exits with 1
unless the drum does so, and a drum without teeth, whose flat sides only rub, does not centrifuge."""

import math
import os
import sys
import tempfile

import states
import stl

RADIUS, DEPTH, TEETH, GRAVITY, LOOK = 25.0, 6.0, 36, 1.0, 2.0
# Froude number, turns of the drum, height of its teeth, the regimes it may show; any between two of them.
CASES = (
    (0.003, 0.6, 1.0, ("rolling",)),
    (0.05, 2, 1.0, ("cascading",)),
    (0.2, 3, 1.0, ("cascading", "cataracting")),
    (0.7, 6, 1.0, ("cataracting",)),
    (1.0, 6, 1.0, ("cataracting", "centrifuging")),
    (2.0, 8, 1.0, ("centrifuging",)),
    (2.0, 8, 0.0, ("rolling", "cascading", "cataracting")),
)
SCENE = """
[[particles]]
radius = 1
lattice = {{ counts = [17, 3, 10], spacing = 2.02, origin = [-16.2, 1, -14], jitter = 0.005 }}
material = "grain"

[[material]]
name = "grain"
stiffness = 4e4
[[material]]
name = "glass"
stiffness = 4e4
[[pair]]
materials = ["grain", "glass"]
friction = 0

[[wall]]
name = "front"
point = [0, 0, 0]
normal = [0, 1, 0]
material = "glass"
[[wall]]
name = "back"
point = [0, {depth}, 0]
normal = [0, -1, 0]
material = "glass"
[[wall]]
name = "drum"
file = "{mesh}"
axis = [0, 1, 0]
turning = {turning}

[contact]
stiffness = 4e4
[dissipation]
restitution = 0.5
[friction]
coefficient = 0.5
[gravity]
acceleration = [0, 0, -{gravity}]
[time]
end = {end}
steps_per_contact = 20
[output]
every = {every}
energy = {end}
"""


def in_flight(spheres, later):
    """Those of a picture that touch nothing until the next one."""
    change = {"velocity_x": 0, "velocity_y": 0, "velocity_z": -GRAVITY * LOOK}
    return {
        i
        for i, (before, after) in enumerate(zip(spheres, later))
        if all(abs(after[key] - before[key] - by) < 1e-3 for key, by in change.items())
    }


def rise(tops, first, last):
    """Of the line through the mean tops from one place to another, in degrees."""
    points = [(t, sum(heights) / len(heights)) for t, heights in tops.items() if first <= t <= last]
    return math.degrees(math.atan(states.slope(*zip(*points))))


def surface(looks, lean):
    """Slope and bend of the highest spheres of strips across the direction `lean` from the middle of the drum down to
    that of the bed; looks: of each picture the spheres, and who is in flight."""
    tops = {}
    for spheres, flying in looks:
        highest = {}
        for i, sphere in enumerate(spheres):
            # They are carried up where x is negative.
            along = -sphere["x"] * math.cos(lean) + sphere["z"] * math.sin(lean)
            over = sphere["x"] * math.sin(lean) + sphere["z"] * math.cos(lean) + 1
            strip = 2 * math.floor(along / 2) + 1
            if i not in flying:
                highest[strip] = max(highest.get(strip, -RADIUS), over)
        for strip, top in highest.items():
            tops.setdefault(strip, []).append(top)
    far = 0.7 * RADIUS
    return math.degrees(lean) + rise(tops, -far, far), rise(tops, 0, far) - rise(tops, -far, 0)


def seen(output, turning):
    """Flight, speed, height, slope and bend."""
    pictures = [spheres for _, spheres in states.pictures(output)]
    # The last is at the end, whenever that is.
    looks = [(now, in_flight(now, later)) for now, later in zip(pictures, pictures[1:-1])][len(pictures) // 2 :]
    momentum = inertia = x = z = count = 0
    for spheres, _ in looks:
        count += len(spheres)
        momentum += sum(s["z"] * s["velocity_x"] - s["x"] * s["velocity_z"] for s in spheres)
        inertia += sum(s["x"] ** 2 + s["z"] ** 2 for s in spheres)
        x += sum(s["x"] for s in spheres)
        z += sum(s["z"] for s in spheres)
    flight = sum(len(flying) for _, flying in looks) / count
    return (flight, momentum / inertia / turning, z / count / RADIUS, *surface(looks, math.atan2(-x, -z)))


def regime(flight, speed, slope):
    if speed > 0.9:
        return "centrifuging"
    if flight > 0.01:
        return "cataracting"
    return "cascading" if slope > 32 else "rolling"


def turn(hgrid, folder, froude, turns, tooth):
    turning = math.sqrt(froude * GRAVITY / RADIUS)
    end = 2 * math.pi * turns / turning
    name = "froude-%g%s" % (froude, "" if tooth else "-smooth")
    words = {"depth": DEPTH, "turning": turning, "gravity": GRAVITY, "end": end, "every": LOOK, "mesh": name + ".stl"}
    start = os.path.join(folder, name)
    with open(start + ".stl", "w") as mesh, open(start + ".toml", "w") as scene:
        mesh.write(stl.as_stl(stl.toothed_drum(RADIUS, DEPTH, TEETH, tooth)))
        scene.write(SCENE.format(**words))
    states.run(hgrid, start + ".toml", start)
    return seen(start, turning)


def main():
    hgrid = os.path.abspath(sys.argv[1])
    good = True
    with tempfile.TemporaryDirectory() as passing:
        folder = sys.argv[2] if len(sys.argv) > 2 else passing
        os.makedirs(folder, exist_ok=True)
        print("Froude  teeth  flight   speed  height   slope    bend")
        for froude, turns, tooth, expected in CASES:
            flight, speed, height, slope, bend = turn(hgrid, folder, froude, turns, tooth)
            name = regime(flight, speed, slope)
            good = good and name in expected
            print("%6g  %5g  %6.3f  %6.3f  %6.3f  %6.1f  %6.1f  %s (%s)" %
                  (froude, tooth, flight, speed, height, slope, bend, name, " or ".join(expected)), flush=True)
    sys.exit(not good)


if __name__ == "__main__":
    main()
