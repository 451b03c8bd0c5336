// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/tools/ToolScenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/tool/mesh/ToolMesh.h"
#include "haptics/tool/motion/Turn.h"
#include "testing/support/Meshes.h"
#include "testing/support/Thread.h"

namespace palpate::lab
{
namespace
{

constexpr double degree_rad = std::numbers::pi / 180.0;
constexpr int rest = 30; // updates that the hand then holds still

ToolBody box(const Vec3& low, const Vec3& high)
{
  const Vec3 middle = 0.5 * (low + high), half = 0.5 * (high - low);
  return { test::makeBox(low, high), [=](const Vec3& p)
    {
      const Vec3 out = (p - middle).cwiseAbs() - half;
      return out.cwiseMax(0.0).norm() + std::min(0.0, out.maxCoeff());
    } };
}

ToolBody together(const ToolBody& a, const ToolBody& b)
{
  ToolBody both = a;
  append(both.mesh, b.mesh);
  both.distance_mm = [one = a.distance_mm, other = b.distance_mm](const Vec3& p) { return std::min(one(p), other(p)); };
  return both;
}

/// An upright prism of so many flats round a circle.
ToolBody prism(const Vec3& foot, double inner_mm, int flats, double height_mm)
{
  ToolBody body;
  const double part = 2.0 * std::numbers::pi / flats, outer_mm = inner_mm / std::cos(0.5 * part);
  for (int i = 0; i < flats; ++i)
  {
    const Vec3 corner(outer_mm * std::cos((i + 0.5) * part), outer_mm * std::sin((i + 0.5) * part), 0.0);
    body.mesh.vertices_W.push_back(foot + corner);
    body.mesh.vertices_W.push_back(foot + corner + Vec3(0, 0, height_mm));
    const auto a = static_cast<std::uint32_t>(2 * i), b = static_cast<std::uint32_t>(2 * ((i + 1) % flats));
    body.mesh.triangles.push_back({ a, b, b + 1 });
    body.mesh.triangles.push_back({ a, b + 1, a + 1 });
  }
  body.distance_mm = [=](const Vec3& p)
  {
    const double round = (p - foot).head<2>().norm() - inner_mm; // the flats are off by the square of a small angle
    return std::max({ round, foot.z() - p.z(), p.z() - foot.z() - height_mm });
  };
  return body;
}

/// The least of a function of one number between two, that has one least there: by golden sections.
double least(const std::function<double(double)>& cost, double low, double high)
{
  constexpr double golden = 0.6180339887498949;
  for (int i = 0; i < 200; ++i)
  {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (cost(a) < cost(b) ? high : low) = cost(a) < cost(b) ? b : a;
  }
  return 0.5 * (low + high);
}

double leverOf(const ToolBody& tool)
{
  return makeTool(tool.mesh, Vec3(Vec3::Zero())).value.gyration_u;
}

Pose between(const Pose& from, const Pose& to, double share)
{
  return { from.p + share * (to.p - from.p), turnBy(share * turnFromTo(from.q, to.q)) * from.q };
}

void lead(ToolScene& scene, const Pose& to_W, int updates)
{
  for (int i = 1; i <= updates + rest; ++i)
  {
    scene.hand_W.push_back(between(scene.start_W, to_W, std::min(1.0, static_cast<double>(i) / updates)));
  }
}

/// Nearest pose of a cube that is pressed by 1 mm and tipped by 10 degrees: at an angle the centre is at the hand's
/// height or, if that is lower, where its lowest edge touches.
ToolScene tippedCube()
{
  constexpr double half = 20.0, deep = 1.0, tip = 10.0 * degree_rad;
  ToolScene scene{ "cube", box(Vec3::Constant(-half), Vec3::Constant(half)), box({ -60, -60, -20 }, { 60, 60, 0 }), 1.0,
    { Vec3(0, 0, half + 2.0), Quat::Identity() }, {}, {}, 0.01 };
  scene.lever_mm = leverOf(scene.tool_B);
  const auto height = [](double t) { return half * (std::cos(t) + std::sin(t)); };
  const auto cost = [&](double t)
  { return std::pow(std::max(height(t) - half + deep, 0.0), 2) + std::pow(scene.lever_mm * (t - tip), 2); };
  const double tilt = least(cost, 0.0, tip);
  scene.truth_W = { Vec3(0, 0, std::max(height(tilt), half - deep)), turnBy(Vec3(0, tilt, 0)) };
  lead(scene, { Vec3(0, 0, half - deep), turnBy(Vec3(0, tip, 0)) }, 50);
  return scene;
}

/// The hand ends within the clearance, so that the peg can be where it is; on its path it wobbles, as hands do.
ToolScene peg()
{
  constexpr double half = 10.0, clearance = 0.1;
  ToolScene scene{ "peg", box({ -half, -10, -30 }, { half, 10, 30 }),
    together(box({ -40, -30, -40 }, { -half - 0.5 * clearance, 30, 0 }),
      box({ half + 0.5 * clearance, -30, -40 }, { 40, 30, 0 })),
    1.0, { Vec3(0, 0, 31), Quat::Identity() }, {}, { Vec3(0.02, 0, 10), Quat::Identity() }, 0.001 };
  scene.lever_mm = leverOf(scene.tool_B);
  lead(scene, scene.truth_W, 100);
  for (int i = 0; i < 100; ++i)
  {
    Pose& hand = scene.hand_W[static_cast<std::size_t>(i)];
    hand.p.x() += 0.3 * std::sin(0.1 * std::numbers::pi * i);
    hand.q = turnBy(Vec3(0, 0.5 * degree_rad * std::sin(0.16 * std::numbers::pi * i), 0));
  }
  return scene;
}

/// A bar of 200 x 1 x 1 mm is turned by 90 degrees in 50 ms about its middle, at a post of 1 mm 80 mm away, and 20
/// degrees beyond. Of an angle before the post the bar's middle stays; beyond, its side lies against the post.
ToolScene swungBar()
{
  constexpr double arm = 80.0, inner = 0.5, half = 0.5, beyond = 20.0 * degree_rad;
  constexpr int flats = 64;
  ToolScene scene{ "bar", box({ -100, -half, -half }, { 100, half, half }), prism({ arm, 0, -15 }, inner, flats, 30.0),
    1.0, { Vec3::Zero(), turnBy(Vec3(0, 0, beyond - 90.0 * degree_rad)) }, {}, {}, 0.01 };
  scene.lever_mm = leverOf(scene.tool_B);
  const auto reach = [&](const Vec3& n)
  {
    double most = 0.0; // of the post against the bar's side
    for (const Vec3& v : scene.scene_W.mesh.vertices_W)
    {
      most = std::max(most, -n.dot(v - Vec3(arm, 0, v.z())));
    }
    return most;
  };
  const auto normal = [](double t) { return Vec3(-std::sin(t), std::cos(t), 0); };
  const auto way = [&](double t) { return std::min(0.0, arm * normal(t).x() - reach(normal(t)) - half); };
  const double angle =
    least([&](double t) { return std::pow(way(t), 2) + std::pow(scene.lever_mm * (beyond - t), 2); }, -0.1, beyond);
  scene.truth_W = { way(angle) * normal(angle), turnBy(Vec3(0, 0, angle)) };
  lead(scene, { Vec3::Zero(), turnBy(Vec3(0, 0, beyond)) }, 50);
  return scene;
}

constexpr test::ThreadSize screwSize{ 5.0, 2.0, 16.0 };
constexpr double slack_mm = 0.2;

ToolScene nut(const std::string& name)
{
  const test::ThreadSize bore{ screwSize.radius_u + slack_mm, screwSize.pitch_u, 5.0 };
  ToolScene scene{ name, { test::threadMesh(bore, 64), [=](const Vec3& p) { return test::distanceToNut(bore, p); } },
    { test::threadMesh(screwSize, 64), [](const Vec3& p) { return test::distanceToScrew(screwSize, p); } }, 1.0, {}, {},
    {}, 0.05 };
  scene.lever_mm = leverOf(scene.tool_B);
  return scene;
}

ToolScene turnedNut()
{
  ToolScene scene = nut("nut turned");
  constexpr double turn = 1.5;
  scene.truth_W = { Vec3(0, 0, screwSize.pitch_u * turn / (2.0 * std::numbers::pi)), turnBy(Vec3(0, 0, turn)) };
  scene.near_mm = 0.001;
  lead(scene, scene.truth_W, 100);
  return scene;
}

/// Pulled without a turn it comes along the axis by its slack, for flanks of 45 degrees give as much in that direction
/// as along the radius. True flanks would then turn it, (z - slack) p / (p^2 + L^2) with p = pitch / 2 pi, and lead it
/// on by p times that; those of 64 corners a turn lock before. Places between the two are accepted.
ToolScene pulledNut()
{
  ToolScene scene = nut("nut pulled");
  constexpr double pull = 1.5, lead_mm = screwSize.pitch_u / (2.0 * std::numbers::pi);
  const double turn = (pull - slack_mm) * lead_mm / (lead_mm * lead_mm + scene.lever_mm * scene.lever_mm);
  scene.truth_W = { Vec3(0, 0, slack_mm + 0.5 * lead_mm * turn), Quat::Identity() };
  scene.near_mm = 0.5 * lead_mm * turn + 0.001;
  scene.along_W = Vec3::UnitZ();
  lead(scene, { Vec3(0, 0, pull), Quat::Identity() }, 50);
  return scene;
}

} // namespace

Vec3 outwards(const ToolBody& body, const Vec3& p)
{
  constexpr double h = 1e-6;
  Vec3 slope;
  for (int i = 0; i < 3; ++i)
  {
    const Vec3 d = h * Vec3::Unit(i);
    slope[i] = body.distance_mm(p + d) - body.distance_mm(p - d);
  }
  const double length = slope.norm();
  return length > 0.0 ? Vec3(slope / length) : Vec3(Vec3::UnitZ());
}

std::vector<ToolScene> toolScenes()
{
  return { tippedCube(), peg(), swungBar(), turnedNut(), pulledNut() };
}

} // namespace palpate::lab
