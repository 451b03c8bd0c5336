// SPDX-License-Identifier: GPL-3.0-or-later
// Row 43: a wire that is pushed into a bent tube, whole in each tick, and as packets of another rate.
#include <cmath>

#include "haptics/compliance/wire/WireCompliance.h"
#include "testing/lab/Experiments.h"
#include "testing/support/WireScenes.h"

namespace palpate::lab
{
namespace wire_packets_experiment
{

constexpr int beams = 40, ticks = 350;
constexpr double length_mm = 60.0, bend_mm = 25.0, clearance_mm = 0.75;
constexpr double hand_N_per_mm = 1.0, way_mm = 0.1; // each tick: 100 mm/s

/// How far a place is from the wall of the tube, which is straight along x up to 0 and bends towards y.
struct Wall
{
  double gap_mm = 0.0;
  Vec3 inward = Vec3::UnitY();
};

Wall wallAt(const Vec3& p_mm)
{
  const Vec3 middle(0.0, bend_mm, 0.0);
  const Vec3 inBend = middle - p_mm;
  const double off_mm = p_mm.x() > 0.0 ? bend_mm - inBend.norm() : p_mm.y();
  const Vec3 across = p_mm.x() > 0.0 ? Vec3(inBend.normalized()) : Vec3(Vec3::UnitY());
  return { clearance_mm - std::abs(off_mm), off_mm > 0.0 ? Vec3(-across) : across };
}

/// A wire whose outer end a hand's spring pushes along the tube.
class PushedWire
{
public:
  PushedWire() : rig_(test::straightPoints(beams, length_mm), test::PinnedColumn::section())
  {
    for (Pose& pose : this->rig_.places_W)
    {
      pose.p.x() -= length_mm;
    }
    this->rig_.loads.held.fill(0b011100); // to its plane
    this->rig_.loads.held[0] = 0b111110;  // to the tube's direction
    this->rig_.loads.spring_N_per_u[0] = hand_N_per_mm;
    this->lead(0);
    this->forget();
  }

  void lead(int tick) { this->rig_.loads.pulledTo_W[0] = (way_mm * tick - length_mm) * Vec3::UnitX(); }
  /// Of each node, towards where the wire is linear.
  void drag(double drag_N_per_mm) { this->rig_.loads.placeDrag_N_per_u = drag_N_per_mm; }
  /// Newton's steps with contacts.
  void steps(int count)
  {
    for (int i = 0; i < count; ++i)
    {
      this->again();
      moveWire(this->rig_.wire, this->motion_, this->rig_.places_W);
      this->forget();
    }
  }
  /// Takes the wire as it is, to be linear from here on.
  void forget()
  {
    (void)this->rig_.newton->linearise(this->rig_.wire, this->rig_.places_W, this->rig_.loads);
    this->rig_.newton->factor().invert();
    this->led_W_ = this->rig_.loads.pulledTo_W[0];
    this->motion_.fill(NodeVector::Zero());
  }
  /// Contacts on the linear wire, until they fit the wall where it comes to rest.
  void again()
  {
    constexpr int rounds = 8;
    for (int i = 0; i < rounds; ++i)
    {
      this->solve();
    }
  }
  [[nodiscard]] double force_N() const
  {
    return hand_N_per_mm * (this->rig_.loads.pulledTo_W[0].x() - this->rig_.places_W[0].p.x() - this->motion_[0].x());
  }

private:
  /// The motion of the linear wire that the hand's place and the walls near its nodes leave.
  void solve()
  {
    this->touches_.clear();
    this->gaps_mm_.clear();
    for (int i = 1; i <= beams && this->touches_.size() < WireTouch::most; ++i)
    {
      const Wall wall = wallAt(this->rig_.places_W[i].p + this->motion_[i].head<3>());
      if (wall.gap_mm < 0.3 * clearance_mm)
      {
        const Vec3 along = wall.inward.cross(Vec3::UnitZ());
        this->touches_.push_back(
          { i - 1, 1.0, Vec3::Zero(), (Mat3() << wall.inward, Vec3::UnitZ(), along).finished() });
        this->gaps_mm_.push_back(wall.gap_mm - wall.inward.dot(this->motion_[i].head<3>()));
      }
    }
    this->press();
  }

  void press()
  {
    WireVector pressed;
    pressed.fill(NodeVector::Zero());
    pressed[0].head<3>() = hand_N_per_mm * (this->rig_.loads.pulledTo_W[0] - this->led_W_);
    this->rig_.newton->step(pressed, this->motion_);
    const int count = static_cast<int>(this->touches_.size());
    this->problem_->resize(count);
    this->problem_->compliance.setZero();
    this->problem_->free.setZero();
    addWireCompliance(this->rig_.newton->factor(), this->touches_, this->problem_->compliance);
    for (int i = 0; i < count; ++i)
    {
      this->problem_->free[3 * i] = this->gaps_mm_[i] + motionAt(this->touches_[i], this->motion_).x();
    }
    solveGaps(*this->problem_, this->forces_);
    for (int i = 0; i < count; ++i)
    {
      pressAt(this->touches_[i], this->forces_.force_N.segment<3>(3 * i), pressed);
    }
    this->rig_.newton->step(pressed, this->motion_);
  }

  test::WireRig rig_;
  WireVector motion_;
  Vec3 led_W_ = Vec3::Zero();
  std::vector<WireTouch> touches_;
  std::vector<double> gaps_mm_;
  std::unique_ptr<ContactProblem> problem_ = std::make_unique<ContactProblem>();
  ContactForces forces_;
};

constexpr int toRest = 12;

std::vector<double> inTheTick(int stepsATick)
{
  PushedWire wire;
  std::vector<double> force_N;
  for (int tick = 0; tick < ticks; ++tick)
  {
    wire.lead(tick);
    wire.steps(stepsATick);
    force_N.push_back(wire.force_N());
  }
  return force_N;
}

/// Each packet is the wire at rest where the hand was a period before; contacts are solved on it in each tick.
std::vector<double> asPackets(int ticksAPacket, double drag_N_per_mm)
{
  PushedWire worker;
  std::vector<double> force_N;
  for (int start = 0; start < ticks; start += ticksAPacket)
  {
    worker.lead(std::max(start - ticksAPacket, 0));
    worker.steps(toRest);
    worker.drag(drag_N_per_mm);
    worker.forget();
    for (int tick = start; tick < std::min(start + ticksAPacket, ticks); ++tick)
    {
      worker.lead(tick);
      worker.again();
      force_N.push_back(worker.force_N());
    }
    worker.drag(0.0);
  }
  return force_N;
}

/// Root mean square of the error, over that of the truth.
double off(const std::vector<double>& truth_N, const std::vector<double>& force_N)
{
  double difference = 0.0, whole = 0.0;
  for (int tick = 0; tick < ticks; ++tick)
  {
    difference += std::pow(force_N[tick] - truth_N[tick], 2);
    whole += std::pow(truth_N[tick], 2);
  }
  return std::sqrt(difference / whole);
}

} // namespace wire_packets_experiment

void runWirePackets(const Conditions&, Table& table)
{
  using namespace wire_packets_experiment;
  const std::vector<double> truth_N = inTheTick(toRest);
  const std::string tube = caseName({ { "bend_mm", bend_mm } });
  table.info({ tube, "at rest in each tick", "largest force", "N" }, *std::max_element(truth_N.begin(), truth_N.end()));
  table.atMost({ tube, "1 step a tick", "force off by, over it" }, off(truth_N, inTheTick(1)), 0.01);
  table.atMost({ tube, "2 steps a tick", "force off by, over it" }, off(truth_N, inTheTick(2)), 1e-3);
  for (const int ticksAPacket : { 2, 10, 20, 40 })
  {
    const Subject packets{ caseName({ { "rate", 1000.0 / ticksAPacket } }), "packets, a period late",
      "force off by, over it" };
    const double by = off(truth_N, asPackets(ticksAPacket, 0.0));
    ticksAPacket > 2 ? table.atLeast(packets, by, 0.01) : table.atMost(packets, by, 0.01); // as a step in each tick
  }
  table.atLeast(
    { caseName({ { "rate", 100.0 } }), "packets whose nodes are dragged to their place", "force off by, over it" },
    off(truth_N, asPackets(10, 0.1)), 1.0);
}

} // namespace palpate::lab
