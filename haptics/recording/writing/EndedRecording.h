// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace palpate
{

/// A recording that goes on no more.
struct EndedRecording
{
  std::string file;    ///< "": nothing of it is left
  std::string problem; ///< "": it is whole
};

} // namespace palpate
