// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "haptics/session/mechanism/MechanismChoice.h"
#include "haptics/session/mechanism/SurfacesBeside.h"
#include "haptics/session/soft/SoftChoice.h"
#include "haptics/session/tool/ToolChoice.h"

namespace palpate
{

/// The chosen tool on the chosen soft body among the other surfaces of the scene, as a mechanism (ToolOnBody.h).
class PressingTool
{
public:
  /// Makes the mechanism anew only where its tool, its body, a surface or the friction is another: soft bodies that
  /// stay are not factored again. `friction`: Coulomb's. A tool that is felt as a ball needs none. `scene`: null where
  /// there is none.
  void follow(const ToolChoice& tool, const SoftChoice& soft, double friction, const Scene* scene);

  /// Whether both are there.
  [[nodiscard]] bool isPair() const noexcept { return this->body_ != nullptr; }
  /// Without `inputs`: there is no pair, or it was refused.
  [[nodiscard]] const MechanismChoice& made() const noexcept { return this->made_; }
  /// Why the tool cannot press the body, with the remedy; "": it can.
  [[nodiscard]] const std::string& refusal() const noexcept { return this->refusal_; }

private:
  void make(const ToolChoice& tool, const SoftChoice& soft);

  std::shared_ptr<const ToolMesh> tool_; ///< of the pair; null: there is none
  std::shared_ptr<const SoftBodyInput> body_;
  double friction_ = 0.0;
  SurfacesBeside beside_;
  MechanismChoice made_;
  std::string refusal_;
};

} // namespace palpate
