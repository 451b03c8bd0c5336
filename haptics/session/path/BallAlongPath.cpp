// SPDX-License-Identifier: GPL-3.0-or-later
#include <sstream>
#include <utility>

#include "haptics/field/Smoothing.h"
#include "haptics/session/path/PathKind.h"
#include "haptics/session/path/PathTouch.h"
#include "haptics/session/scene/TouchedData.h"

namespace palpate
{
namespace
{

constexpr double onlyTick_s = 1e-3; // of a path of one sample, which has no difference of times

/// A setting that would be lost.
std::string lostBesideBall(const PathInputs& inputs)
{
  const SettingStore& settings = inputs.settings;
  const bool walls = areWalls(settings), alone = inputs.surfaces.empty() && !inputs.body;
  std::string lost;
  if (alone)
  {
    lost = setAmong(settings, { "Radius", "LimitRadius", "LineRadius", "ForceShading", "StiffnessArray",
                                "FrictionArray", "TextureArray", "LinesAsWalls" });
    return lost.empty() ? "" : lost + " applies to surfaces, but only a field is touched; omit this option";
  }
  if (inputs.body || walls)
  {
    lost = setAmong(settings, { "LineRadius", "ForceShading", "StiffnessArray", "FrictionArray", "TextureArray" });
    lost = lost.empty() && walls && inputs.body    ? "{LinesAsWalls}"
           : lost.empty() && walls && inputs.field ? "{FieldArray}"
                                                   : lost;
  }
  const std::string felt =
    inputs.body ? " cannot be combined with a soft body" : " cannot be combined with lines in a plane";
  return lost.empty() ? ""
                      : lost + felt + "; omit one of the two" + (inputs.body ? "" : ", this one or {LinesAsWalls}");
}

/// A ball that is too large is safe and may lag: that is the person's choice.
double chosenRadius_u(const PathInputs& inputs, const Scene& scene, const ContactPlan& plan, PathReport& report)
{
  const bool keepLimit = inputs.settings.isOn("LimitRadius");
  const ChosenBall ball = chooseBall(scene, plan, keepLimit);
  if (!ball.limit.kept())
  {
    report.notes.push_back("{Radius}: " + ball.limit.sentence() + "; " +
                           (keepLimit ? "the radius is reduced to this value"
                                      : "use {LimitRadius} to reduce the radius to this value automatically"));
  }
  return ball.plan.radius_u;
}

/// A ball on surfaces, in a field or both, or on a soft body.
class BallAlongPath final : public PathKind
{
public:
  BallAlongPath(const PathInputs& inputs, std::shared_ptr<const Scene> scene, const HapticParameters& parameters)
    : parameters_(parameters), bodyName_(inputs.body ? inputs.body->name : ""),
      touch_(std::move(scene), parameters,
        inputs.path.size() > 1 ? inputs.path[1].time_s - inputs.path[0].time_s : onlyTick_s)
  {
    this->touch_.feel(inputs.field ? inputs.field->source : nullptr);
  }

  void press(std::unique_ptr<BodyMaker> body, double rate_Hz) { this->touch_.press(std::move(body), rate_Hz); }

  [[nodiscard]] const BodyMaker* body() const override { return this->touch_.body(); }

  void next(const PathSample& sample, PathTick& tick) override
  {
    const HapticState state = this->touch_.next(sample.time_s, { sample.hand_W.p, Quat::Identity() });
    tick.proxy_W = state.proxy_W;
    tick.wrench_W.force = state.force_W;
    tick.contacts = state.contacts;
    this->seated_ += state.fault == Fault::PlacementFailed ? 1 : 0;
    this->incomplete_ += state.capped || state.overBudget || state.infeasible ? 1 : 0;
    if (state.fault != Fault::PlacementFailed && state.fault != Fault::None && this->fault_ == Fault::None)
    {
      this->fault_ = state.fault;
    }
  }

  void finish(PathReport& report) const override
  {
    noteTicks(report, this->seated_,
      "the proxy sphere overlapped a surface without a free position within its radius, so that there was no force; "
      "start the path away from the surface");
    noteTicks(report, this->incomplete_, "the proxy sphere moved only as far as was proven free");
    if (this->fault_ != Fault::None)
    {
      report.notes.push_back(std::string("without force from some point on: ") + describe(this->fault_));
    }
    report.unfelt = this->touch_.whyNothingOfField();
    this->noteField(report);
    if (this->touch_.body() != nullptr && this->touch_.body()->wentThroughItself())
    {
      report.notes.push_back(this->bodyName_ + ": " + throughItselfText);
    }
  }

private:
  void noteField(PathReport& report) const
  {
    const auto note = [&report](const char* setting, const std::string& sentence)
    {
      if (!sentence.empty())
      {
        report.notes.push_back(setting + sentence);
      }
    };
    note("{FieldArray}: ", this->touch_.latticeText());
    note("{FieldDetent}: ", this->touch_.detentText());
    note("{Radius}: ", pointText(this->parameters_.field, this->parameters_.contact.radius_u));
    const MadeFieldBlock& made = this->touch_.madeFieldBlock();
    const bool inCells = made.brick && made.brick->cells();
    if (made.smoothness.noise > trappingNoise && !inCells)
    {
      std::ostringstream text;
      text << "{FieldSmoothing}: noise of " << made.smoothness.noise
           << " of a spacing would trap a hand: the field was smoothed once; {FieldSmoothing} 0 switches this off";
      report.notes.push_back(text.str());
    }
  }

  HapticParameters parameters_;
  std::string bodyName_;
  PathTouch touch_;
  int seated_ = 0;     ///< ticks
  int incomplete_ = 0; ///< ticks
  Fault fault_ = Fault::None;
};

std::unique_ptr<BodyMaker> makeBody(const PathBody& body, PathReport& report)
{
  std::string problem;
  auto maker = BodyMaker::make(*body.input, body.name, 0, problem);
  const std::string left = maker ? maker->checked().report.summary() : "";
  if (!left.empty())
  {
    report.notes.push_back(body.name + ": " + left);
  }
  report.refusal = maker ? "" : body.name + ": cannot be a soft body: " + problem;
  return maker;
}

} // namespace

std::unique_ptr<PathKind> ballAlongPath(const PathInputs& inputs, PathReport& report)
{
  HapticParameters parameters = pathParameters(inputs.settings);
  parameters.field.noSpeed = inputs.field ? inputs.field->noSpeed : 0.0;
  const std::string problem = inputs.field ? levelProblem(parameters.field, inputs.field->ends) : "";
  report.refusal = problem.empty() ? lostBesideBall(inputs) : inputs.field->name + ": " + problem;
  auto body = report.refusal.empty() && inputs.body ? makeBody(*inputs.body, report) : nullptr;
  const auto scene = report.refusal.empty() && !inputs.surfaces.empty() ? pathScene(inputs, report) : nullptr;
  if (!report.refusal.empty())
  {
    return nullptr;
  }
  if (scene)
  {
    parameters.contact.radius_u = chosenRadius_u(inputs, *scene, parameters.contact, report);
  }
  const std::string missing = inputs.field ? levelText(parameters.field, inputs.field->ends) : "";
  if (!missing.empty())
  {
    report.notes.push_back(inputs.field->name + ": " + missing);
  }
  auto ball = std::make_unique<BallAlongPath>(inputs, scene, parameters);
  if (body)
  {
    ball->press(std::move(body), inputs.settings.number("SoftRate"));
  }
  return ball;
}

} // namespace palpate
