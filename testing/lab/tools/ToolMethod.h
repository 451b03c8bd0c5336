// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "testing/lab/tools/ToolScenes.h"

namespace palpate::lab
{

/// A method to keep a tool out of a scene. Textbook ones are to compare with and are never shipped.
class ToolMethod
{
public:
  virtual ~ToolMethod() = default;
  /// Goes on towards the hand, once a millisecond.
  virtual void update(const Pose& hand_W) = 0;
  [[nodiscard]] virtual Pose pose_W() const = 0;
};

struct ToolMethodKind
{
  std::string name;
  std::function<std::unique_ptr<ToolMethod>(const ToolScene&)> make;
};

/// Points of the tool among voxels (McNeely, Puterbaugh & Troy 1999) and in a field of distances (Barbic & James 2008),
/// corners of both bodies in the other's field, each as a penalty against a virtual coupling at rest; steps that are as
/// long as distance over largest speed allows, with the contacts that they meet as constraints; and ours.
[[nodiscard]] std::vector<ToolMethodKind> toolMethods();

/// The methods of toolMethods(): one file each.
[[nodiscard]] std::unique_ptr<ToolMethod> voxelTool(const ToolScene& scene, double size_mm);
[[nodiscard]] std::unique_ptr<ToolMethod> pointshellTool(const ToolScene& scene, double spacing_mm);
[[nodiscard]] std::unique_ptr<ToolMethod> penaltyTool(const ToolScene& scene);
[[nodiscard]] std::unique_ptr<ToolMethod> advancedTool(const ToolScene& scene);

} // namespace palpate::lab
