// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/check/MechanismCheck.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

#include <Eigen/Eigenvalues>

#include "haptics/mechanism/check/BodiesOverlap.h"
#include "haptics/mechanism/check/MechanismFaults.h"
#include "haptics/mechanism/constraints/ConstraintCompliance.h"
#include "haptics/mechanism/sided/SidedSurface.h"
#include "haptics/mechanism/solve/SemidefiniteFactor.h"

namespace palpate
{
namespace
{

/// Share of the most compliant row that is left to one that follows from others: less is rounding.
constexpr double dependentBelow = 1e-10;
/// Of the lever: rows that follow from others and are further off contradict them.
constexpr double contradictsFrom = 1e-6;
/// Of one row in another: a smaller one is rounding.
constexpr double leastShare = 1e-6;
/// From there on a hundredth of a force is rounding of a device's place.
constexpr double badCondition = 1e8;

/// A mechanism where all its constraints hold, as it stands at rest, the held body's frame at W's.
class AtRest
{
public:
  AtRest(const Mechanism& mechanism, std::span<const MechanismSoft> soft, const MechanismGrip& grip)
    : mechanism_(mechanism), grip_(grip), plan_(planMechanism(mechanism, soft, 1))
  {
    for (int b = 0; b < this->plan_.bodyCount; ++b)
    {
      this->pose_W_[b] = this->plan_.bodies[b].pose_W;
    }
    for (const MechanismSoft& s : soft)
    {
      this->soft_.push_back(s.body);
    }
    for (int l = 0; l < this->plan_.lawCount; ++l)
    {
      this->laws_[l].phase = ConstraintPhase::Inside;
      this->laws_[l].place_A = this->plan_.laws[l].place_A;
      this->laws_[l].place_B = this->plan_.laws[l].place_B;
    }
    const Pose hand_W = this->plan_.held >= 0 ? this->pose_W_[this->plan_.held] : Pose();
    this->yieldLoose();
    const ConstraintScene scene{ this->plan_, this->soft_, this->pose_W_, this->laws_, hand_W, this->loose_ };
    makeRows(scene, *this->rows_);
    assembleConstraints(scene, *this->rows_, grip, yieldOfHeld(scene, *this->rows_, grip), *this->problem_);
    const Eigen::MatrixXd along = this->problem_->along;
    this->compliance_ = this->problem_->compliance + this->problem_->yield_u_per_N * along * along.transpose();
    const double most = this->compliance_.rows() > 0 ? this->compliance_.diagonal().maxCoeff() : 0.0;
    this->factor_.factor(this->compliance_, dependentBelow * most);
  }

  void report(MechanismCheck& check) const
  {
    check.rows = this->rows_->count;
    check.rank = this->factor_.rank();
    check.freeTurns = this->problem_->ways;
    check.condition = this->condition();
    this->tellRedundant(check);
    this->tellUnmet(check);
    this->tellFree(check);
    this->tellFalling(check);
    this->tellRubbing(check);
    this->tellSlipping(check);
    if (check.condition > badCondition)
    {
      check.remarks.push_back("The constraints are ill-conditioned: two of them are nearly linearly dependent.");
    }
  }

private:
  /// As they yield in a usual tick.
  void yieldLoose()
  {
    constexpr double usualTick_s = 1e-3;
    for (int b = 0; b < this->plan_.bodyCount; ++b)
    {
      if (isLoose(this->plan_.bodies[b]))
      {
        this->loose_[b] =
          yieldOfLoose(this->plan_.bodies[b], this->pose_W_[b].q, {}, this->plan_.characteristic_u, usualTick_s);
      }
    }
  }

  [[nodiscard]] std::vector<int> independent() const
  {
    std::vector<int> rows;
    for (int k = 0; k < this->factor_.rank(); ++k)
    {
      rows.push_back(this->factor_.row(k));
    }
    return rows;
  }

  [[nodiscard]] double condition() const
  {
    const std::vector<int> in = this->independent();
    if (in.empty())
    {
      return 1.0;
    }
    const Eigen::MatrixXd w = this->compliance_(in, in);
    const Eigen::VectorXd own = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(w, Eigen::EigenvaluesOnly).eigenvalues();
    return own.maxCoeff() / own.minCoeff();
  }

  /// A constraint whose row depends on those of others, and a fault where the row conflicts with them.
  void tellRedundant(MechanismCheck& check) const
  {
    const std::vector<int> in = this->independent();
    const Eigen::MatrixXd w = this->compliance_(in, in);
    const Eigen::VectorXd free = Eigen::VectorXd(this->problem_->free)(in);
    for (int k = this->factor_.rank(); k < this->rows_->count; ++k)
    {
      const int row = this->factor_.row(k);
      const std::string& name = this->mechanism_.laws[this->rows_->rows[row].law].name;
      const Eigen::VectorXd shares = w.ldlt().solve(Eigen::VectorXd(this->compliance_(in, row)));
      if (this->isOtherEnd(this->rows_->rows[row]))
      {
        continue;
      }
      if (std::ranges::find(check.redundant, name) == check.redundant.end())
      {
        check.redundant.push_back(name);
        check.remarks.push_back("Constraint \"" + name + "\" is partly redundant.");
      }
      const double off_u = std::abs(this->problem_->free[row] - shares.dot(free));
      if (this->followsFromHeld(row, in, shares) && off_u > contradictsFrom * this->plan_.characteristic_u)
      {
        check.faults.push_back(
          "Constraint \"" + name + "\" conflicts with the others: no configuration satisfies all of them.");
      }
    }
  }

  /// Of a limit, and of a shaft, which both end in two places along one direction.
  [[nodiscard]] bool isOtherEnd(const ConstraintRow& row) const
  {
    const ConstraintKind kind = this->plan_.laws[row.law].kind;
    return row.lowest_N == 0.0 &&
           (kind == ConstraintKind::Limit || kind == ConstraintKind::Puncture || kind == ConstraintKind::Insertion);
  }

  /// A row in which a bounded row has a share can yield.
  [[nodiscard]] bool followsFromHeld(int row, const std::vector<int>& in, const Eigen::VectorXd& shares) const
  {
    bool held = this->isHeld(row);
    for (std::size_t k = 0; k < in.size(); ++k)
    {
      held = held && (this->isHeld(in[k]) || std::abs(shares[static_cast<Eigen::Index>(k)]) < leastShare);
    }
    return held;
  }

  [[nodiscard]] bool isHeld(int row) const
  {
    return std::isinf(this->problem_->lowest[row]) && std::isinf(this->problem_->highest[row]);
  }

  /// Constraints that only push may contradict each other, too: then no forces meet them all.
  void tellUnmet(MechanismCheck& check) const
  {
    auto room = std::make_unique<ConstraintScratch>();
    auto forces = std::make_unique<ConstraintForces>();
    forces->force_N.setZero(this->rows_->count);
    solveConstraints(*this->problem_, *room, *forces);
    int worst = -1;
    double most_u = contradictsFrom * this->plan_.characteristic_u;
    for (int i = 0; i < this->problem_->bounded(); ++i)
    {
      const bool pushes = this->rows_->rows[i].lowest_N == 0.0 && this->rows_->rows[i].compliance_u_per_N == 0.0;
      if (pushes && -forces->moved_u[i] > most_u)
      {
        most_u = -forces->moved_u[i];
        worst = i;
      }
    }
    if (worst >= 0 && check.faults.empty())
    {
      check.faults.push_back("Constraint \"" + this->mechanism_.laws[this->rows_->rows[worst].law].name +
                             "\" conflicts with the others: no configuration satisfies all of them.");
    }
  }

  /// Bodies that can go where no row goes with them.
  void tellFree(MechanismCheck& check) const
  {
    const Eigen::MatrixXd along = this->problem_->along;
    SemidefiniteFactor<ConstraintProblem::mostWays> ways;
    ways.factor(along.transpose() * along, dependentBelow);
    int first = 0;
    for (int b = 0; b < this->plan_.bodyCount; ++b)
    {
      const int count = this->waysOf(b);
      bool free = false;
      for (int k = ways.rank(); k < this->problem_->ways; ++k)
      {
        free = free || (ways.row(k) >= first && ways.row(k) < first + count);
      }
      first += count;
      if (free)
      {
        check.free.push_back(this->mechanism_.bodies[b].name);
        check.remarks.push_back(
          "Body \"" + this->mechanism_.bodies[b].name + "\" has degrees of freedom that no constraint restricts.");
      }
    }
  }

  /// A load on a body that no row goes with: the body would fall for ever. One that glides off its constraints is left
  /// to be felt, and said in each tick.
  void tellFalling(MechanismCheck& check) const
  {
    for (int b = 0, first = 0; b < this->plan_.bodyCount; first += this->waysOf(b), ++b)
    {
      const bool rests = this->plan_.bodies[b].kind == MechanismBodyKind::Rigid && !isLoose(this->plan_.bodies[b]);
      if (rests && this->plan_.bodies[b].load_W != Vec3::Zero() &&
          this->problem_->along.middleCols(first, 3).isZero(0.0))
      {
        check.faults.push_back("No constraint supports body \"" +
                               this->mechanism_.bodies[static_cast<std::size_t>(b)].name +
                               "\" against its load: add a constraint that does.");
      }
    }
  }

  /// How many only the balance of forces and moments decides.
  [[nodiscard]] int waysOf(int body) const
  {
    const MechanismBodyKind kind = this->plan_.bodies[body].kind;
    const bool turns = kind == MechanismBodyKind::Held && !(this->grip_.turning_Nu_per_rad > 0.0);
    const int rests = isLoose(this->plan_.bodies[body]) ? 0 : 6;
    return kind == MechanismBodyKind::Rigid ? rests : turns ? 3 : 0;
  }

  /// Coulomb's forces at points that no compliance separates have no unique answer, and their effect on a body that
  /// only balance holds is left to chance.
  void tellRubbing(MechanismCheck& check) const
  {
    const int cones = 3 * this->problem_->cones;
    const int first = this->rows_->count - cones;
    SemidefiniteFactor<ConstraintProblem::most> factor;
    const Eigen::MatrixXd own = this->compliance_.bottomRightCorner(cones, cones);
    factor.factor(own, cones > 0 ? dependentBelow * own.diagonal().maxCoeff() : 0.0);
    for (int k = factor.rank(); k < cones; ++k)
    {
      const MechanismConstraint& law = this->mechanism_.laws[this->rows_->rows[first + factor.row(k)].law];
      const std::string fault =
        "Constraint \"" + law.name +
        "\" has friction between rigid bodies, so that its share of the friction is undetermined: "
        "make one of the bodies soft, or use contact and dry friction.";
      const bool said = std::ranges::find(check.faults, fault) != check.faults.end();
      if ((this->isBalanced(law.a) || this->isBalanced(law.b)) && !said)
      {
        check.faults.push_back(fault);
      }
    }
  }

  /// A body that only the balance of forces or moments holds.
  [[nodiscard]] bool isBalanced(const std::string& name) const
  {
    const MechanismBody& body = this->mechanism_.bodies[static_cast<std::size_t>(bodyNamed(this->mechanism_, name))];
    return (body.kind == MechanismBodyKind::Rigid && !isLoose(body)) ||
           (body.kind == MechanismBodyKind::Held && !(this->grip_.turning_Nu_per_rad > 0.0));
  }

  /// A rod that turns freely stands on its tip like a strut: without friction it falls over.
  void tellSlipping(MechanismCheck& check) const
  {
    for (const MechanismConstraint& law : this->mechanism_.laws)
    {
      if (law.kind == ConstraintKind::Puncture && law.friction == 0.0 && !(this->grip_.turning_Nu_per_rad > 0.0))
      {
        check.remarks.push_back("The tip of constraint \"" + law.name +
                                "\" slips sideways, because the device leaves the rotation free: set its friction.");
      }
    }
  }

  const Mechanism& mechanism_;
  MechanismGrip grip_;
  MechanismPlan plan_;
  std::array<Pose, Mechanism::mostBodies> pose_W_{};
  std::array<ConstraintState, Mechanism::mostConstraints> laws_{};
  std::array<LooseYield, Mechanism::mostBodies> loose_{};
  std::vector<const PressedBody*> soft_;
  std::unique_ptr<ConstraintRows> rows_ = std::make_unique<ConstraintRows>();
  std::unique_ptr<ConstraintProblem> problem_ = std::make_unique<ConstraintProblem>();
  Eigen::MatrixXd compliance_;
  SemidefiniteFactor<ConstraintProblem::most> factor_;
};

/// The fault of a loose body that begins deeper in another one than its contacts are found, or "".
std::string tooDeep(const Mechanism& mechanism, const BodyPair& pair)
{
  const auto reach_u = [&mechanism](const std::string& name)
  {
    const MechanismBody& body = mechanism.bodies[static_cast<std::size_t>(bodyNamed(mechanism, name))];
    return isLoose(body) ? SidedSurface::looseReach * body.mesh->diagonal_u : 0.0;
  };
  const double ofFirst_u = reach_u(pair.first), ofSecond_u = reach_u(pair.second);
  const double deep_u = overlapDepth(mechanism, pair);
  if (!(deep_u > ofFirst_u + ofSecond_u))
  {
    return "";
  }
  const auto& [body, other] = ofFirst_u > 0.0 ? pair : BodyPair(pair.second, pair.first);
  std::ostringstream text;
  text.precision(3);
  text << body << " lies " << deep_u << " u deep in " << other << ", which pushes it out from at most "
       << ofFirst_u + ofSecond_u << " u: move one of them.";
  return text.str();
}

/// Bodies do not meet but where a constraint has them meet.
void tellOverlaps(const Mechanism& mechanism, std::span<const MechanismSoft> soft, MechanismCheck& check)
{
  check.overlaps = overlapsOf(mechanism, soft);
  const auto isMesh = [&mechanism](const std::string& name)
  { return mechanism.bodies[static_cast<std::size_t>(bodyNamed(mechanism, name))].mesh != nullptr; };
  for (const auto& [a, b] : check.overlaps)
  {
    const bool pushed = softNamed(soft, a) ? isMesh(b) : softNamed(soft, b) && isMesh(a);
    const bool loose = mechanism.findsContacts && isMesh(a) && isMesh(b);
    if (mechanism.findsContacts && softNamed(soft, a) && softNamed(soft, b))
    {
      check.faults.push_back(a + " and " + b + " lie in one another: move one of them.");
      continue;
    }
    if (pushed && mechanism.beginsApart)
    {
      const auto& [body, mesh] = softNamed(soft, a) ? std::pair(a, b) : std::pair(b, a);
      check.faults.push_back(
        body + " lies in " + mesh + ", which would push it out: hide " + mesh + ", or move " + body + " out of it.");
      continue;
    }
    if (const std::string fault = loose ? tooDeep(mechanism, { a, b }) : ""; !fault.empty())
    {
      check.faults.push_back(fault);
      continue;
    }
    check.remarks.push_back("Bodies \"" + a + "\" and \"" + b + "\" overlap in the scene file: " +
                            (loose     ? "the contacts push them apart slowly."
                              : pushed ? "the contacts push them apart at once."
                                       : "bodies without a constraint between them pass through each other."));
  }
  check.heldOverlaps = overlapsOfHeld(mechanism, soft);
  const auto isRod = [](const MechanismBody& body) { return body.kind == MechanismBodyKind::Held && !body.mesh; };
  const bool rod = std::ranges::any_of(mechanism.bodies, isRod);
  for (const auto& [a, b] : check.heldOverlaps)
  {
    check.remarks.push_back(
      "Bodies \"" + a + "\" and \"" + b + "\" overlap if the hand begins at the origin: " +
      (mechanism.findsContacts && !rod ? "the contacts push them apart at once." : "no constraint joins them."));
  }
}

/// The wire of a mechanism without faults; null: there is none.
const PlannedWire* wireOf(const Mechanism& mechanism)
{
  return mechanism.bodies.empty() ? nullptr : mechanism.bodies.front().wire.get();
}

/// The pairs of bodies whose contacts are not found.
void tellUnfound(const Mechanism& mechanism, MechanismCheck& check)
{
  const bool boxes = std::ranges::any_of(
    mechanism.bodies, [](const MechanismBody& b) { return b.kind == MechanismBodyKind::Rigid && !b.mesh; });
  if (mechanism.findsContacts && boxes)
  {
    check.remarks.emplace_back(
      "Contacts with boxes of the kind \"rigid\" that have no density are not found: they pass through other bodies "
      "where no constraint stops them.");
  }
}

} // namespace

MechanismCheck checkMechanism(
  const Mechanism& mechanism, std::span<const MechanismSoft> soft, const MechanismGrip& grip)
{
  MechanismCheck check;
  check.faults = faultsOf(mechanism, soft);
  if (!(grip.coupling_N_per_u > 0.0) || !(grip.turning_Nu_per_rad >= 0.0))
  {
    check.faults.emplace_back("The hand holds no body: set a stiffness above 0.");
  }
  const PlannedWire* const wire = check.faults.empty() ? wireOf(mechanism) : nullptr;
  if (wire)
  {
    check.wire = wire->check;
    check.remarks = wire->check.remarks;
  }
  else if (check.faults.empty())
  {
    AtRest(mechanism, soft, grip).report(check);
    tellOverlaps(mechanism, soft, check);
    tellUnfound(mechanism, check);
  }
  return check;
}

} // namespace palpate
