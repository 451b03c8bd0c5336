// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// nlohmann::json as VTK has it. VTK's headers rename their copy of the library by a macro since 9.3, so that another
// copy cannot be included beside them.
#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)
