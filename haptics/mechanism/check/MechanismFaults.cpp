// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/check/MechanismFaults.h"
#include "haptics/mechanism/SoundPose.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "haptics/geometry/mesh/NearestOnTriangle.h"
#include "haptics/geometry/mesh/TriangleWeights.h"
#include "haptics/mechanism/sided/SidedSurface.h"
#include "haptics/mechanism/wire/WirePlan.h"

namespace palpate
{
namespace
{

constexpr std::size_t mostRigid = 3; // each has six degrees of freedom that only balance decides: more are too many for
                                     // a tick

constexpr int fewestFound = 4; // contacts that hold a body against all turns but one: with fewer it tips through

constexpr double farthest_u = 1e9; // a metre in nanometres; from there on rounding is felt
constexpr double strongest_N = 1e6;

bool isNear(const Vec3& p)
{
  return p.allFinite() && p.cwiseAbs().maxCoeff() <= farthest_u;
}

bool onMesh(const MechanismBody& body, const Vec3& p)
{
  return p.norm() <= (1.0 + 1e-9) * body.mesh->radius_u;
}

bool onRod(const MechanismBody& body, const Vec3& p)
{
  const double slack_u = 1e-9 * body.length_u;
  return p.z() >= -slack_u && p.z() <= body.length_u + slack_u && p.head<2>().norm() <= 0.5 * body.diameter_u + slack_u;
}

bool inBox(const MechanismBody& body, const Vec3& p)
{
  return (p.cwiseAbs().array() <= (1.0 + 1e-9) * body.halfSize_u.array()).all();
}

/// A point that is further from the surface than a patch has no patch under it.
bool onSurface(const PressedBody& body, const Vec3& p_W)
{
  return (nearestPlace(body, p_W).x_W - p_W).norm() <= body.snapshot->patchRadius_u.front();
}

/// Gathers the faults of one mechanism.
class Faults
{
public:
  Faults(const Mechanism& mechanism, std::span<const MechanismSoft> soft) : mechanism_(mechanism), soft_(soft) {}

  std::vector<std::string> gather()
  {
    this->judgeCounts();
    for (std::size_t i = 0; i < this->mechanism_.bodies.size(); ++i)
    {
      this->judgeBody(this->mechanism_.bodies[i], i);
    }
    for (std::size_t i = 0; i < this->mechanism_.laws.size(); ++i)
    {
      this->judgeConstraint(this->mechanism_.laws[i], i);
    }
    this->judgeFound();
    this->judgeWire();
    return std::move(this->faults_);
  }

private:
  void say(const std::string& sentence) { this->faults_.push_back(sentence); }
  void require(bool holds, const std::string& sentence)
  {
    if (!holds)
    {
      this->say(sentence);
    }
  }

  [[nodiscard]] std::size_t countOf(MechanismBodyKind kind) const { return palpate::countOf(this->mechanism_, kind); }

  [[nodiscard]] std::size_t countLoose() const
  {
    return static_cast<std::size_t>(
      std::ranges::count_if(this->mechanism_.bodies, [](const MechanismBody& b) { return isLoose(b); }));
  }

  void judgeCounts()
  {
    const auto most = [this](std::size_t count, std::size_t most, const std::string& what)
    {
      this->require(count <= most, "The mechanism has " + std::to_string(count) + " " + what + ", at most " +
                                     std::to_string(most) + " are supported: remove some.");
    };
    most(this->mechanism_.bodies.size(), Mechanism::mostBodies, "bodies");
    most(this->mechanism_.laws.size(), Mechanism::mostConstraints, "laws");
    most(this->countOf(MechanismBodyKind::Held), 1, "bodies in the hand");
    most(this->countOf(MechanismBodyKind::Rigid) - this->countLoose(), mostRigid, "free rigid bodies without density");
    std::size_t rows = 0;
    for (const MechanismConstraint& law : this->mechanism_.laws)
    {
      rows += static_cast<std::size_t>(mostRowsOf(law.kind));
    }
    most(rows, static_cast<std::size_t>(Mechanism::mostRows), "rows");
  }

  template<class Items>
  void judgeName(const Items& items, std::size_t i, const std::string& what)
  {
    const auto before = items.begin() + static_cast<std::ptrdiff_t>(i);
    const bool twice =
      std::any_of(items.begin(), before, [&](const auto& other) { return other.name == items[i].name; });
    this->require(!items[i].name.empty(), "A " + what + " has no name: add a name.");
    this->require(!twice,
      "Two items of the mechanism have the name \"" + items[i].name + "\": give each " + what + " a unique name.");
  }

  void judgeBody(const MechanismBody& body, std::size_t i)
  {
    this->judgeName(this->mechanism_.bodies, i, "body");
    const std::string name = "Body \"" + body.name + "\" ";
    const auto size = [](double x) { return x > 0.0 && x <= farthest_u; };
    const bool rod = size(body.length_u) && size(body.diameter_u);
    const bool box = std::ranges::all_of(body.halfSize_u, size);
    const bool placed =
      isNear(body.pose_W.p) && isSound(body.pose_W) && body.load_W.allFinite() && body.load_W.norm() <= strongest_N;
    const bool soft = softNamed(this->soft_, body.name) && softNamed(this->soft_, body.name)->body;
    this->require(body.kind != MechanismBodyKind::Held || body.mesh || rod,
      name + "has no length or no diameter: set both, above 0 and at most 1e9.");
    this->require(!body.mesh || (body.length_u == 0.0 && body.diameter_u == 0.0),
      name + "is a mesh, and has the size of a rod beside it: give one of the two.");
    this->require(!body.mesh || body.mesh->radius_u <= farthest_u, name + "has a vertex beyond 1e9.");
    this->require(!body.mesh || box || this->mechanism_.findsContacts,
      name + "is a mesh that would meet nothing: have its contacts found (\"contacts\": \"found\").");
    const bool massive = isLoose(body) && body.mesh != nullptr;
    this->require(body.kind != MechanismBodyKind::Rigid || box || massive,
      name + "has no size: set half sizes above 0 and at most 1e9.");
    this->require((body.kind != MechanismBodyKind::Rigid && body.kind != MechanismBodyKind::Held) || placed,
      name + "has an invalid pose (beyond 1e9) or load (beyond 1e6 N).");
    this->judgeMass(body, name);
    this->require(body.kind != MechanismBodyKind::Soft || soft, name + "is missing: no soft body has that name.");
  }

  void judgeMass(const MechanismBody& body, const std::string& name)
  {
    this->require(body.mass == BodyMass{} || body.kind == MechanismBodyKind::Rigid,
      name + "has a density, which only a body of the kind \"rigid\" may have.");
    this->require(isValid(body.mass), name + "has no mass: give it a density above 0, and a volume.");
  }

  void judgeConstraint(const MechanismConstraint& law, std::size_t i)
  {
    this->judgeName(this->mechanism_.laws, i, "constraint");
    const std::string name = "Constraint \"" + law.name + "\" ";
    this->judgeNumbers(law, name);
    const int a = bodyNamed(this->mechanism_, law.a);
    const int b = bodyNamed(this->mechanism_, law.b);
    for (const auto& [body, of] : { std::pair(a, law.a), std::pair(b, law.b) })
    {
      this->require(body >= 0, name + "names \"" + of + "\", but no body has that name.");
    }
    if (a < 0 || b < 0)
    {
      return;
    }
    this->require(a != b, name + "joins \"" + law.a + "\" to itself: name two bodies.");
    this->judgeBodies(law, this->mechanism_.bodies[a], this->mechanism_.bodies[b], name);
  }

  /// Contacts are found between the meshes of rigid bodies and soft bodies, and between soft bodies.
  void judgeFound()
  {
    if (!this->mechanism_.findsContacts)
    {
      return;
    }
    const bool mesh =
      std::ranges::any_of(this->mechanism_.bodies, [](const MechanismBody& b) { return b.mesh != nullptr; });
    this->require(mesh || this->countOf(MechanismBodyKind::Soft) > 1,
      "Contacts are found for a mesh that is held, is loose or stands in the world, and no such body has a file: "
      "give one, or name the contacts of the rod.");
    this->require(this->countOf(MechanismBodyKind::Soft) + this->countLoose() > 0,
      "Contacts are found with soft bodies and loose ones, and there are none: add one.");
    const auto coefficient = [](double friction) { return std::isfinite(friction) && friction >= 0.0; };
    const bool ofBodies = std::ranges::all_of(this->mechanism_.bodies,
      [&](const MechanismBody& body) { return coefficient(foundFrictionOf(this->mechanism_, body)); });
    this->require(coefficient(this->mechanism_.foundFriction) && ofBodies,
      "The friction of found contacts is negative or not a number.");
    this->require(roomForFound(this->mechanism_) >= fewestFound,
      "The constraints have so many rows that fewer than four contacts can be found: remove some.");
  }

  /// Its own check knows the faults of the wire and its vessel.
  void judgeWire()
  {
    for (const MechanismBody& body : this->mechanism_.bodies)
    {
      if (body.kind != MechanismBodyKind::Wire)
      {
        continue;
      }
      const bool alone = this->mechanism_.bodies.size() == 1 && this->mechanism_.laws.empty();
      this->require(alone && !this->mechanism_.findsContacts,
        "A wire is the only body of its mechanism, without constraints: its vessel is a key of the wire.");
      this->require(body.wire != nullptr, "Body \"" + body.name + "\" is a wire without a vessel: give it one.");
      if (body.wire)
      {
        std::ranges::for_each(body.wire->check.faults, [this](const std::string& fault) { this->say(fault); });
      }
    }
  }

  void judgeNumbers(const MechanismConstraint& law, const std::string& name)
  {
    const auto positive = [](double x) { return x > 0.0; }; // NaN fails, too
    const auto coefficient = [](double x) { return std::isfinite(x) && x >= 0.0; };
    this->require(positive(law.strength_N), name + "breaks at 0 N or less: set a strength above 0 N.");
    this->require(positive(law.tear_N), name + "tears at 0 N or less: set a strength of the hole above 0 N.");
    this->require(positive(law.stiffness_N_per_u), name + "has no stiffness: set a stiffness above 0.");
    this->require(coefficient(law.friction) && coefficient(law.dryFriction_N),
      name + "has a friction that is negative or not a number.");
    const bool near = isNear(law.point_A) && isNear(law.point_B) && std::abs(law.rest_u) <= farthest_u;
    this->require(near, name + "has a position beyond 1e9.");
    this->require(
      law.axis_A.allFinite() && law.axis_B.allFinite() && law.axis_A.norm() > 0.0 && law.axis_B.norm() > 0.0,
      name + "has an axis of length 0.");
    const bool bounded = std::abs(law.least_u) <= farthest_u || std::abs(law.most_u) <= farthest_u;
    this->require(law.kind != ConstraintKind::Limit || (bounded && law.least_u <= law.most_u),
      name + "has an empty range: 'least' must be below 'most', and at least one must be given.");
  }

  void judgeBodies(
    const MechanismConstraint& law, const MechanismBody& a, const MechanismBody& b, const std::string& name)
  {
    const bool needle = law.kind == ConstraintKind::Puncture || law.kind == ConstraintKind::Insertion;
    const bool turns = law.kind == ConstraintKind::Hinge || law.kind == ConstraintKind::Slider;
    const auto is = [](const MechanismBody& body, MechanismBodyKind kind) { return body.kind == kind; };
    this->require(!is(a, MechanismBodyKind::World) || !is(b, MechanismBodyKind::World),
      name + "joins two bodies that cannot move.");
    this->require(
      !needle || (is(a, MechanismBodyKind::Held) && !a.mesh), name + "needs a rod in the hand as its first body.");
    this->require(law.kind != ConstraintKind::Puncture || is(b, MechanismBodyKind::Soft),
      name + "needs a soft body as its second body.");
    this->require(!turns || (!is(a, MechanismBodyKind::Soft) && !is(b, MechanismBodyKind::Soft)),
      name + "rotates a soft body, which has no rotation of its own: attach the body at two points instead.");
    if (!needle)
    {
      this->judgePlace(a, law.point_A, name);
    }
    if (law.kind != ConstraintKind::Puncture)
    {
      this->judgePlace(b, law.point_B, name);
    }
  }

  void judgePlace(const MechanismBody& body, const Vec3& point, const std::string& name)
  {
    const MechanismSoft* soft = softNamed(this->soft_, body.name);
    const bool within = body.kind == MechanismBodyKind::Held ? body.mesh ? onMesh(body, point) : onRod(body, point)
                        : body.kind == MechanismBodyKind::Rigid
                          ? (body.halfSize_u.isZero(0.0) ? body.mesh && onMesh(body, point) : inBox(body, point))
                        : body.kind == MechanismBodyKind::Soft ? !soft || !soft->body || onSurface(*soft->body, point)
                                                               : true;
    this->require(within, name + "lies outside of \"" + body.name + "\": move its point onto the body.");
  }

  const Mechanism& mechanism_;
  std::span<const MechanismSoft> soft_;
  std::vector<std::string> faults_;
};

} // namespace

std::vector<std::string> faultsOf(const Mechanism& mechanism, std::span<const MechanismSoft> soft)
{
  return Faults(mechanism, soft).gather();
}

SurfacePoint nearestPlace(const PressedBody& body, const Vec3& p_W)
{
  const TriangleMesh& mesh = body.scene->surfaces()[body.touch.surface].tree->mesh();
  SurfacePoint best;
  double least_u = std::numeric_limits<double>::infinity();
  for (const auto& triangle : mesh.triangles)
  {
    const Vec3& a = mesh.vertices_W[triangle[0]];
    const Vec3& b = mesh.vertices_W[triangle[1]];
    const Vec3& c = mesh.vertices_W[triangle[2]];
    const Vec3 x_W = nearestOnTriangle(p_W, a, b, c);
    if (const double away_u = (x_W - p_W).norm(); away_u < least_u)
    {
      least_u = away_u;
      best = { triangle, weightsOnTriangle(a, b, c, x_W), x_W };
    }
  }
  return best;
}

const MechanismSoft* softNamed(std::span<const MechanismSoft> soft, const std::string& name)
{
  const auto found = std::ranges::find_if(soft, [&name](const MechanismSoft& s) { return s.name == name; });
  return found == soft.end() ? nullptr : &*found;
}

int bodyNamed(const Mechanism& mechanism, const std::string& name)
{
  const auto found = std::ranges::find_if(mechanism.bodies, [&name](const MechanismBody& b) { return b.name == name; });
  return found == mechanism.bodies.end() ? -1 : static_cast<int>(found - mechanism.bodies.begin());
}

} // namespace palpate
