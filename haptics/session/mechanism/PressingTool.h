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

/// All that the mechanism of a hand follows from.
struct HandAmongBodies
{
  const ToolChoice& tool;
  const SoftChoice& soft;
  const LooseSources& loose;
  double friction = 0.0;        ///< Coulomb's
  double ball_u = 0.0;          ///< radius of the ball that is in the hand without a tool
  const Scene* scene = nullptr; ///< null: there is none
};

/// The chosen tool on the chosen soft body among the other surfaces of the scene, as a mechanism (ToolOnBody.h). Where
/// any surface is loose, the tool or the ball is in that mechanism with a soft body and without one; a point is a ball
/// of a fiftieth of the loose surface's size.
class PressingTool
{
public:
  /// Makes the mechanism anew only where its tool, its body, a surface or the friction is another: soft bodies that
  /// stay are not factored again. A tool that is felt as a ball presses a soft body without a mechanism.
  void follow(const HandAmongBodies& around);
  /// The same mechanism, which begins anew; false: there is none.
  bool beginAgain();

  /// Whether tool and soft body are there, and can be felt together as a mechanism alone.
  [[nodiscard]] bool isPair() const noexcept { return this->has_.pair; }
  /// Without `inputs`: nothing is felt as a mechanism, or that was refused.
  [[nodiscard]] const MechanismChoice& made() const noexcept { return this->made_; }
  /// Radius of the ball that is in the hand of that mechanism; 0: a tool is.
  [[nodiscard]] double ball_u() const noexcept { return this->ball_u_; }
  /// Why the tool cannot press the body, with the remedy; "": it can.
  [[nodiscard]] const std::string& refusal() const noexcept { return this->refusal_; }
  /// Why no surface is loose though some should be, with the remedy; "": all of these are.
  [[nodiscard]] const std::string& looseRefusal() const noexcept { return this->looseRefusal_; }

private:
  /// All that the mechanism was made of, beside the surfaces.
  struct Has
  {
    std::shared_ptr<const ToolMesh> tool;
    std::shared_ptr<const SoftBodyInput> body;
    std::string name; ///< of the soft body
    bool pair = false;
    double friction = 0.0, ball_u = 0.0, unit_m = 0.0;
    std::string loose; ///< the first surface that is to be loose; "": none is
    bool both = false; ///< the soft body is to be loose as well

    friend bool operator==(const Has&, const Has&) = default;
  };
  [[nodiscard]] static Has wanted(const HandAmongBodies& around);
  void make();
  [[nodiscard]] double ballNow_u() const;
  [[nodiscard]] std::string whyNotBeside() const;
  [[nodiscard]] std::string whyNotLoose() const;

  Has has_;
  SurfacesBeside beside_;
  MechanismChoice made_;
  double ball_u_ = 0.0;
  std::string refusal_, looseRefusal_;
};

} // namespace palpate
