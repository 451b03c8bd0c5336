// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "haptics/compliance/servo/PressedBody.h"
#include "haptics/mechanism/FoundContacts.h"
#include "haptics/mechanism/found/SidedSurface.h"
#include "haptics/mechanism/servo/MechanismTick.h"

namespace palpate
{

/// The bodies as a finder looks at them.
struct FinderView
{
  Pose held_W;
  double reach_u = 0.0;                     ///< surfaces that are further apart do not meet until the next answer
  double touches_u = 0.0;                   ///< those that are no further apart touch, or will soon
  std::span<const PressedBody* const> soft; ///< in the plan's order
  std::span<const MechanismPress> presses;  ///< the forces under which the soft bodies are bent
};

/// A place where two surfaces meet, or may.
struct NearPlace
{
  FoundContact contact;
  double gap_u = 0.0;  ///< along the normal, the soft body bent as the forces bend it; below 0 they overlap
  double free_u = 0.0; ///< the same to the soft body as it is without forces
};

/// All places of a view where a held mesh may meet one soft body: a vertex of the body before the mesh, a vertex of the
/// mesh before the body, and two edges that cross, of the mesh's those that are sharp. In the order of their features.
[[nodiscard]] std::vector<NearPlace> nearPlaces(
  const SidedSurface& held, const SidedSurface& soft, const PressedBody& body, int soft_i, const FinderView& view);

/// Of those at most so many, one for each `apart_u` and each direction: of those that touch the deepest in the body as
/// it is without forces, or almost the deepest if it was chosen before. `apart_u` is made larger until those that touch
/// have room.
struct ChosenPlaces
{
  std::vector<NearPlace> places;
  double apart_u = 0.0;
  int leftOut = 0;
};
[[nodiscard]] ChosenPlaces choosePlaces(
  const std::vector<NearPlace>& near, std::size_t most, double apart_u, double touches_u, const FoundContacts& before);

/// Finds where the mesh in the hand meets the soft bodies. Beside the tick, at the rate of the bodies' snapshots; the
/// same view gives the same answer on any number of threads. Not real-time safe.
class ContactFinder
{
public:
  /// `most`: contacts that the tick has room for.
  ContactFinder(std::shared_ptr<const SidedSurface> held, double friction, std::size_t most);

  /// `body`: in the plan; `stiffness`: E / (1 - nu^2) of its softest material [N/u^2]. In the order in which views have
  /// them.
  void add(int body, const PressedBody& atRest, double stiffness);

  [[nodiscard]] const FoundContacts& find(const FinderView& view);
  [[nodiscard]] const FoundContacts& last() const noexcept { return this->last_; }
  /// Radius of the patches through which a soft body is pressed: as wide as the contacts are apart, and no wider than a
  /// ball's contact, where the mesh is as round as one. The last one, where nothing was near.
  [[nodiscard]] double tip_u(std::size_t soft) const noexcept { return this->bodies_[soft].tip_u; }
  /// Which body of the plan that is.
  [[nodiscard]] int bodyOf(std::size_t soft) const noexcept { return this->bodies_[soft].body; }
  [[nodiscard]] const SidedSurface& held() const noexcept { return *this->held_; }

private:
  struct Body
  {
    int body = 0;
    std::shared_ptr<const SidedSurface> surface;
    double stiffness = 0.0;
    double tip_u = 0.0;
    double ball_u = 0.0; ///< radius of the contact of a mesh as round as a ball; 0: it is not
  };

  std::shared_ptr<const SidedSurface> held_;
  std::size_t most_;
  std::vector<Body> bodies_;
  FoundContacts last_;
};

} // namespace palpate
