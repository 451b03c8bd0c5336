// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "haptics/compliance/body/SoftBody.h"
#include "haptics/compliance/map/Patches.h"

namespace palpate
{

/// The border of a soft body as it is touched: each vertex is at its node, and yields elastically to a pressing contact
/// with a patch of nodes. In the order of cleanMesh(), so that a tree of it numbers its vertices alike.
struct SoftSurface
{
  std::vector<std::uint32_t> vertices;                 ///< nodes of the body at the border's corners
  std::vector<Vec3> rest_W;                            ///< of each [u]
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< of its own vertices
  std::vector<std::vector<std::uint32_t>> neighbours;  ///< along edges
  std::vector<double> edge_u;                          ///< mean length of the edges at each vertex
  std::vector<double> patch_u;                         ///< radius of its patch
  std::vector<double> stiffness;                       ///< E* = E / (1 - nu^2) of the material below [N/u^2]
  double poisson = 0.0;                                ///< of the body
  std::shared_ptr<const BorderFaces> border;           ///< between the body's nodes
  SurfaceMap map;

  /// Positions of vertices without contact: with the map of their patches corners would be rounded off.
  [[nodiscard]] std::vector<Vec3> placesOf(const SoftBody& body) const
  {
    return this->placesOf(body.displacement(), body.displacement());
  }
  /// Positions of vertices under contact: from the displacements of the nodes without the contact, and with it.
  [[nodiscard]] std::vector<Vec3> placesOf(const Eigen::VectorXd& atRest, const Eigen::VectorXd& pressed) const;
};

/// The nodes in the patches of a surface, mid-edge nodes included: nearest to a point first.
[[nodiscard]] std::vector<std::uint32_t> borderNodesFrom(const SoftSurface& surface, const Vec3& place_W);

/// `mesh`: the checked tetrahedra of the body; `edges`: the patches' radius in lengths of edges.
[[nodiscard]] SoftSurface makeSoftSurface(const SoftBody& body, const TetraMesh& mesh, double edges = patchEdges);

} // namespace palpate
