// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "haptics/labyrinth/Labyrinth.h"

namespace palpate::lab
{

/// A maze of data/gallery by the name of its file, without ".vtp". Nothing where this was built without VTK. Throws
/// std::runtime_error for a file that cannot be read.
[[nodiscard]] std::optional<Labyrinth> galleryMaze(const std::string& name);

} // namespace palpate::lab
