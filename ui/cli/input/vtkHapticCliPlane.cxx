// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliPlane.h"

#include <sstream>

#include "vtkHapticCliProblem.h"
#include "vtkHapticReaders.h"

palpate::SurfaceInput vtkHapticCliWallsOf(const std::string& file, const vtkHapticCliSurface& surface, double radius_u)
{
  if (surface.Input.mesh)
  {
    throw vtkHapticCliProblem(file +
                              ": a plane world is made of lines and this file has polygons; take their edges or a " +
                              "slice of them (Feature Edges, Slice), or leave out --two-d");
  }
  palpate::LineSurface walls = palpate::wallsAcross({ file, surface.Lines }, radius_u, palpate::Pose());
  if (!walls.input)
  {
    throw vtkHapticCliProblem(file + ": a plane world lies in the plane z = 0: " + walls.problem +
                              "; curves in space are touched as tubes (--line-radius, without --two-d)");
  }
  walls.input->name = file; // all that is touched of it
  return *walls.input;
}

std::shared_ptr<const palpate::Scene> vtkHapticCliBuildPlane(const std::vector<std::string>& files, double radius_u)
{
  std::vector<palpate::SurfaceInput> inputs;
  for (const std::string& file : files)
  {
    if (vtkHapticIsImageFile(file))
    {
      throw vtkHapticCliProblem(file + ": --two-d feels lines, not images; make curves of it first (Image Curves)");
    }
    inputs.push_back(vtkHapticCliWallsOf(file, vtkHapticCliReadSurface(file, std::nullopt, {}, true), radius_u));
  }
  return vtkHapticCliBuild(inputs);
}

void vtkHapticCliCheckPlanePath(const std::string& file, const std::vector<vtkHapticCliPathRow>& path)
{
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    if (path[i].Pose_W.p.z() != 0.0)
    {
      std::ostringstream text;
      text << file << ": row " << i + 1 << " has z = " << path[i].Pose_W.p.z()
           << "; the hand must be in the plane z = 0";
      throw vtkHapticCliProblem(text.str());
    }
  }
}
