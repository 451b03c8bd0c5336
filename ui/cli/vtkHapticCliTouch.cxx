// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliCommands.h"

#include <algorithm>
#include <iostream>

#include "haptics/field/Smoothing.h"
#include "haptics/session/path/PathTouch.h"
#include "haptics/session/scene/TouchedData.h"
#include "haptics/session/settings/SessionSettings.h"
#include "vtkHapticCliOutput.h"
#include "vtkHapticCliPath.h"
#include "vtkHapticCliPlane.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticCliScene.h"
#include "vtkHapticCliSoft.h"
#include "vtkHapticCliTicks.h"
#include "vtkHapticReaders.h"

namespace
{
constexpr double OnlyTickSeconds = 1e-3; // of a path of one row, which has no difference of times

/// The path is given in the scene, so device frame and scene are one and a metre is a unit; the scale enters through
/// the stiffness alone. Dividing the path by the scale and multiplying it again would move the hand by its rounding.
palpate::HapticParameters ParametersOf(const vtkHapticCliTouchOptions& options)
{
  palpate::HapticParameters parameters;
  options.Settings.SetFields(parameters);
  parameters.stiffness_N_per_m /= parameters.map.scale_u_per_m;
  parameters.map = {};
  parameters.contact.friction = options.Settings.Friction();
  vtkHapticCliSetField(options.Field, options.Settings, options.Iso, parameters.field);
  if (const std::string problem = parameters.validate(); !problem.empty())
  {
    throw vtkHapticCliProblem("--stiffness, --scale: " + problem);
  }
  return parameters;
}

/// Ticks that did less than an exact contact, for a person to know.
struct Shortfalls
{
  int Seated = 0;
  int Incomplete = 0;

  void Count(const palpate::HapticState& state)
  {
    this->Seated += state.fault == palpate::Fault::Seated ? 1 : 0;
    this->Incomplete += state.capped || state.overBudget || state.infeasible ? 1 : 0;
  }

  void Tell() const
  {
    if (this->Seated > 0)
    {
      std::cerr << "palpate: in " << this->Seated << " ticks the ball overlapped a surface with no free place within "
                << "its radius, and no force was given; start the path away from the surface\n";
    }
    if (this->Incomplete > 0)
    {
      std::cerr << "palpate: in " << this->Incomplete << " ticks the ball moved only as far as was proven free\n";
    }
  }
};

/// A ball that is too large is safe and may lag: that is the person's choice.
double ChooseRadius_u(const palpate::Scene& scene, const palpate::ContactPlan& plan, bool keepLimit)
{
  const palpate::ChosenBall ball = palpate::chooseBall(scene, plan, keepLimit);
  if (!ball.limit.kept())
  {
    std::cerr << "palpate: --radius: " << ball.limit.sentence() << "; "
              << (keepLimit ? "the ball is so large instead" : "--limit-radius makes the ball so large instead")
              << '\n';
  }
  return ball.plan.radius_u;
}

void TellOfCoupling(const vtkHapticCliTouchOptions& options)
{
  const vtkHapticTransfer& data = options.Materials.Stiffness;
  const double coupling_N_per_m = options.Settings.Number("Stiffness");
  if (!data.Array.empty() && std::max(data.FeltRange[0], data.FeltRange[1]) > coupling_N_per_m)
  {
    std::cerr << "palpate: --stiffness-to: at most " << coupling_N_per_m
              << " N/m is felt, the coupling's own (--stiffness)\n";
  }
}

void Render(const std::vector<vtkHapticCliPathRow>& path, palpate::PathTouch& touch, vtkHapticCliOutput& output)
{
  vtkHapticCliStopwatch stopwatch;
  Shortfalls shortfalls;
  for (const vtkHapticCliPathRow& row : path)
  {
    stopwatch.Start();
    const palpate::HapticState state = touch.next(row.Time_s, row.Pose_W);
    const double cost_us = stopwatch.Cost_us();
    shortfalls.Count(state);
    vtkHapticCliWriteTick(output, row.Time_s, state, cost_us);
  }
  shortfalls.Tell();
}

void TellOfField(const palpate::PathTouch& touch, const palpate::HapticParameters& parameters)
{
  const palpate::MadeBrick& made = touch.madeBrick();
  if (const std::string lattice = touch.latticeSentence(); !lattice.empty())
  {
    std::cerr << "palpate: --field: " << lattice << '\n';
  }
  if (const std::string detent = touch.detentSentence(); !detent.empty())
  {
    std::cerr << "palpate: --strength: " << detent << '\n';
  }
  if (const std::string point = palpate::pointSentence(parameters.field, parameters.contact.radius_u); !point.empty())
  {
    std::cerr << "palpate: --radius: " << point << '\n';
  }
  const bool inCells = made.brick && made.brick->cells();
  if (made.smoothness.noise > palpate::trappingNoise && !inCells)
  {
    std::cerr << "palpate: --smoothing: the field's noise of " << made.smoothness.noise
              << " of a spacing traps a hand; it was smoothed once, --smoothing 0 leaves it as it is\n";
  }
}

/// Options of surfaces that nothing comes of are refused rather than ignored.
void CheckSurfaceOptions(const vtkHapticCliTouchOptions& options, const std::vector<std::string>& surfaces, bool wall)
{
  const bool image = std::ranges::any_of(surfaces, vtkHapticIsImageFile);
  if (options.Iso && options.Field.Any() && !wall && !image)
  {
    throw vtkHapticCliProblem("--iso: no --mode is isosurface, and no other image is touched; leave it out");
  }
  if (surfaces.empty() && options.Settings.Number("Radius") > 0.0)
  {
    throw vtkHapticCliProblem("--radius: a field is felt by a point, and no surface is touched; leave it out");
  }
  for (const char* setting : { "ForceShading", "LineRadius", "LimitRadius" })
  {
    if (surfaces.empty() && options.Settings.IsGiven(setting))
    {
      throw vtkHapticCliProblem("--" + std::string(palpate::sessionSetting(setting).at.option) +
                                ": it says how surfaces are touched, and a field alone is; leave it out");
    }
  }
  if (surfaces.empty() && !options.Materials.Empty())
  {
    throw vtkHapticCliProblem("arrays of stiffness, friction and texture are those of surfaces, and a field alone is "
                              "touched; leave them out");
  }
}

/// The surfaces among the files; null where there is a field alone.
std::shared_ptr<const palpate::Scene> SceneOf(const vtkHapticCliTouchOptions& options,
  const std::vector<std::string>& surfaces, palpate::HapticParameters& parameters)
{
  if (surfaces.empty())
  {
    return nullptr;
  }
  const bool image = std::ranges::any_of(surfaces, vtkHapticIsImageFile);
  const std::optional<double> iso = options.Field.Any() && !image ? std::nullopt : options.Iso;
  std::shared_ptr<const palpate::Scene> scene =
    options.TwoD ? vtkHapticCliBuildPlane(surfaces, parameters.contact.radius_u)
                 : vtkHapticCliBuildScene(surfaces, iso, options.Materials, options.Settings.Number("Scale"),
                     options.Settings.Number("LineRadius"));
  TellOfCoupling(options);
  parameters.contact.radius_u =
    ChooseRadius_u(*scene, parameters.contact, options.Settings.Number("LimitRadius") != 0.0);
  return scene;
}
} // namespace

int vtkHapticCliTouch(const vtkHapticCliTouchOptions& options)
{
  if (!options.Tool.File.empty())
  {
    return vtkHapticCliTouchWithTool(options);
  }
  palpate::HapticParameters parameters = ParametersOf(options);
  const std::vector<vtkHapticCliPathRow> path = vtkHapticCliReadPath(options.Path);
  if (options.TwoD)
  {
    vtkHapticCliCheckPlanePath(options.Path, path);
  }
  std::vector<std::string> surfaces = options.Files;
  const auto field = vtkHapticCliTakeField(options.Field, options.Settings, parameters.field, surfaces);
  if (options.Field.Snap.empty())
  {
    surfaces.insert(surfaces.end(), options.Field.Surfaces.begin(), options.Field.Surfaces.end());
  }
  if (!options.Soft.Young_Pa)
  {
    CheckSurfaceOptions(options, surfaces, parameters.field.isosurface);
  }
  auto body = vtkHapticCliBodyOf(options);
  if (body)
  {
    surfaces.erase(surfaces.begin());
  }
  const auto scene = SceneOf(options, surfaces, parameters);
  palpate::PathTouch touch(scene, parameters, path.size() > 1 ? path[1].Time_s - path[0].Time_s : OnlyTickSeconds);
  touch.feel(field);
  if (body)
  {
    touch.press(std::move(body), options.Soft.LowRate_Hz());
  }
  std::vector<std::string> inputs = options.Files;
  inputs.insert(inputs.end(), options.Field.Surfaces.begin(), options.Field.Surfaces.end());
  inputs.insert(inputs.end(), { options.Field.OtherFile, options.Path });
  vtkHapticCliOutput output(options.Output, inputs);
  vtkHapticCliWriteHeader(output);
  Render(path, touch, output);
  if (const std::string nothing = touch.whyNothingOfField(); !nothing.empty())
  {
    throw vtkHapticCliProblem("nothing was felt of the field: " + nothing);
  }
  TellOfField(touch, parameters);
  if (touch.body() != nullptr && touch.body()->wentThroughItself())
  {
    std::cerr << "palpate: " << options.Files.front() << ": " << palpate::throughItselfText << '\n';
  }
  output.Commit();
  return 0;
}
