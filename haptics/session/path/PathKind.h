// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "haptics/session/path/PathRunner.h"

namespace palpate
{

class MechanismTouch;

/// The object that moves along a path. Nothing is given to next() twice, and finish() comes after the last sample.
class PathKind
{
public:
  PathKind() = default;
  PathKind(const PathKind&) = delete;
  PathKind& operator=(const PathKind&) = delete;
  virtual ~PathKind() = default;

  [[nodiscard]] virtual std::vector<PathColumn> columns() const { return {}; }
  [[nodiscard]] virtual const BodyMaker* body() const { return nullptr; }
  virtual void next(const PathSample& sample, PathTick& tick) = 0;
  virtual void finish(PathReport& report) const = 0;
};

/// Each gives null with a refusal in the report.
[[nodiscard]] std::unique_ptr<PathKind> ballAlongPath(const PathInputs& inputs, PathReport& report);
[[nodiscard]] std::unique_ptr<PathKind> toolAlongPath(const PathInputs& inputs, PathReport& report);
/// Of a tool on a soft body, or of a tool or a ball among loose bodies.
[[nodiscard]] std::unique_ptr<PathKind> handAmongBodiesAlongPath(const PathInputs& inputs, PathReport& report);
[[nodiscard]] std::unique_ptr<PathKind> mechanismAlongPath(const PathInputs& inputs, PathReport& report);
/// The columns of a mechanism that is a wire.
[[nodiscard]] std::unique_ptr<PathKind> wireAlongPath(std::unique_ptr<MechanismTouch> touch);

/// The surfaces and curves as one scene, with the parts that cleaning left out in the notes; null with a refusal.
[[nodiscard]] std::shared_ptr<const Scene> pathScene(const PathInputs& inputs, PathReport& report);

/// "In N ticks ...", as a note, where there are any.
void noteTicks(PathReport& report, int ticks, const std::string& what);

} // namespace palpate
