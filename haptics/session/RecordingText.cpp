// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/RecordingText.h"

#include <cstdio>

namespace palpate
{

std::string recordingText(const RecordingGlance& glance)
{
  char length[32];
  std::snprintf(length, sizeof length, "%.1f s", glance.length_s);
  if (glance.running)
  {
    return "Recording: " + std::string(length) + " so far.";
  }
  if (glance.wanted)
  {
    return "Recording begins with Touch.";
  }
  if (glance.file.empty())
  {
    return {};
  }
  return std::string(length) + " recorded in " + glance.file + (glance.saved ? "." : ": save it, or replay it.");
}

} // namespace palpate
