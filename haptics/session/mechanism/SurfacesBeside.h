// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/mechanism/Mechanism.h"

namespace palpate
{

class Scene;
class SurfaceTree;
struct Surface;

/// The surfaces of a scene beside a soft body, as bodies of the kind World that a mechanism of tool and soft body has.
/// Each keeps its own friction where its material has one; all are rigid, whatever stiffness their materials have, as
/// they are for a tool without a soft body.
class SurfacesBeside
{
public:
  static constexpr std::size_t most = Mechanism::mostBodies - 2; ///< beside the tool and the soft body

  /// Of a scene, null: of none, all surfaces but that of the name `own`. Only surfaces that are others than before are
  /// made anew. Whether any is, or is not there any more. Takes milliseconds where a surface is large.
  bool follow(const Scene* scene, const std::string& own);

  [[nodiscard]] const std::vector<MechanismBody>& bodies() const noexcept { return this->bodies_; }
  /// The first surface that no mechanism can have, and why; "": all can be touched.
  [[nodiscard]] const std::string& refused() const noexcept { return this->refused_; }
  [[nodiscard]] const std::string& reason() const noexcept { return this->reason_; }

private:
  /// A surface of the scene, as far as its body depends on it.
  struct Source
  {
    std::string name;
    std::shared_ptr<const SurfaceTree> tree;
    Pose pose_WS;
    double friction = 0.0; ///< kinetic, of the material; below 0: none
    bool bends = false;

    [[nodiscard]] static Source of(const Surface& surface);
    [[nodiscard]] bool isSame(const Source& other) const noexcept;
  };

  /// `known`: its mesh, made before; null: none.
  void take(const Source& source, std::shared_ptr<const SidedSurface> known);

  std::vector<Source> sources_;
  std::vector<MechanismBody> bodies_; ///< of these, in their order, without any after the first that is refused
  std::string refused_;
  std::string reason_;
};

} // namespace palpate
