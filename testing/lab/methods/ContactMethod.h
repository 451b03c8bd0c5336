// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "haptics/geometry/scene/Scene.h"
#include "testing/lab/methods/FaceTree.h"

namespace palpate::lab
{

/// A method's result of one tick.
struct MethodTick
{
  Vec3 proxy_W = Vec3::Zero();
  Vec3 force_u = Vec3::Zero(); ///< force per unit of stiffness [u]; proxy - device for a god-object
};

/// A method that turns a device point into a force, one call a tick.
class ContactMethod
{
public:
  virtual ~ContactMethod() = default;
  /// Begins anew in free space.
  virtual void start(const Vec3& p_W) = 0;
  [[nodiscard]] virtual MethodTick tick(const Vec3& p_W) = 0;
};

/// The mesh to touch, as each method wants it.
struct World
{
  explicit World(const TriangleMesh& mesh, double metre_u = 1.0);

  std::shared_ptr<const TriangleMesh> mesh;
  std::shared_ptr<const FaceTree> faces;
  std::shared_ptr<const Scene> scene;
  double metre_u; ///< how many scene units a metre has
};

/// A method by name, and the ball that touches with it. Without `make`: its library was not there when this was built.
struct MethodKind
{
  std::string name;
  double radius_m = 0.0;
  std::function<std::unique_ptr<ContactMethod>(const World&)> make;
};

/// Every method: the product's god-object first, as point and as ball, then the textbook's and the peers'.
[[nodiscard]] const std::vector<MethodKind>& methods();
/// The one with this name; throws std::out_of_range.
[[nodiscard]] const MethodKind& method(const std::string& name);

} // namespace palpate::lab
