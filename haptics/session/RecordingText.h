// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace palpate
{

/// Status of recordings, for one line of text.
struct RecordingGlance
{
  bool wanted = false;   ///< the person wants one
  bool running = false;  ///< and it goes on
  double length_s = 0.0; ///< of the one that goes on, else of the last
  std::string file;      ///< the last that is whole; "": none yet
  bool saved = false;    ///< under a name that the person gave
};

/// One line, with the next possible action; "" before anything was recorded or is wanted.
[[nodiscard]] std::string recordingText(const RecordingGlance& glance);

} // namespace palpate
