// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "haptics/session/mechanism/MechanismBodies.h"
#include "haptics/session/path/PathSettings.h"
#include "haptics/session/scene/FeltField.h"
#include "haptics/session/soft/BodyMaker.h"

namespace palpate
{

/// Where the hand is at a time; each sample is one tick.
struct PathSample
{
  double time_s = 0.0; ///< increasing
  Pose hand_W;         ///< [u]
};

/// Faces or curves of one source of data.
struct PathSurface
{
  std::string name;                                  ///< of the data
  std::shared_ptr<const TriangleMesh> mesh;          ///< of curves: see segmentsOf()
  std::shared_ptr<const MaterialFields> fields = {}; ///< of its vertices, stiffness [N/m], or null
  bool curves = false;
  std::vector<std::size_t> holeEdges = {}; ///< see SurfaceInput
  std::string materialNote = {};           ///< the arrays that are used
  std::string materialProblem = {};        ///< why an array could not be used; "": none was asked for, or all were used
  double density_kg_per_m3 = 0.0;          ///< of a loose body; 0: it is fixed
};

struct PathField
{
  std::string name;
  std::shared_ptr<const FieldSource> source;
  FieldEnds ends{ 1.0, 0.0 }; ///< of its scalar
  double noSpeed = 0.0;       ///< see FieldPlan; below FieldFullSpeed
};

struct PathTool
{
  std::string name;
  std::shared_ptr<const TriangleMesh> mesh; ///< in the frame of the hand
};

struct PathBody
{
  std::string name;
  std::shared_ptr<const SoftBodyInput> input;
};

struct PathMechanism
{
  std::string name;
  std::shared_ptr<const MechanismInputs> inputs;
};

/// The input of a path that is known before. A mechanism is felt alone; a tool feels surfaces and a soft body. Where a
/// surface is loose, a unit is 1 / {Scale} metres.
struct PathInputs
{
  SettingStore settings = pathSettings();
  std::vector<PathSample> path; ///< one sample at least
  std::vector<PathSurface> surfaces;
  std::optional<PathField> field;
  std::optional<PathTool> tool;
  std::optional<PathBody> body;
  std::optional<PathMechanism> mechanism;
};

} // namespace palpate
