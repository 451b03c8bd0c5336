// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/session/path/PathInputs.h"

namespace palpate
{

/// One tick of a path.
struct PathTick
{
  Pose proxy_W;             ///< of the ball, the tool's handle, the held body of a mechanism, a wire's tip [u]
  Wrench wrench_W;          ///< on the hand [N], [N m]
  int contacts = 0;         ///< planes, contacts or constraints that push
  std::vector<double> more; ///< the values of the columns that the kind adds
  double cost_us = 0.0;     ///< see TickCost
};

/// Values that a tool or a mechanism adds to each tick.
struct PathColumn
{
  std::string name; ///< Turn (w x y z), Torque [N m], Angle [degrees], Residual [u], Force of, Phase of, Inside of a
                    ///< constraint; Place of [u], Turn of a loose body; of a wire Pushed [u], Turned [rad], Tip Force,
                    ///< Wall Force [N], Wall Place [u]
  int components = 1;
};

/// Messages for a person, a sentence each, with settings by their names in braces.
struct PathReport
{
  std::string refusal;              ///< why nothing can be touched; "": the path can be followed
  std::vector<std::string> notes;   ///< of settings and of ticks that did less, or something else, than was asked for
  std::vector<std::string> remarks; ///< how the data were read, and which constraints of a mechanism changed when
  std::string unfelt;               ///< why nothing was felt of the field; "": something was, or there is none
};

/// Faces as they are, curves as the settings say: tubes of LineRadius, or walls across the plane z = 0. The stiffness
/// of their fields is per scene unit. None with a refusal.
[[nodiscard]] std::optional<SurfaceInput> sceneInput(
  const PathSurface& surface, const SettingStore& settings, std::string& refusal);

/// The parts that cleaning removed, for each surface that lost any.
[[nodiscard]] std::vector<std::string> cleaningNotes(const std::vector<SurfaceReport>& reports);

class PathKind;

/// The tick along a path, without a device and its limits: of a ball on surfaces and curves, in a field, on a soft
/// body, of a tool on surfaces or on a soft body, of a mechanism. For the filter and the program alike.
class PathRunner
{
public:
  /// Builds the scene; may take seconds.
  explicit PathRunner(PathInputs inputs);
  ~PathRunner();

  [[nodiscard]] const PathReport& report() const noexcept { return this->report_; }
  [[nodiscard]] const std::vector<PathColumn>& columns() const noexcept { return this->columns_; }
  /// The soft body; null: none.
  [[nodiscard]] const BodyMaker* body() const noexcept;

  /// All samples of a path that was not refused, once. `take` receives the number of each sample and its tick. `goes`
  /// is asked now and then with the share that is done; the run ends, and gives false, when `goes` does.
  [[nodiscard]] bool run(const std::function<bool(double)>& goes,
    const std::function<void(std::size_t, const PathSample&, const PathTick&)>& take);

private:
  PathInputs inputs_;
  PathReport report_;
  std::unique_ptr<PathKind> kind_; ///< null where the path is refused
  std::vector<PathColumn> columns_;
};

} // namespace palpate
