// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/core/Outcome.h"
#include "haptics/mechanism/Mechanism.h"
#include "haptics/session/mechanism/LooseSources.h"

namespace palpate
{

class Scene;
class SurfaceTree;
struct Surface;

/// The surfaces of a scene beside a soft body, as bodies that a mechanism of a hand has: of the kind World, or of the
/// kind Rigid with a mass where they are loose. Each keeps its own friction where its material has one; all are rigid,
/// whatever stiffness their materials have, as they are for a tool without a soft body.
class SurfacesBeside
{
public:
  static constexpr std::size_t most = Mechanism::mostBodies - 2; ///< beside the tool and the soft body

  /// Of a scene, null: of none, all surfaces but that of the name `own`. Only surfaces that are others than before are
  /// made anew. Whether any is, or is not there any more. Takes milliseconds where a surface is large.
  bool follow(const Scene* scene, const std::string& own, const LooseSources& loose = {});

  [[nodiscard]] const std::vector<MechanismBody>& bodies() const noexcept { return this->bodies_; }
  /// The first surface that no mechanism can have, whether that was to be loose, and why; "": all can be touched.
  [[nodiscard]] const std::string& refused() const noexcept { return this->refused_; }
  [[nodiscard]] bool refusedLoose() const noexcept { return this->refusedLoose_; }
  [[nodiscard]] const std::string& reason() const noexcept { return this->reason_; }

private:
  struct LooseAs
  {
    double density_kg_per_m3 = 0.0;
    double unit_m = 0.0;
    Vec3 gravity_m_per_s2 = Vec3::Zero();

    friend bool operator==(const LooseAs&, const LooseAs&) = default;
  };
  /// A surface of the scene, as far as its body depends on it.
  struct Source
  {
    std::string name;
    std::shared_ptr<const SurfaceTree> tree;
    Pose pose_WS;
    double friction = 0.0; ///< kinetic, of the material; below 0: none
    bool bends = false;
    std::optional<LooseAs> loose;

    [[nodiscard]] static Source of(const Surface& surface, const LooseSources& loose);
    [[nodiscard]] bool isSame(const Source& other) const noexcept;
  };

  using Made = Outcome<MechanismBody>;
  [[nodiscard]] static Made standing(const Source& source);
  [[nodiscard]] static Made loose(const Source& source);
  /// `known`: its body, made before; null: none.
  void take(const Source& source, const MechanismBody* known);

  std::vector<Source> sources_;
  std::vector<MechanismBody> bodies_; ///< of these, in their order, without any after the first that is refused
  std::string refused_;
  bool refusedLoose_ = false;
  std::string reason_;
};

} // namespace palpate
