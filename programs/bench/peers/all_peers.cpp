// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The list of peers that CMake found.
#include "programs/bench/peers/peer.hpp"

namespace bench {

std::vector<Peer> all_peers() {
  std::vector<Peer> peers;
#if defined(HGRID_PEER_BOOST)
  add_boost_rtree(peers);
#endif
#if defined(HGRID_PEER_BULLET)
  add_bullet(peers);
#endif
#if defined(HGRID_PEER_CGAL)
  add_cgal(peers);
#endif
#if defined(HGRID_PEER_EMBREE)
  add_embree(peers);
#endif
#if defined(HGRID_PEER_LAMMPS)
  add_lammps(peers);
#endif
#if defined(HGRID_PEER_NANOFLANN)
  add_nanoflann(peers);
#endif
  return peers;
}

}  // namespace bench
