// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/recording/writing/EndedRecording.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/LoopReport.h"
#include "haptics/session/mechanism/MechanismChoice.h"
#include "haptics/session/soft/SoftChoice.h"
#include "haptics/session/tool/ToolChoice.h"
#include "haptics/tool/worker/ToolFollower.h"

namespace palpate
{

/// What the hand is to hold and to touch, and the last reports.
struct HapticSession::Kept
{
  ToolChoice tool;
  SoftChoice soft;
  MechanismChoice mechanism;
  LoopReport report;
  ToolReport toolReport;
  std::optional<EndedRecording> recorded; ///< with the last run
};

} // namespace palpate
