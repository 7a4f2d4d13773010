# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Several Python threads: grids of their own, and one grid shared."""

import threading
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from oracle import ascending, exact_pairs, polydisperse

import hgrid


class Threads(unittest.TestCase):
    def test_grids_of_their_own(self):
        sets = [polydisperse(seed, 200) for seed in range(111, 117)]

        def search(particles):
            with hgrid.Grid() as grid:
                for _ in range(10):
                    grid.clear()
                    grid.insert(*particles)
                    pairs = grid.query_pairs()
                return ascending(pairs)

        with ThreadPoolExecutor(4) as pool:
            for k, found in enumerate(pool.map(search, sets)):
                with self.subTest(seed=111 + k):
                    np.testing.assert_array_equal(found, exact_pairs(*sets[k]))

    def test_one_grid_shared_by_readers_and_a_writer(self):
        x, r = polydisperse(121, 200)
        wanted = {exact_pairs(x, r).tobytes(), exact_pairs(x[::-1], r).tobytes()}
        with hgrid.Grid(order="id") as grid:
            grid.insert(x, r)

            def read(k):
                if k % 3 == 0:
                    grid.move(x if k % 2 else x[::-1])
                offsets, neighbors = grid.query_neighbors()
                self.assertEqual(offsets[-1], len(neighbors))
                return grid.query_pairs().tobytes()

            with ThreadPoolExecutor(4) as pool:
                found = set(pool.map(read, range(60)))
        self.assertLessEqual(found, wanted)

    def test_a_call_waits_for_a_visit_in_another_thread(self):
        x, r = polydisperse(122, 200)
        answers = []
        with hgrid.Grid() as grid:
            grid.insert(x, r)
            other = threading.Thread(target=lambda: answers.append(grid.stats.particle_count))

            def visit(pairs):
                other.start()
                other.join(timeout=0.2)  # long enough for a call that does not wait to fail or to answer too early
                self.assertEqual(answers, [])
                return True

            grid.visit_pairs(visit)
            other.join()
        self.assertEqual(answers, [200])

    def test_python_runs_during_a_visit(self):
        x, r = polydisperse(123, 200)
        ran = threading.Event()
        with hgrid.Grid() as grid:
            grid.insert(x, r)

            def visit(pairs):
                threading.Thread(target=ran.set).start()
                self.assertTrue(ran.wait(timeout=60))
                return True

            grid.visit_pairs(visit)
        self.assertTrue(ran.is_set())


if __name__ == "__main__":
    unittest.main()
