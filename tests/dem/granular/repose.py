#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""The angle of repose against friction: repose.py HGRID SCENES. Pours scenes/pile.toml with several coefficients of
friction and of rolling, each with some seeds, and fits a line to either slope at the end. Zhou, Xu, Yu and Zulli (Phys.
Rev. E 64 (2001) 021301) find that the angle grows with both, and hardly depends on stiffness and damping. Exits with 1
unless it grows from the least friction to the most, and with rolling where friction is not small, each by more than
what the seeds scatter, and stiffness and restitution change it by less. Ten minutes on two cores."""

import concurrent.futures
import math
import os
import statistics
import sys
import tempfile

import states

HALF_WIDTH, STRIP = 60.0, 4.0
FRICTIONS, ROLLINGS, SEEDS = (0.05, 0.1, 0.2, 0.5, 0.8), (0.0, 0.2), (1, 2, 3)


def angle(discs):
    """Mean of both slopes, in degrees, without the ends of the plate and the top."""
    tops = {}
    for disc in discs:
        strip, top = math.floor(disc["x"] / STRIP), disc["y"] + disc["radius"]
        if top > tops.get(strip, (0, -1))[1]:
            tops[strip] = (disc["x"], top)
    rises = []
    for side in (-1, 1):
        points = [(x * side, top) for x, top in tops.values() if 0.15 * HALF_WIDTH < x * side < 0.85 * HALF_WIDTH]
        rises.append(-states.slope(*zip(*points)))
    return math.degrees(math.atan(sum(rises) / 2))


def grows(low, high):
    """Of means with their standard deviations: by more than these."""
    return high[0] - low[0] > low[1] + high[1]


def main():
    hgrid, scene = os.path.abspath(sys.argv[1]), os.path.join(sys.argv[2], "pile.toml")

    def pile(folder, settings, seed):
        output = os.path.join(folder, "-".join((*settings, str(seed))))
        states.run(hgrid, scene, output, ["output.every=1e6", "inflow.seed=%d" % seed, *settings])
        return angle(states.pictures(output)[-1][1])

    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:

        def begin(*settings):
            return [pool.submit(pile, folder, settings, seed) for seed in SEEDS]

        def end(piles):
            angles = [one.result() for one in piles]
            return statistics.mean(angles), statistics.stdev(angles)

        begun = {
            (friction, rolling): begin("friction.coefficient=%g" % friction, "rolling.coefficient=%g" % rolling)
            for friction in FRICTIONS
            for rolling in ROLLINGS
        }
        others = [begin(), begin("contact.stiffness=4e4"), begin("dissipation.restitution=0.2")]
        print("degrees, mean of %d seeds and their standard deviation" % len(SEEDS))
        print("friction " + "".join("    rolling %.2f" % rolling for rolling in ROLLINGS))
        found = {}
        for friction in FRICTIONS:
            for rolling in ROLLINGS:
                found[friction, rolling] = end(begun[friction, rolling])
            row = "".join("  %6.1f +- %3.1f" % found[friction, rolling] for rolling in ROLLINGS)
            print("%8.2f " % friction + row, flush=True)
        changed = [end(piles) for piles in others]
        for name, result in zip(("as it is", "4 times as stiff", "restitution 0.2"), changed):
            print("%-16s  %6.1f +- %3.1f" % (name, *result))

    by_friction = all(grows(found[FRICTIONS[0], rolling], found[FRICTIONS[-1], rolling]) for rolling in ROLLINGS)
    by_rolling = all(grows(*(found[friction, rolling] for rolling in ROLLINGS)) for friction in FRICTIONS[3:])
    by_others = any(grows(changed[0], one) or grows(one, changed[0]) for one in changed[1:])
    sys.exit(not (by_friction and by_rolling and not by_others))


if __name__ == "__main__":
    main()
