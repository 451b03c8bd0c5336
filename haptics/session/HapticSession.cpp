// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/HapticSession.h"

#include <optional>
#include <utility>

#include "haptics/session/DeviceAdaptation.h"
#include "haptics/session/SessionInputs.h"
#include "haptics/session/SessionRun.h"
#include "haptics/session/SessionWorkers.h"

namespace palpate
{
namespace
{

constexpr double shortestPeriod_s = 1e-4; // ten times the usual rate

} // namespace

HapticSession::HapticSession() : kept_(std::make_unique<Kept>()), chosen_(std::make_unique<Chosen>()) {}

HapticSession::~HapticSession()
{
  this->stop();
}

bool HapticSession::running() const noexcept
{
  return this->run_ != nullptr;
}

HapticDevice* HapticSession::device() noexcept
{
  return this->run_ ? this->run_->device.get() : nullptr;
}

ServoLinks* HapticSession::links() noexcept
{
  return this->run_ ? &this->run_->links : nullptr;
}

Recordings& HapticSession::recordings() noexcept
{
  return *this->run_->recordings;
}

std::string HapticSession::start(std::unique_ptr<HapticDevice> device, const SessionOptions& options)
{
  this->stop();
  if (!(options.period_s >= shortestPeriod_s))
  {
    return "the period [s] must be at least 0.0001";
  }
  if (const std::string problem = device->open(); !problem.empty())
  {
    return problem;
  }
  auto run = std::make_unique<Run>();
  run->device = std::move(device);
  run->virtualTime = options.virtualTime;
  run->period_s = options.period_s;
  this->adapt(*run, true);
  run->pace(static_cast<std::int64_t>(options.period_s * 1e9 + 0.5));
  run->recordings.emplace(run->links.recorder, options.virtualTime);
  if (!options.recordFile.empty())
  {
    const std::string& name = run->device->info().name;
    if (std::string refused = run->recordings->begin(options.recordFile, name, this->kept_->inputs); !refused.empty())
    {
      run->device->close();
      return refused;
    }
  }
  run->links.parameters.write({ this->version_, run->adapted });
  TickInputs::forEach(
    [&]<input::ComesFromOwner K>(std::type_identity<K>) { K::buffer(run->links).publish(this->inputNow<K>()); });
  run->workers = std::make_unique<SessionWorkers>(run->links, run->virtualTime);
  this->orderWork(*run);
  if (run->virtualTime)
  {
    run->workers->step(run->virtual_s);
  }
  run->loop.emplace(*run->device, *run->timer, run->links, run->clock, options.period_s);
  this->run_ = std::move(run);
  this->lastState_ = HapticState{};
  this->kept_->report = LoopReport{};
  if (this->recording())
  {
    this->storePublished(); // from the first snapshot on
  }
  if (options.engage)
  {
    this->engage();
  }
  if (!options.virtualTime)
  {
    this->run_->thread = RealtimeThread(
      [&r = *this->run_](const SchedulingReport& report)
      {
        const std::lock_guard lock(r.schedulingMutex);
        r.scheduling = report;
      },
      [&r = *this->run_](const std::stop_token& stop) { r.loop->run(stop); }, options.brokers);
  }
  return {};
}

std::string HapticSession::stop()
{
  if (!this->run_)
  {
    return {};
  }
  if (this->run_->virtualTime)
  {
    this->run_->loop->finish();
  }
  else
  {
    this->release();
    this->run_->thread.join();
  }
  this->storePublished();
  this->lastState_ = this->run_->links.state.read();
  this->kept_->report = this->run_->links.report.read();
  this->lastState_.engage = EngageState::Safe;
  this->lastState_.force_D = this->lastState_.force_W = Vec3::Zero();
  this->run_->device->close();
  this->kept_->recorded = this->run_->recordings->finish();
  std::string problem = this->kept_->recorded ? this->kept_->recorded->problem : std::string();
  this->run_.reset();
  return problem;
}

std::string HapticSession::setParameters(const HapticParameters& parameters, const std::optional<Vec3>& comesFrom_W)
{
  std::string problem = parameters.validate();
  if (problem.empty())
  {
    const bool otherMap = !isSame(parameters.map, this->parameters_.map);
    this->parameters_ = parameters;
    this->pairTool();
    ++this->version_;
    if (this->run_)
    {
      if (otherMap || comesFrom_W) // where it came from before was a place for the hand of before
      {
        this->run_->leadFrom(this->scene().get(), comesFrom_W);
      }
      this->adapt(*this->run_, false);
      this->run_->links.parameters.write({ this->version_, this->run_->adapted });
      this->orderWork(*this->run_);
    }
  }
  return problem;
}

StabilityLimits HapticSession::limits() const
{
  return this->run_ ? this->run_->limits : StabilityLimits{};
}

std::string HapticSession::limitsText() const
{
  return this->run_ ? describe(this->run_->limits, this->run_->device->info(),
                        loopSettings(this->parameters_, this->run_->period_s, this->characteristic_u()))
                    : std::string();
}

void HapticSession::setScene(std::shared_ptr<const Scene> scene, const std::optional<Vec3>& comesFrom_W)
{
  if (this->run_ && scene && comesFrom_W) // said before the scene is there
  {
    Run& r = *this->run_;
    r.leadFrom(scene.get(), comesFrom_W);
    r.adapted.ballLead = r.lead;
    r.links.parameters.write({ ++this->version_, r.adapted });
  }
  const Holding before = this->holding();
  this->setInput<input::Scenes>(std::move(scene));
  this->pairTool();
  this->followChoice(before != this->holding());
}

const std::shared_ptr<const Scene>& HapticSession::scene() const noexcept
{
  return this->inputNow<input::Scenes>();
}

void HapticSession::setFieldBlock(std::shared_ptr<const FieldBlock> brick)
{
  this->setInput<input::FieldBlocks>(std::move(brick));
}

const std::shared_ptr<const FieldBlock>& HapticSession::brick() const noexcept
{
  return this->inputNow<input::FieldBlocks>();
}

void HapticSession::breakConstraint(std::uint32_t law)
{
  this->push(EventKind::BreakConstraint, law);
}

/// Hands a recording that begins the values that the servo may still use. `again`: one after another.
void HapticSession::storePublished(bool again)
{
  TickInputs::forEach(
    [&]<input::ComesFromWorker K>(std::type_identity<K>)
    {
      for (const auto& value : K::buffer(this->run_->links).published(this->recording(), again))
      {
        this->run_->recordings->store<K>(value);
      }
    });
}

void HapticSession::push(EventKind kind, std::uint64_t value)
{
  if (this->run_)
  {
    this->run_->links.events.tryPush({ 0, kind, value });
  }
}

void HapticSession::engage()
{
  this->push(EventKind::Engage);
}

void HapticSession::release()
{
  this->push(EventKind::Release);
}

void HapticSession::play()
{
  this->push(EventKind::Play);
}

void HapticSession::mark()
{
  this->push(EventKind::Mark);
}

int HapticSession::step(int ticks)
{
  int done = 0;
  while (this->run_ && this->run_->virtualTime && done < ticks && this->run_->loop->tick())
  {
    ++done;
    this->run_->virtual_s += this->run_->period_s;
    this->run_->workers->step(this->run_->virtual_s);
    this->storePublished();
    this->run_->recordings->pump();
  }
  if (done > 0)
  {
    this->run_->loop->publishReport();
  }
  return done;
}

std::string HapticSession::record(const std::string& file)
{
  if (!this->run_)
  {
    return "there is no touch to record: start touching first";
  }
  this->storePublished();
  std::string problem = this->run_->recordings->begin(file, this->run_->device->info().name, this->kept_->inputs);
  this->storePublished(true);
  return problem;
}

void HapticSession::endRecording()
{
  if (this->run_)
  {
    this->storePublished();
    this->run_->recordings->end();
    if (this->run_->virtualTime)
    {
      this->run_->loop->followRecorder();
      this->run_->recordings->pump();
    }
  }
}

bool HapticSession::recording() const noexcept
{
  return this->run_ && this->run_->recordings->running();
}

std::optional<EndedRecording> HapticSession::takeRecorded()
{
  if (!this->run_)
  {
    return std::exchange(this->kept_->recorded, std::nullopt);
  }
  this->storePublished();
  return this->run_->recordings->takeEnded();
}

const HapticState& HapticSession::state()
{
  if (this->run_)
  {
    this->storePublished();
    TickInputs::forEach(
      [this]<input::ComesFromOwner K>(std::type_identity<K>) { K::buffer(this->run_->links).collect(); });
    this->lastState_ = this->run_->links.state.read();
  }
  return this->lastState_;
}

const LoopReport& HapticSession::report()
{
  if (this->run_)
  {
    this->kept_->report = this->run_->links.report.read();
  }
  return this->kept_->report;
}

SchedulingReport HapticSession::scheduling() const
{
  if (!this->run_)
  {
    return {};
  }
  const std::lock_guard lock(this->run_->schedulingMutex);
  return this->run_->scheduling;
}

} // namespace palpate
