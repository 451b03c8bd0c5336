// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "haptics/recording/inputs/Scenes.h"

namespace palpate
{

/// The scenes of a recording, built again.
class SceneLibrary
{
public:
  static constexpr const char* missing = "the scenes are missing or do not match: name their files with --scene";

  /// `given`: scenes that the recording left out, found by their meshes' hash.
  SceneLibrary(
    const input::Scenes::Recorded& recorded, const std::vector<std::shared_ptr<const Scene>>& given, unsigned workers);

  /// Null where it is not there.
  [[nodiscard]] std::shared_ptr<const Scene> find(std::uint64_t contentHash, std::uint64_t revision) const;

private:
  void addMoving(const RecordedMotion& recorded);

  std::map<std::uint64_t, std::shared_ptr<const Scene>> scenes_;
};

} // namespace palpate
