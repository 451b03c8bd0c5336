// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/element/StrainPoints.h"

namespace palpate
{

/// Loads that the corners of a surface bear [N], three numbers a node, as the tractions do that they stand for: where
/// tetrahedra have nodes halfway, a traction is mostly on those, and forces on the corners alone would dimple the
/// surface. Of each triangle whose corners all bear a load the traction is the linear one that does the loads' work on
/// linear displacements, so that force and moment are kept. Other loads stay: those of single corners, and those of all
/// corners of a tetrahedron, which are a weight.
void spreadTractions(const StrainPoints& points, const TetraMesh& mesh, Eigen::VectorXd& load_N);

} // namespace palpate
