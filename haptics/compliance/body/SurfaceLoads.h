// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/element/StrainPoints.h"

namespace palpate
{

/// Replaces loads on the corners of a surface [N], three numbers per node, by nodal loads of the tractions that they
/// stand for: in tetrahedra with mid-edge nodes a traction acts mostly on those, and forces on the corners alone would
/// dimple the surface. For each triangle whose corners all bear a load the traction is the linear one that does the
/// loads' work on linear displacements, so that force and moment are kept. Other loads stay: those on single corners,
/// and those on all corners of a tetrahedron, which are a weight.
void spreadTractions(const StrainPoints& points, const TetraMesh& mesh, Eigen::VectorXd& load_N);

} // namespace palpate
