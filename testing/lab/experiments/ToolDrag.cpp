// SPDX-License-Identifier: GPL-3.0-or-later
// The force of a tool on a hand between two updates: by the contacts that touch, by a virtual coupling, and with
// features that are nearer than the hand may come until the next update, at their true gaps.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

#include "haptics/tool/move/ToolMove.h"
#include "haptics/tool/servo/ToolForce.h"
#include "testing/lab/Experiments.h"
#include "testing/support/Meshes.h"

namespace palpate::lab
{
namespace tool_drag_experiment
{

constexpr double stiffness_N_per_m = 1000.0, speed_m_per_s = 0.1, tick_s = 1e-3, half_m = 0.02, depth_m = 0.002;
constexpr double degree_rad = std::numbers::pi / 180.0;
constexpr std::uint64_t plenty = 1u << 24;
const char* const touching = "ours: touching";
const char* const ahead = "ours: and ahead";
const char* const coupling = "virtual coupling";

/// A tool that is led by a hand, in m.
struct LedTool
{
  LedTool(const TriangleMesh& toolMesh, const TriangleMesh& sceneMesh, const Pose& first_W)
    : tool(makeTool(toolMesh).value), scene_W(makeToolScene(cleanMesh(sceneMesh).mesh, tool)), start_W(first_W),
      move(tool, scene_W, tool.gyration_u)
  {
    static_cast<void>(move.place(start_W));
  }
  /// The same tool where it began.
  LedTool(const LedTool& other)
    : tool(other.tool), scene_W(other.scene_W), start_W(other.start_W), move(tool, scene_W, tool.gyration_u)
  {
    static_cast<void>(move.place(start_W));
  }

  /// Contacts that touch, and those nearer than that.
  [[nodiscard]] ToolContacts contactsWithin(double near_m) const
  {
    constexpr double touchesWithin = 4.0; // rest gaps
    const double gap_m = near_m / touchesWithin;
    PairFront front(*this->tool.shape_B, *this->scene_W, gap_m);
    WorkBudget unlimited(std::numeric_limits<std::uint64_t>::max());
    static_cast<void>(front.gather(this->move.pose_W(), near_m, unlimited));
    NearPairs pairs(*this->tool.shape_B, *this->scene_W);
    pairs.rebuild(front.near(), front.way_u(), front.margin_u());
    TouchRows rows(*this->tool.shape_B, *this->scene_W, gap_m);
    rows.findTouching(pairs, this->move.pose_W(), front.way_u());
    ToolContacts set = this->move.contacts();
    for (const TouchRow& row : rows.rows())
    {
      if (set.count < ToolContacts::capacity)
      {
        set.contacts[set.count++] = { row.plane.n_W, row.plane.arm_W, row.plane.gap_u };
      }
    }
    return set;
  }

  ToolMesh tool;
  std::shared_ptr<const BoxedMesh> scene_W;
  Pose start_W;
  ToolMove move;
};

using Hand = std::function<Pose(double time_s)>;

/// The force of each tick, by that method, with an update every so many.
std::vector<Vec3> forces_N(LedTool led, const Hand& hand, int ticks, int ticksAnUpdate, const std::string& method)
{
  std::vector<Vec3> felt;
  ToolContacts newest;
  for (int tick = 0; tick < ticks; ++tick)
  {
    const Pose hand_W = hand(tick_s * tick);
    if (tick % ticksAnUpdate == 0)
    {
      led.move.update(hand_W, plenty);
      newest = method == ahead ? led.contactsWithin(speed_m_per_s * tick_s * ticksAnUpdate) : led.move.contacts();
    }
    const ToolCoupling how = method == coupling ? ToolCoupling::Virtual : ToolCoupling::Constraints;
    felt.push_back(toolPush(newest, hand_W, stiffness_N_per_m, how).wrench_W.force);
  }
  return felt;
}

TriangleMesh cube()
{
  return test::makeBox(Vec3::Constant(-half_m), Vec3::Constant(half_m));
}

/// Row 30: the force that holds a tool back that slides without friction.
void slide(test::Random& random, Table& table)
{
  const LedTool led(
    cube(), test::makeSheet({ 1.0, 0.2, 40, 8, 0.3 }, random), { Vec3(-0.4, 0, 0.03), Quat::Identity() });
  const Hand hand = [](double s) {
    return Pose{ Vec3(-0.4 + speed_m_per_s * s, 0.01, half_m - depth_m), Quat::Identity() };
  };
  for (const int ticksAnUpdate : { 1, 4, 10, 20, 33 })
  {
    const double rate_Hz = 1.0 / (tick_s * ticksAnUpdate);
    for (const char* const method : { touching, coupling, ahead })
    {
      double drag_N = 0.0;
      for (const Vec3& force : forces_N(led, hand, 660, ticksAnUpdate, method))
      {
        drag_N = std::max(drag_N, force.head<2>().norm());
      }
      const Subject subject{ caseName({ { "slide", 1.0 }, { "rate", rate_Hz } }), method, "drag", "N" };
      if (method == coupling) // K v T of a tool that the tick of its update has just led to the hand
      {
        table.within(subject, drag_N, stiffness_N_per_m * speed_m_per_s * tick_s * (ticksAnUpdate - 1), 1e-6);
      }
      else
      {
        table.atMost(subject, drag_N, 1e-12);
      }
    }
  }
}

/// The rise of the force in one tick by a contact that is met between two updates: K v T where it is known beforehand.
void land(test::Random& random, int ticksAnUpdate, Table& table)
{
  const LedTool led(cube(), test::makeSheet({ 0.2, 0.2, 8, 8, 0.3 }, random), { Vec3(0, 0, 0.03), Quat::Identity() });
  const Hand hand = [](double s) { return Pose{ Vec3(0, 0, half_m + 0.00505 - speed_m_per_s * s), Quat::Identity() }; };
  for (const char* const method : { touching, coupling, ahead })
  {
    const std::vector<Vec3> felt = forces_N(led, hand, 80, ticksAnUpdate, method);
    double step_N = 0.0;
    for (std::size_t i = 1; i < felt.size(); ++i)
    {
      step_N = std::max(step_N, (felt[i] - felt[i - 1]).norm());
    }
    const Subject subject{ "landing", method, "largest step", "N" };
    const double known_N = stiffness_N_per_m * speed_m_per_s * tick_s;
    method == ahead ? table.within(subject, step_N, known_N, 1e-3 * known_N) : table.info(subject, step_N);
  }
}

/// The largest difference from the force by the contacts that are known when every tick has its update.
void compare(const std::string& name, const LedTool& led, const Hand& hand, int ticks, int ticksAnUpdate, Table& table)
{
  const std::vector<Vec3> truth = forces_N(led, hand, ticks, 1, touching);
  for (const char* const method : { touching, coupling, ahead })
  {
    const std::vector<Vec3> felt = forces_N(led, hand, ticks, ticksAnUpdate, method);
    double wrong_N = 0.0;
    for (std::size_t i = 0; i < felt.size(); ++i)
    {
      wrong_N = std::max(wrong_N, (felt[i] - truth[i]).norm());
    }
    table.info({ name, method, "wrong force", "N" }, wrong_N);
  }
}

/// Row 61: a peg in the mouth of a slot, at the widest tilt at which it goes in; the hand is free on the whole path.
LedTool pegAtMouth(double tilt_rad)
{
  constexpr double wide = 0.01, room = 2.5e-5;
  TriangleMesh slot = test::makeBox(Vec3(-0.06, -0.06, -0.06), Vec3(-wide - room, 0.06, 0.0));
  append(slot, test::makeBox(Vec3(wide + room, -0.06, -0.06), Vec3(0.06, 0.06, 0.0)));
  return { test::makeBox(Vec3(-wide, -0.01, -0.03), Vec3(wide, 0.01, 0.03)), slot,
    { Vec3(0, 0, 0.031), Quat(Eigen::AngleAxisd(tilt_rad, Vec3::UnitY())) } };
}

} // namespace tool_drag_experiment

void runToolDrag(const Conditions& conditions, Table& table)
{
  using namespace tool_drag_experiment;
  constexpr int ticksAnUpdate = 10;
  test::Random random(conditions.seed + 61);
  slide(random, table);
  conditions.progress(0.6);
  land(random, ticksAnUpdate, table);
  const double tilt_rad = 0.0470 * degree_rad;
  const Quat tilted(Eigen::AngleAxisd(tilt_rad, Vec3::UnitY()));
  compare(
    "peg into a slot", pegAtMouth(tilt_rad),
    [&](double s) {
      return Pose{ Vec3(0, 0, 0.031 - speed_m_per_s * s), tilted };
    },
    250, ticksAnUpdate, table);
  conditions.progress(0.8);
  const LedTool atEdge(cube(), test::makeBox(Vec3(-0.1, -0.1, -0.1), Vec3(0.0, 0.1, 0.0)),
    { Vec3(-0.02, 0, half_m + 0.001), Quat::Identity() });
  compare(
    "over an edge", atEdge,
    [](double s) {
      return Pose{ Vec3(-0.02 + speed_m_per_s * s, 0, half_m - depth_m), Quat::Identity() };
    },
    600, ticksAnUpdate, table);
  conditions.progress(1.0);
}

} // namespace palpate::lab
